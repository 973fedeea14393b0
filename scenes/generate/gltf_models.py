# SPDX-License-Identifier: Apache-2.0
"""The gallery's glTF models: one function a file, each about one thing that the format has."""

from math import cos, pi, sin

from gltf import Asset, box, floor, png, quad, sphere, turn

GREY = [0.6, 0.6, 0.6, 1]


def checker(a, b, cells=4, size=32):
    return png(size, size, lambda x, y: a if (x * cells // size + y * cells // size) % 2 == 0 else b)


def camera(a, eye, pitch_deg=0, yfov=0.7, aspect=4 / 3):
    """A node with a camera that looks along -Z from `eye`, turned about X."""
    number = a.add("cameras", type="perspective",
                   perspective={"yfov": yfov, "aspectRatio": round(aspect, 5), "znear": 0.1})
    return a.add("nodes", name="camera", camera=number, translation=list(eye), rotation=turn(0, pitch_deg))


def sun(a, lux=3.0, pitch_deg=-50, yaw=None):
    inner = a.add("nodes", name="sun", extensions=a.light("directional", lux), rotation=turn(0, pitch_deg))
    return a.add("nodes", rotation=turn(1, 35), children=[inner])


def box_model():
    """The least: a box without a material, a light or a camera."""
    a = Asset()
    mesh = a.mesh(box(), name="box")
    a.show(a.add("nodes", mesh=mesh))
    return a.text()


def textured():
    """A binary file: a picture looked up without smoothing, turned and repeated by KHR_texture_transform; a mirrored one."""
    a = Asset()
    a.use("KHR_texture_transform")
    arrow = png(8, 8, lambda x, y: (250, 200, 40, 255) if abs(x - 3.5) + abs(y - 5) < 3 or (x in (3, 4) and y < 6)
                else (30, 60 + 20 * x, 60 + 20 * y, 255))
    turned = a.texture(arrow, magFilter=9728)
    turned["extensions"] = {"KHR_texture_transform": {"offset": [0, 1], "rotation": round(pi / 2, 6), "scale": [2, 2]}}
    mirrored = a.texture(arrow, magFilter=9729, wrapS=33648, wrapT=33071)
    left = a.add("nodes", mesh=a.mesh(box(), a.material(turned)), translation=[-0.8, 0, 0], rotation=turn(1, 30))
    right = a.add("nodes", mesh=a.mesh(quad(1.4, 1.4, 3), a.material(mirrored)), translation=[0.8, 0, 0])
    a.show(left, right, camera(a, (0, 1.4, 3.4), -22), sun(a))
    return a.binary()


def spheres():
    """Metals and plastics from polished to rough."""
    a = Asset()
    shape = a.primitive(sphere(0.45, 32, 16))
    nodes = []
    for row, (color, metallic) in enumerate([([1, 0.77, 0.34, 1], 1), ([0.2, 0.5, 0.3, 1], 0)]):
        for i in range(5):
            material = a.material(color, metallic, i / 4)
            mesh = a.add("meshes", primitives=[{**shape, "material": material}])
            nodes.append(a.add("nodes", mesh=mesh, translation=[i - 2, 0.45, -row * 1.1]))
    ground = a.texture(checker((200, 200, 200, 255), (90, 90, 100, 255)))
    nodes.append(a.add("nodes", mesh=a.mesh(floor(8, 4), a.material(ground))))
    a.show(*nodes, camera(a, (0, 2, 4.6), -22), sun(a))
    return a.text()


def alpha():
    """A disc's edge in alpha: ignored, cut, blended; and a pane of half a colour."""
    a = Asset()
    disc = png(32, 32, lambda x, y: (230, 90, 60, max(0, min(255, int(420 - 25 * ((x - 15.5) ** 2 + (y - 15.5) ** 2) ** 0.5)))))
    texture = a.texture(disc, wrapS=33071, wrapT=33071)
    nodes = []
    for i, more in enumerate([{"alphaMode": "OPAQUE"}, {"alphaMode": "MASK", "alphaCutoff": 0.5}, {"alphaMode": "BLEND"}]):
        mesh = a.mesh(quad(0.9, 0.9), a.material(texture, **more))
        nodes.append(a.add("nodes", mesh=mesh, translation=[i * 1.1 - 1.65, 0.6, 0]))
    pane = a.mesh(quad(0.9, 0.9), a.material([0.1, 0.3, 0.9, 0.5], alphaMode="BLEND"))
    nodes.append(a.add("nodes", mesh=pane, translation=[1.65, 0.6, 0]))
    ground = a.texture(checker((220, 220, 210, 255), (110, 110, 100, 255)))
    nodes.append(a.add("nodes", mesh=a.mesh(floor(6, 3), a.material(ground))))
    a.show(*nodes, camera(a, (0, 1.3, 4.4), -10), sun(a))
    return a.text()


def stud(x, y):
    """A texel of a normal map with a stud every 16 texels."""
    dx, dy = (x % 16 - 7.5) / 6, (y % 16 - 7.5) / 6
    reach = dx * dx + dy * dy
    if reach > 1:
        return (128, 128, 255, 255)
    return (int(127.5 + 110 * dx), int(127.5 - 110 * dy), int(127.5 + 127 * (1 - 0.75 * reach) ** 0.5), 255)


def normal_map():
    """Studs that are there in the normals alone, lit from the left by a spot."""
    a = Asset()

    studs = a.texture(png(32, 32, stud))
    wall = a.mesh(quad(3, 2), a.material([0.7, 0.7, 0.75, 1], normalTexture={**studs, "scale": 1}))
    spot = a.light("spot", 40, (1, 0.9, 0.8), spot={"innerConeAngle": 0.3, "outerConeAngle": 0.5})
    lamp = a.add("nodes", name="spot", extensions=spot, translation=[-2.2, 1, 1.6], rotation=[-0.18, -0.45, -0.09, 0.87])
    a.show(a.add("nodes", mesh=wall), lamp, camera(a, (0, 0, 3.4)))
    return a.text()


def lights():
    """A directional, a point and a spot light, each of its own colour; a lamp that shines and an unlit sign."""
    a = Asset()
    a.use("KHR_materials_emissive_strength", "KHR_materials_unlit")
    nodes = [a.add("nodes", mesh=a.mesh(floor(8), a.material(GREY)))]
    block = a.mesh(box(0.6), a.material([0.8, 0.8, 0.8, 1]))
    nodes += [a.add("nodes", mesh=block, translation=[x, 0.3, 0]) for x in (-1.5, 0, 1.5)]
    bulb = a.mesh(sphere(0.08, 12, 6), a.material([0, 0, 0, 1], emissiveFactor=[1, 0.5, 0.2],
                  extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 3}}))
    # Beside its bulb, which would shade it.
    glow = a.add("nodes", name="glow", extensions=a.light("point", 3, (1, 0.5, 0.2)), translation=[0, -0.2, 0])
    nodes.append(a.add("nodes", name="bulb", mesh=bulb, children=[glow], translation=[-1.5, 1.3, 0.6]))
    sign = a.mesh(quad(0.7, 0.4), a.material([0.1, 0.8, 0.9, 1], extensions={"KHR_materials_unlit": {}}))
    nodes.append(a.add("nodes", mesh=sign, translation=[0, 1.2, -0.5]))
    spot = a.light("spot", 25, (0.4, 0.6, 1), spot={"innerConeAngle": 0.2, "outerConeAngle": 0.35})
    nodes.append(a.add("nodes", extensions=spot, translation=[1.5, 2.4, 0.8], rotation=turn(0, -72)))
    nodes.append(sun(a, 0.6))
    a.show(*nodes, camera(a, (0, 2.2, 4.6), -22, aspect=16 / 9))
    return a.text()


