#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Path tracing beside Blender's Cycles: Cornell boxes of the same triangles, emission, camera, samples and bounces.

    bench/path_peers.py [diffuse] [spheres] [--samples N] [--bounces N] [--reference N] [--rounds N] [--size N]

Each program's picture is compared with a reference of its own of --reference samples and another seed. Printed are
seconds (the least of --rounds, in which the programs alternate; Cycles' by its own clock, without Blender's start), the
mean squared error of linear radiance, the product of both, and how far the means of 8 by 8 regions of the two references
are apart. Needs blender, and python3-openimageio to read the pictures.
"""
import argparse
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import time

WHITE, RED, GREEN = (0.73, 0.73, 0.73), (0.65, 0.05, 0.05), (0.12, 0.45, 0.15)
LAMP_SIZE, LAMP_HEIGHT, LAMP_RADIANCE = (0.25, 0.2), 0.999, 15.0
VIEW = 0.5 / 1.4  # half the window, one unit before the eye


def block(cx, cy, side, height, turn_deg):
    c, s = math.cos(math.radians(turn_deg)) * side / 2, math.sin(math.radians(turn_deg)) * side / 2
    foot = [(cx - c + s, cy - s - c), (cx + c + s, cy + s - c), (cx + c - s, cy + s + c), (cx - c - s, cy - s + c)]
    corners = [(x, y, z) for z in (0.0, height) for x, y in foot]
    faces = [(0, 3, 2, 1), (4, 5, 6, 7)] + [(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)]
    return corners, faces


def ball(cx, cy, cz, radius, columns=256, rows=128):
    """Vertices on a ball, poles first and last, and its faces."""
    vertices = [(cx, cy, cz + radius)]
    for j in range(1, rows):
        down = math.pi * j / rows
        for i in range(columns):
            around = 2 * math.pi * i / columns
            vertices.append((cx + radius * math.sin(down) * math.cos(around),
                             cy + radius * math.sin(down) * math.sin(around), cz + radius * math.cos(down)))
    vertices.append((cx, cy, cz - radius))
    last = len(vertices) - 1
    at = lambda row, i: 1 + row * columns + i % columns
    faces = [(0, at(0, i), at(0, i + 1)) for i in range(columns)]
    faces += [(at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)) for j in range(rows - 2) for i in range(columns)]
    faces += [(at(rows - 2, i), last, at(rows - 2, i + 1)) for i in range(columns)]
    return vertices, faces


def objects(variant):
    """Name, vertices, faces, material, and the middle of a smooth ball or None."""
    quad = [(0, 1, 2, 3)]
    yield "floor", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], quad, "white", None
    yield "ceiling", [(0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1)], quad, "white", None
    yield "back", [(0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1)], quad, "white", None
    yield "left", [(0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1)], quad, "red", None
    yield "right", [(1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0)], quad, "green", None
    if variant == "diffuse":
        yield ("tall", *block(0.33, 0.63, 0.3, 0.6, 17), "white", None)
        yield ("short", *block(0.67, 0.33, 0.3, 0.3, -17), "white", None)
    else:
        yield ("mirror", *ball(0.3, 0.65, 0.18, 0.18), "mirror", (0.3, 0.65, 0.18))
        yield ("glass", *ball(0.7, 0.35, 0.18, 0.18), "glass", (0.7, 0.35, 0.18))


def lamp(height):
    a, b = LAMP_SIZE[0] / 2, LAMP_SIZE[1] / 2
    return [(0.5 - a, 0.5 - b, height), (0.5 - a, 0.5 + b, height), (0.5 + a, 0.5 + b, height), (0.5 + a, 0.5 - b, height)]


def write_scene(variant, folder):
    vertices, normals, text = [], [], [f"mtllib {variant}.mtl"]
    parts = list(objects(variant))
    # Cycles' lamp shines downwards alone: ours has a black lid.
    parts.append(("lamp", lamp(LAMP_HEIGHT), [(0, 1, 2, 3)], "lamp", None))
    parts.append(("lid", lamp(LAMP_HEIGHT + 1e-5), [(3, 2, 1, 0)], "black", None))
    for name, points, faces, material, middle in parts:
        first, first_normal = len(vertices) + 1, len(normals) + 1
        vertices += points
        if middle:
            normals += [tuple(p[k] - middle[k] for k in range(3)) for p in points]
        text += [f"o {name}", f"usemtl {material}"]
        for face in faces:
            corner = lambda i: f"{first + i}//{first_normal + i}" if middle else str(first + i)
            text.append("f " + " ".join(corner(i) for i in face))
    lines = [text[0]] + [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in vertices]
    lines += [f"vn {x:.9g} {y:.9g} {z:.9g}" for x, y, z in normals] + text[1:]
    (folder / f"{variant}.obj").write_text("\n".join(lines) + "\n")
    matt = lambda name, c: f"newmtl {name}\nKd {c[0]} {c[1]} {c[2]}\nillum 1\n"
    light = f"newmtl lamp\nKd 0 0 0\nKe {LAMP_RADIANCE} {LAMP_RADIANCE} {LAMP_RADIANCE}\nillum 1\n"
    mirror = "newmtl mirror\nKd 0 0 0\nKs 0.95 0.95 0.95\nillum 3\n"
    glass = "newmtl glass\nKd 0 0 0\nKs 1 1 1\nNi 1.5\nTf 1 1 1\nd 0\nillum 7\n"
    (folder / f"{variant}.mtl").write_text(
        matt("white", WHITE) + matt("red", RED) + matt("green", GREEN) + matt("black", (0, 0, 0)) + light + mirror + glass)
    scene = folder / f"{variant}.scene"
    scene.write_text(f"model = {variant}.obj\nfocus = {12 / VIEW:.9g}\ndistance = 1.44\norigin = 0.5 0 0.5\nrotX = const 0\n"
                     "rotZ = const 0\nambient = 0 0 0\nlight = lamp const\nlightPos = 0.5 0.5 0.9\nlightColor = 0 0 0\n")
    return scene


def render_here(options, scene, samples, seed, output):
    start = time.perf_counter()
    subprocess.run([options.sundog, "render", scene, "-o", output, "--size", f"{options.size}x{options.size}",
                    "--integrator", "path", "--spp", str(samples), "--max-depth", str(options.bounces), "--seed",
                    str(seed), "--threads", str(options.threads), "-q"], check=True)
    return time.perf_counter() - start


def render_cycles(options, variant, samples, seed, output):
    command = ["blender", "-b", "--factory-startup", "-noaudio", "--python", __file__, "--", "--inside-blender", variant,
               str(samples), str(options.bounces), str(options.size), str(seed), str(options.threads), str(output)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return float(re.search(r"SECONDS ([0-9.]+)", done.stdout).group(1))


def inside_blender(arguments):
    import bpy

    variant, samples, bounces, size, seed, threads, output = arguments
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", int(samples), int(seed)
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    for name in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, f"{name}_bounces", int(bounces))
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type, cycles.filter_width, cycles.use_auto_tile = "BOX", 1.0, False
    render = scene.render
    render.threads_mode, render.threads = "FIXED", int(threads)
    render.resolution_x = render.resolution_y = int(size)
    render.filepath, render.use_file_extension = output, False
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.view_settings.view_transform = "Standard"

    def material(name, kind, color, **inputs):
        m = bpy.data.materials.new(name)
        m.use_nodes = True
        tree = m.node_tree
        tree.nodes.clear()
        node = tree.nodes.new(kind)
        node.inputs["Color"].default_value = (*color, 1)
        for key, value in inputs.items():
            node.inputs[key].default_value = value
        if hasattr(node, "distribution"):
            node.distribution = "SHARP"
        tree.links.new(node.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
        return m

    materials = {"white": material("white", "ShaderNodeBsdfDiffuse", WHITE),
                 "red": material("red", "ShaderNodeBsdfDiffuse", RED),
                 "green": material("green", "ShaderNodeBsdfDiffuse", GREEN),
                 "mirror": material("mirror", "ShaderNodeBsdfGlossy", (0.95, 0.95, 0.95)),
                 "glass": material("glass", "ShaderNodeBsdfGlass", (1, 1, 1), IOR=1.5)}
    for name, points, faces, kind, middle in objects(variant):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points, [], faces)
        mesh.materials.append(materials[kind])
        if middle:
            mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
        mesh.update()
        scene.collection.objects.link(bpy.data.objects.new(name, mesh))
    light = bpy.data.lights.new("lamp", "AREA")
    light.shape, light.size, light.size_y = "RECTANGLE", *LAMP_SIZE
    light.energy = 4 * LAMP_RADIANCE * LAMP_SIZE[0] * LAMP_SIZE[1]  # Cycles 3.4: radiance is energy / (4 area)
    light.cycles.max_bounces = 1024
    lamp_object = bpy.data.objects.new("lamp", light)
    lamp_object.location = (0.5, 0.5, LAMP_HEIGHT)
    lamp_object.visible_camera = True
    scene.collection.objects.link(lamp_object)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (0.5, -1.44, 0.5), (math.pi / 2, 0, 0)
    camera.data.sensor_fit, camera.data.angle = "HORIZONTAL", 2 * math.atan(VIEW)
    scene.collection.objects.link(camera)
    scene.camera = camera
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    print(f"SECONDS {time.perf_counter() - start:.3f}")


def read(file):
    import OpenImageIO

    picture = OpenImageIO.ImageInput.open(str(file))
    spec = picture.spec()
    return picture.read_image(OpenImageIO.FLOAT).reshape(spec.height, spec.width, -1)[..., :3].astype("float64")


def regions_apart(a, b, dark=0.01):
    """Largest relative difference of the means of 8 by 8 regions, dark ones aside."""
    cell = a.shape[0] // 8
    mean = lambda p: p[:cell * 8, :cell * 8].reshape(8, cell, 8, cell, 3).mean((1, 3, 4))
    x, y = mean(a), mean(b)
    return float((abs(x - y) / y)[y > dark].max())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("variants", nargs="*", default=["diffuse", "spheres"])
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--bounces", type=int, default=8)
    parser.add_argument("--reference", type=int, default=4096)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--sundog", default=str(pathlib.Path(__file__).parent.parent / "build/release/apps/sundog/sundog"))
    options = parser.parse_args()
    print(f"{'':10}{'':8}{'seconds':>9}{'error':>12}{'error x seconds':>17}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for variant in options.variants:
            scene = write_scene(variant, folder)
            makers = {"sundog": lambda n, seed, out: render_here(options, scene, n, seed, out),
                      "cycles": lambda n, seed, out: render_cycles(options, variant, n, seed, out)}
            seconds, error, references = {}, {}, {}
            for _ in range(options.rounds):
                for maker, make in makers.items():
                    took = make(options.samples, 1, folder / f"{maker}.exr")
                    seconds[maker] = min(took, seconds.get(maker, took))
            for maker, make in makers.items():
                make(options.reference, 2, folder / f"{maker}_reference.exr")
                references[maker] = read(folder / f"{maker}_reference.exr")
                error[maker] = float(((read(folder / f"{maker}.exr") - references[maker]) ** 2).mean())
                print(f"{variant:10}{maker:8}{seconds[maker]:9.2f}{error[maker]:12.3e}{error[maker] * seconds[maker]:17.3e}")
            ratio = error["sundog"] * seconds["sundog"] / (error["cycles"] * seconds["cycles"])
            apart = regions_apart(references["sundog"], references["cycles"])
            print(f"{variant:10}ratio of error x seconds {ratio:.3f}; regions of the references at most {100 * apart:.2f} % apart",
                  flush=True)


if __name__ == "__main__":
    if "--inside-blender" in sys.argv:
        inside_blender(sys.argv[sys.argv.index("--inside-blender") + 1:])
    else:
        main()
