# SPDX-License-Identifier: Apache-2.0
"""The gallery's glTF models of what vertices have beside positions, normals and one set of texture coordinates."""

from math import cos, pi

from gltf import Asset, box, floor, png, quad, sphere, turn
from gltf_models import GREY, camera, checker, stud, sun

UNSIGNED_BYTE, UNSIGNED_SHORT = 5121, 5123


def hue(share):
    """Around the circle of colours, from red."""
    return tuple(0.5 + 0.5 * cos(2 * pi * (share - i / 3)) for i in range(3))


def colored(a, shape, colors, material, component=5126):
    part = a.primitive(shape, material)
    more = {} if component == 5126 else {"normalized": True}
    part["attributes"]["COLOR_0"] = a.accessor(colors, component, **more)
    return a.add("meshes", primitives=[part])


def colors():
    """Colours of vertices: alone, of bytes on a picture, of a metal, of what shines; alpha that is blended and cut."""
    a = Asset()
    a.use("KHR_materials_unlit")
    ball = sphere(0.5, 32, 16)
    nodes = [a.add("nodes", mesh=colored(a, ball, [hue(u) for u, _ in ball[2]], a.material([1, 1, 1, 1])),
                   translation=[-1.5, 0.5, 0])]
    block = box(0.8, 2)
    tints = [[int(255 * c) for c in hue(y + 0.5)] + [255] for _, y, _ in block[0]]
    picture = a.texture(checker((255, 255, 255, 255), (120, 120, 120, 255), 2))
    nodes.append(a.add("nodes", mesh=colored(a, block, tints, a.material(picture), UNSIGNED_BYTE),
                       translation=[-0.2, 0.4, 0], rotation=turn(1, 30)))
    metal = a.material([0.9, 0.9, 0.9, 1], 1, 0.1)
    nodes.append(a.add("nodes", mesh=colored(a, ball, [hue(0.1 + 0.4 * v) for _, v in ball[2]], metal),
                       translation=[1.1, 0.5, -0.3]))
    sign = a.material([1, 1, 1, 1], extensions={"KHR_materials_unlit": {}})
    nodes.append(a.add("nodes", mesh=colored(a, quad(0.8, 0.5), [hue(i / 4) for i in range(4)], sign),
                       translation=[1.9, 0.3, 0.6]))
    fade = [[65535, 65535, 65535, share] for share in (0, 65535, 65535, 0)]
    for i, more in enumerate([{"alphaMode": "BLEND"}, {"alphaMode": "MASK", "alphaCutoff": 0.5}]):
        pane = a.material([0.9, 0.3, 0.2, 1], doubleSided=True, **more)
        nodes.append(a.add("nodes", mesh=colored(a, quad(1, 0.6), fade, pane, UNSIGNED_SHORT),
                           translation=[-0.9 + 1.3 * i, 0.3, 1]))
    ground = floor(7)
    nodes.append(a.add("nodes", mesh=colored(a, ground, [(0.9, 0.9, 0.9), (0.3, 0.5, 0.3), (0.3, 0.3, 0.5), (0.5, 0.3, 0.3)],
                                             a.material([1, 1, 1, 1]))))
    a.show(*nodes, camera(a, (0.2, 1.9, 4.6), -18), sun(a))
    return a.text()