def instances():
    """One box, sixty times (EXT_mesh_gpu_instancing)."""
    a = Asset()
    a.use("EXT_mesh_gpu_instancing", required=True)
    count = 60
    places = [(2 * cos(2 * pi * i / count), 0.5 * sin(6 * pi * i / count), 2 * sin(2 * pi * i / count)) for i in range(count)]
    turns = [(0, sin(pi * i / count), 0, cos(pi * i / count)) for i in range(count)]
    sizes = [(1, 1 + 0.5 * cos(6 * pi * i / count), 1) for i in range(count)]
    attributes = {"TRANSLATION": a.accessor(places), "ROTATION": a.accessor(turns), "SCALE": a.accessor(sizes)}
    mesh = a.mesh(box(0.16), a.material([0.9, 0.45, 0.2, 1]))
    a.show(a.add("nodes", mesh=mesh, extensions={"EXT_mesh_gpu_instancing": {"attributes": attributes}}))
    return a.text()


def quantized():
    """A ball of 16-bit positions and 8-bit normals (KHR_mesh_quantization), whose top a sparse accessor lifts."""
    a = Asset()
    a.use("KHR_mesh_quantization", required=True)
    positions, normals, uvs, corners = sphere(1, 24, 12)
    near = lambda v, most: [int(round(c * most)) for c in v]
    p = a.accessor([near(v, 20000) for v in positions], 5122, normalized=True)
    n = a.accessor([near(v, 127) for v in normals], 5120, normalized=True)
    t = a.accessor([near(v, 65535) for v in uvs], 5123, normalized=True)
    top = [i for i, v in enumerate(positions) if v[1] > 0.8]
    # A sparse accessor's values lie close: six bytes each.
    lifted = b"".join(a.packed([near((positions[i][0] * 0.6, 1.5, positions[i][2] * 0.6), 20000)], 5122) for i in top)
    a.root["accessors"][p]["sparse"] = {
        "count": len(top), "indices": {"bufferView": a.view(a.packed([top], 5123)), "componentType": 5123},
        "values": {"bufferView": a.view(lifted)}}
    stripes = a.texture(checker((240, 240, 240, 255), (40, 90, 160, 255), 8))
    part = {"attributes": {"POSITION": p, "NORMAL": n, "TEXCOORD_0": t}, "indices": a.accessor(corners, 5123),
            "material": a.material(stripes)}
    a.show(a.add("nodes", mesh=a.add("meshes", primitives=[part]), scale=[2, 2, 2]))
    return a.text()