def uv_sets():
    """Bricks that repeat by one set of texture coordinates; a sign and dirt in the corners that lie once, by another."""
    a = Asset()
    a.use("KHR_texture_transform")

    def brick(x, y):
        joint = y % 8 == 0 or (x + 8 * (y // 8 % 2)) % 16 == 0
        return (200, 195, 185, 255) if joint else (170, 80 + 10 * ((x // 16 + y // 8) % 3), 60, 255)

    bricks = a.texture(png(32, 16, brick))
    sign = a.texture(png(16, 16, lambda x, y: (250, 220, 80, 255) if 3 < x < 12 and 5 < y < 10 else (0, 0, 0, 255)), magFilter=9728)
    dirt = a.texture(png(16, 16, lambda x, y: (int(255 * min(1, 0.1 + min(x, 15 - x, y, 15 - y) / 5)),) * 3 + (255,)),
                     wrapS=33071, wrapT=33071)
    # Which set a map goes by is said in one of two places.
    sign["texCoord"] = 0
    sign["extensions"] = {"KHR_texture_transform": {"texCoord": 1}}
    dirt["texCoord"] = 1
    material = a.material(bricks, emissiveTexture=sign, emissiveFactor=[1, 1, 1], occlusionTexture={**dirt, "strength": 1})
    nodes = []
    for x, shape in [(-1.2, quad(2, 2, 3)), (1.2, box(1.4))]:
        part = a.primitive(shape, material)
        once = [(u / max(v[0] for v in shape[2]), t / max(v[1] for v in shape[2])) for u, t in shape[2]]
        part["attributes"]["TEXCOORD_1"] = a.accessor(once)
        nodes.append(a.add("nodes", mesh=a.add("meshes", primitives=[part]), translation=[x, 0, 0],
                           rotation=turn(1, 0 if x < 0 else -35)))
    # Without lights: ambient light, which is what occlusion dims, comes with the daylight that stands in.
    a.show(*nodes, camera(a, (0, 0.9, 4.2), -12))
    return a.text()


def tangents():
    """Studs as seen by the texture coordinates, by tangents that say the same, by others, and from behind."""
    a = Asset()

    material = a.material([0.7, 0.7, 0.75, 1], normalTexture=a.texture(png(32, 32, stud)), doubleSided=True)
    nodes = []
    for i, tangent in enumerate([None, (1, 0, 0, 1), (0, -1, 0, 1), (-1, 0, 0, -1)]):
        part = a.primitive(quad(0.9, 0.9), material)
        if tangent:
            part["attributes"]["TANGENT"] = a.accessor([tangent] * 4)
        nodes.append(a.add("nodes", mesh=a.add("meshes", primitives=[part]), translation=[i % 2 - 0.5, 0.5 - i // 2, 0]))
    part = a.primitive(quad(0.9, 0.9), material)
    part["attributes"]["TANGENT"] = a.accessor([(1, 0, 0, 1)] * 4)
    behind = a.add("meshes", primitives=[part])
    nodes.append(a.add("nodes", mesh=behind, translation=[1.5, 0.5, 0], rotation=turn(1, 180)))
    # A mirror image: what was a stud stays one.
    nodes.append(a.add("nodes", mesh=behind, translation=[1.5, -0.5, 0], scale=[-1, 1, 1]))
    a.show(*nodes, camera(a, (0.5, 0, 3.2)), sun(a, 3, -35))
    return a.text()


def variants():
    """A ball on a box in three dresses (KHR_materials_variants)."""
    a = Asset()
    a.use("KHR_materials_variants")
    plain = a.material([0.8, 0.8, 0.8, 1])
    brass = a.material([0.9, 0.7, 0.35, 1], 1, 0.15)
    red = a.material([0.8, 0.1, 0.1, 1], roughness=0.2)
    squares = a.material(a.texture(checker((230, 230, 230, 255), (40, 40, 60, 255))))
    a.root.setdefault("extensions", {})["KHR_materials_variants"] = {"variants": [{"name": n} for n in ("brass", "red", "squared")]}

    def dressed(shape, *materials):
        mappings = [{"material": m, "variants": [i]} for i, m in enumerate(materials)]
        part = a.primitive(shape, plain, extensions={"KHR_materials_variants": {"mappings": mappings}})
        return a.add("meshes", primitives=[part])

    nodes = [a.add("nodes", mesh=dressed(sphere(0.5, 32, 16), brass, red, squares), translation=[0, 1.3, 0]),
             a.add("nodes", mesh=dressed(box(0.8), squares, brass), translation=[0, 0.4, 0], rotation=turn(1, 25)),
             a.add("nodes", mesh=a.mesh(floor(5), a.material(GREY)))]
    a.show(*nodes, camera(a, (0, 1.9, 3.6), -18), sun(a))
    return a.text()


def one_sided():
    """A room whose walls face inwards, looked into from outside; two banners from behind, of which one has a back."""
    a = Asset()
    positions, normals, uvs, corners = box(3, 1)
    inwards = (positions, [tuple(-c for c in n) for n in normals], uvs,
               [corners[i + k] for i in range(0, len(corners), 3) for k in (0, 2, 1)])
    walls = a.material(a.texture(checker((210, 205, 190, 255), (150, 150, 160, 255), 6, 24)))
    nodes = [a.add("nodes", mesh=a.mesh(inwards, walls), translation=[0, 1.5, 0]),
             a.add("nodes", mesh=a.mesh(box(0.7), a.material([0.8, 0.4, 0.2, 1])), translation=[-0.7, 0.35, -0.6],
                   rotation=turn(1, 20))]
    for i, two in enumerate([False, True]):
        banner = a.mesh(quad(0.6, 0.9), a.material([0.2, 0.4, 0.8, 1], doubleSided=two))
        nodes.append(a.add("nodes", mesh=banner, translation=[0.2 + 0.8 * i, 0.7, 0.3], rotation=turn(1, 180)))
    lamp = a.add("nodes", extensions=a.light("point", 5), translation=[0.2, 2.6, 0.9])
    a.show(*nodes, lamp, camera(a, (0, 2, 5.2), -8))
    return a.text()


ATTRIBUTES = {
    "gltf/colors.gltf": colors,
    "gltf/uv_sets.gltf": uv_sets,
    "gltf/tangents.gltf": tangents,
    "gltf/variants.gltf": variants,
    "gltf/one_sided.gltf": one_sided,
}