def animated():
    """An arm that turns with a hand that slides on it and a ball that hops: linear, cubic and step, for two seconds."""
    a = Asset()
    ground = a.add("nodes", mesh=a.mesh(floor(6), a.material(GREY)))
    hand = a.add("nodes", name="hand", mesh=a.mesh(box(0.3), a.material([0.9, 0.2, 0.2, 1])), translation=[0, 0.4, 0])
    rod = a.add("nodes", name="rod", mesh=a.mesh(box(0.2), a.material([0.3, 0.5, 0.8, 1])), scale=[8, 1, 1], translation=[0.8, 0, 0])
    arm = a.add("nodes", name="arm", children=[hand, rod], translation=[0, 0.5, 0])
    ball = a.add("nodes", name="ball", mesh=a.mesh(sphere(0.25, 16, 8), a.material([0.9, 0.8, 0.2, 1])), translation=[-1.5, 0.25, 0.5])
    a.animate([0, 0.5, 1, 1.5, 2], (arm, "rotation", [tuple(turn(1, 90 * i)) for i in range(5)], "LINEAR"))
    a.animate([0, 1, 2], (hand, "translation", [(0, 0, 0), (0.2, 0.4, 0), (0, 0, 0), (0, 0, 0), (1.6, 0.4, 0), (0, 0, 0),
                                                (0, 0, 0), (0.2, 0.4, 0), (0, 0, 0)], "CUBICSPLINE"))
    a.animate([0, 0.5, 1, 1.5], (ball, "translation", [(-1.5, 0.25, 0.5), (-1.5, 1, 0.5), (-1.5, 0.25, 0.5), (-1.5, 0.6, 0.5)], "STEP"))
    a.show(ground, arm, ball, camera(a, (0, 2.4, 4.4), -25), sun(a))
    return a.text()


def bent():
    """A bar that a second joint bends (a skin), and a box that swells (a morph target)."""
    a = Asset()
    positions, normals, uvs, corners = box(1, 8)
    positions = [(x * 0.4, (y + 0.5) * 2, z * 0.4) for x, y, z in positions]
    part = a.primitive((positions, normals, uvs, corners), a.material([0.3, 0.7, 0.4, 1]))
    share = [min(max((y - 0.6) / 0.8, 0), 1) for _, y, _ in positions]
    part["attributes"]["JOINTS_0"] = a.accessor([(0, 1, 0, 0)] * len(positions), 5121)
    part["attributes"]["WEIGHTS_0"] = a.accessor([(1 - s, s, 0, 0) for s in share])
    upper = a.add("nodes", name="upper joint", translation=[0, 1, 0])
    lower = a.add("nodes", name="lower joint", children=[upper])
    eye = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]
    binds = a.accessor([eye + [0, 0, 0, 1], eye + [0, -1, 0, 1]])
    skin = a.add("skins", joints=[lower, upper], inverseBindMatrices=binds)
    bar = a.add("nodes", name="bar", mesh=a.add("meshes", primitives=[part]), skin=skin)
    positions, normals, uvs, corners = box(0.8, 6)
    swell = a.primitive((positions, normals, uvs, corners), a.material([0.8, 0.4, 0.3, 1]))
    outward = [(p, tuple(c / sum(v * v for v in p) ** 0.5 for c in p)) for p in positions]
    swell["targets"] = [{"POSITION": a.accessor([tuple(0.55 * u - c for u, c in zip(n, p)) for p, n in outward]),
                         "NORMAL": a.accessor([tuple(u - c for u, c in zip(n, m)) for (_, n), m in zip(outward, normals)])}]
    mesh = a.add("meshes", primitives=[swell], weights=[0])
    puff = a.add("nodes", name="puff", mesh=mesh, translation=[1.5, 0.8, 0])
    a.animate([0, 1, 2], (upper, "rotation", [tuple(turn(2, d)) for d in (0, 80, 0)], "LINEAR"),
              (puff, "weights", [0, 1, 0], "LINEAR"))
    ground = a.add("nodes", mesh=a.mesh(floor(6), a.material(GREY)))
    a.show(bar, lower, puff, ground, camera(a, (0.5, 1.8, 5), -10), sun(a))
    return a.text()


def glass():
    """A ball of tinted glass (transmission, volume), a thin pane and a clear-coated block before a checker."""
    a = Asset()
    a.use("KHR_materials_transmission", "KHR_materials_volume", "KHR_materials_ior", "KHR_materials_clearcoat")
    ball = a.material([1, 1, 1, 1], roughness=0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.45},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 1, "attenuationColor": [0.6, 0.95, 0.8]}})
    pane = a.material([0.9, 0.6, 0.5, 1], roughness=0, extensions={"KHR_materials_transmission": {"transmissionFactor": 0.9}},
                      doubleSided=True)
    coat = a.material([0.5, 0.05, 0.1, 1], roughness=0.6, extensions={
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0}})
    ground = a.texture(checker((230, 230, 225, 255), (60, 70, 90, 255)))
    nodes = [a.add("nodes", mesh=a.mesh(sphere(0.6, 48, 24), ball), translation=[-1, 0.6, 0]),
             a.add("nodes", mesh=a.mesh(quad(0.8, 1.2), pane), translation=[0.3, 0.6, 0.2], rotation=turn(1, 20)),
             a.add("nodes", mesh=a.mesh(box(0.8), coat), translation=[1.4, 0.4, -0.3], rotation=turn(1, 30)),
             a.add("nodes", mesh=a.mesh(floor(8, 4), a.material(ground)))]
    a.show(*nodes, camera(a, (0, 1.5, 4.2), -14), sun(a))
    return a.text()


GLTF = {
    "gltf/box.gltf": box_model,
    "gltf/textured.glb": textured,
    "gltf/spheres.gltf": spheres,
    "gltf/alpha.gltf": alpha,
    "gltf/normal.gltf": normal_map,
    "gltf/lights.gltf": lights,
    "gltf/instances.gltf": instances,
    "gltf/quantized.gltf": quantized,
    "gltf/animated.gltf": animated,
    "gltf/bent.gltf": bent,
    "gltf/glass.gltf": glass,
}
