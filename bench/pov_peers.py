#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times `sundog pov` beside `povray`: the same scenes, switches and threads, in turn.

    bench/pov_peers.py shapes  [--only NAME,...]     a scene for each kind of shape
    bench/pov_peers.py files   FILE.pov ...          scenes of your own (each from its own folder)
    bench/pov_peers.py examples [FOLDER]             all scenes under povray-examples' folder on which povray takes more
                                                     than --at-least seconds, and the means of each kind of scene
    bench/pov_peers.py large   [--only NAME,...]     a million spheres, a mesh of many megabytes: parsing and memory
    bench/pov_peers.py noise                         marble and granite: evaluations of noise in a processor second

Times are processor seconds (user and system) and wall seconds of the whole program; memory is the peak resident set.
Ratios above 1 mean that povray takes more. Each figure is the least of --rounds rounds, in which the programs alternate.
"""
import argparse
import math
import os
import pathlib
import re
import resource
import sys
import tempfile
import time

STAGE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -11> look_at <0, 0.2, 0> angle 50 right x*image_width/image_height }
light_source { <-8, 14, -10> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.2 pigment { checker rgb 0.4, rgb 0.8 } }
#declare Coat = texture { pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.6 } }
"""

# What stands on the stage's 7 by 5 places, unless the body says otherwise.
GRID = """#declare Row = 0; #while (Row < 5) #declare Column = 0; #while (Column < 7)
  object { Shape texture { Coat } rotate <25, 40*Column, 15*Row> translate <2.1*(Column - 3), 0.1, 2.1*(Row - 2)> }
#declare Column = Column + 1; #end #declare Row = Row + 1; #end
"""

CHEESE = """#declare Holes = %d; #declare Seed = seed(7);
#declare Shape = difference { %s
  #declare I = 0; #while (I < Holes)
    sphere { <rand(Seed)*2 - 1, rand(Seed)*2 - 1, rand(Seed)*2 - 1>*1.02 0.9*pow(Holes, -0.45) } #declare I = I + 1; #end }
"""

SHAPES = {
    "sphere": "#declare Shape = sphere { 0, 1 scale <1, 0.6, 0.8> }" + GRID,
    "box": "#declare Shape = box { <-0.8, -0.5, -0.6>, <0.8, 0.5, 0.6> }" + GRID,
    "cone": "#declare Shape = union { cone { -y, 0.9, y*0.2, 0.3 } cylinder { 0, x, 0.2 } }" + GRID,
    "torus": "#declare Shape = torus { 0.75, 0.3 }" + GRID,
    "quartic": "#declare Shape = quartic { <1, 0,0,0, 2, 0,0, 2, 0, -1.16, 0,0,0,0,0,0,0,0,0,0, 1, 0,0, 2, 0,"
               " 0.8, 0,0,0,0, 1, 0, -1.16, 0, 0.16> sturm }" + GRID,
    "cubic": "#declare Shape = intersection { cubic { <1,0,0,0, 0,0,0,0,0,0, 0,0,0,-1,0, 0,-1,0,0,0> }"
             " sphere { 0, 1 } }" + GRID,
    "blob": "#declare Shape = blob { threshold 0.5 #declare S = seed(3); #declare I = 0; #while (I < 8)"
            " sphere { <rand(S) - 0.5, rand(S) - 0.5, rand(S) - 0.5>*1.3, 0.6, 1 } #declare I = I + 1; #end"
            " cylinder { -x*0.7, x*0.7, 0.4, 1 } }" + GRID,
    "lathe": "#declare Shape = lathe { cubic_spline 7, <0.1, -1.2>, <0.2, -0.9>, <0.9, -0.5>, <0.3, 0>, <0.6, 0.5>,"
             " <0.4, 0.9>, <0.1, 1> }" + GRID,
    "sor": "#declare Shape = sor { 7, <0.1, -1.2>, <0.5, -0.9>, <0.9, -0.5>, <0.3, 0>, <0.6, 0.5>, <0.4, 0.9>,"
           " <0.1, 1.2> }" + GRID,
    "prism": "#declare Shape = prism { cubic_spline -0.5, 0.5, 9, <-0.5, -0.7>, <0.9, 0>, <0.6, 0.6>, <0, 0.9>, <-0.3, 0.3>,"
             " <-0.9, 0>, <-0.5, -0.7>, <0.9, 0>, <0.6, 0.6> }" + GRID,
    "sphere_sweep": "#declare Shape = sphere_sweep { b_spline 7, <-1, -1, 0>, 0.3, <-0.8, 0.9, 0>, 0.3, <-0.2, -0.8, 0.5>,"
                    " 0.25, <0.2, 0.8, -0.3>, 0.3, <0.8, -0.7, 0.1>, 0.3, <0.9, 0.8, 0>, 0.2, <1.4, 0.9, 0>, 0.2 }" + GRID,
    "superellipsoid": "#declare Shape = superellipsoid { <0.4, 0.25> scale 0.8 }" + GRID,
    "height_field": "height_field { function 400, 400 { 0.5 + 0.2*sin(14*x)*cos(17*y) + 0.15*sin(61*x + 3)*sin(53*y)"
                    " + 0.1*cos(29*y*x) } smooth translate <-0.5, 0, -0.5> scale <20, 2, 14> translate -y texture { Coat } }",
    "mesh2": None,  # written by mesh_text
    "text": "#declare Shape = text { ttf \"cyrvetic.ttf\" \"Sg8\" 0.4, 0 scale 1.1 translate <-0.8, -0.4, 0> }" + GRID,
    "difference 3": "#declare Shape = difference { box { -0.8, 0.8 } sphere { 0, 1 } cylinder { -y, y, 0.5 } }" + GRID,
    "difference 30": CHEESE % (30, "box { -0.8, 0.8 }") + GRID,
    "difference 1000": CHEESE % (1000, "box { -0.8, 0.8 }") + "object { Shape texture { Coat } rotate y*30 scale 4 }",
    "merge": "#declare S = seed(5); #declare Shape = merge { #declare I = 0; #while (I < 12) sphere {"
             " <rand(S) - 0.5, rand(S) - 0.5, rand(S) - 0.5>*1.2, 0.45 } #declare I = I + 1; #end }\n"
             "#declare Coat = texture { pigment { rgbf <0.9, 0.7, 0.5, 0.5> } }" + GRID,
}


def mesh_text(triangles, has_uvs=False):
    """A wavy sheet as mesh2, one vector a line as exporters write it."""
    side = max(1, round(math.sqrt(triangles / 2)))
    points = []
    for row in range(side + 1):
        for column in range(side + 1):
            x, z = 20 * (column / side - 0.5), 14 * (row / side - 0.5)
            points.append(f"<{x:.6f}, {0.5 * math.sin(3 * x) * math.cos(2.5 * z) + 0.1 * math.sin(17 * x * z):.6f}, {z:.6f}>")
    faces = []
    for row in range(side):
        for column in range(side):
            a = row * (side + 1) + column
            faces += [f"<{a}, {a + 1}, {a + side + 1}>", f"<{a + 1}, {a + side + 2}, {a + side + 1}>"]
    return (f"mesh2 {{\nvertex_vectors {{ {len(points)},\n" + ",\n".join(points) +
            f"\n}}\nface_indices {{ {len(faces)},\n" + ",\n".join(faces) + "\n}\ntexture { Coat }\n}\n")


MILLION = """#declare S = seed(1); #declare I = 0;
#while (I < 1000000)
  sphere { <rand(S)*20 - 10, rand(S)*4 - 1, rand(S)*14 - 7>, 0.02 %s }
  #declare I = I + 1;
#end
"""
LARGE = {
    "million spheres, own colours": lambda: MILLION % "pigment { rgb <rand(S), rand(S), rand(S)> }",
    "million spheres": lambda: MILLION % "",
    "mesh2, 200 MB": lambda: mesh_text(4_650_000),
}


# Many patterns of one kind at every pixel; each of the noisy ones adds up six octaves.
NOISE_OCTAVES = 6
NOISE_PATTERNS = {"gradient": "gradient x", "granite": "granite", "marble": "marble turbulence 1"}
NOISE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z right 4*x up 3*y look_at 0 }
plane { z, 0 finish { ambient 1 diffuse 0 } pigment { average pigment_map {
  #declare I = 0; #while (I < %d) [1 %s color_map { [0 rgb 0] [1 rgb 1] } scale 1 + I/9 translate I*7] #declare I = I + 1; #end
} } }
"""

EXAMPLES = "/usr/share/doc/povray/examples"

# Kinds of scenes with means of their own, by what their text says.
KINDS = {
    "media": r"\b(media|scattering)\s*\{",
    "radiosity": r"\bradiosity\s*\{",
    "photons": r"\bphotons\s*\{",
    "isosurface": r"\bisosurface\b",
    "area light": r"\barea_light\b",
}


def measure(command, folder, limit=0):
    """Runs a command; (processor seconds, wall seconds, peak MiB), or None if it fails or takes more than `limit` processor
    seconds (0: any number)."""
    start = time.monotonic()
    child = os.fork()
    if child == 0:
        os.chdir(folder)
        if limit:
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        null = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(null, stream)
        try:
            os.execvp(command[0], command)
        finally:
            os._exit(127)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        return None
    return usage.ru_utime + usage.ru_stime, time.monotonic() - start, usage.ru_maxrss / 1024


def compare(name, scene, folder, options, with_memory=False, povray_first=None):
    """Prints a row of the table; returns povray's time to sundog's, or None. `povray_first`: povray's first round, already taken."""
    switches = options.switches.split() + [f"+WT{options.threads}", f"+I{scene}", "-D", "-P"]
    with tempfile.TemporaryDirectory() as output:
        sides = {"sundog": options.sundog.split() + switches + [f"+O{output}/sundog.png"],
                 "povray": ["povray"] + switches + [f"+O{output}/povray.png"]}
        best = {}
        for turn in range(options.rounds):
            for side, command in sides.items():
                known = povray_first if side == "povray" and turn == 0 else None
                taken = known or measure(command, folder, options.limit)
                if taken is None:
                    print(f"{name:<32} {side} fails: {' '.join(command)}")
                    return None
                before = best.get(side, taken)
                best[side] = tuple(map(min, before, taken))
    ours, theirs = best["sundog"], best["povray"]
    ratio = theirs[0] / max(ours[0], 1e-3)
    row = f"{name:<32} {ours[0]:8.2f} {theirs[0]:8.2f} {ratio:7.2f}   {ours[1]:8.2f} {theirs[1]:8.2f} {theirs[1] / ours[1]:7.2f}"
    if with_memory:
        row += f"   {ours[2]:8.0f} {theirs[2]:8.0f} {theirs[2] / ours[2]:7.2f}"
    print(row, flush=True)
    return ratio, theirs[1] / ours[1]


def compare_noise(folder, options):
    """Evaluations of noise in a processor second: what granite and marble take more than a gradient in their place."""
    width, height, count = 640, 480, 32
    seconds = {}
    for name, pattern in NOISE_PATTERNS.items():
        file = folder / f"noise_{name}.pov"
        file.write_text(NOISE % (count, pattern))
        for side, program in {"sundog": options.sundog.split(), "povray": ["povray"]}.items():
            command = program + [f"+W{width}", f"+H{height}", "-A", f"+WT{options.threads}", f"+I{file.name}", "-D", "-P",
                                 f"+O{folder}/noise.png"]
            seconds[side, name] = min(measure(command, folder)[0] for _ in range(options.rounds))
    evaluations = width * height * count * NOISE_OCTAVES
    print(f"{'millions of noise evaluations':<32} {'sundog':>8} {'povray':>8} {'ratio':>7}")
    for name in ("granite", "marble"):
        rates = [evaluations / 1e6 / max(seconds[side, name] - seconds[side, "gradient"], 1e-3)
                 for side in ("sundog", "povray")]
        print(f"{name + ', a processor second':<32} {rates[0]:8.0f} {rates[1]:8.0f} {rates[0] / rates[1]:7.2f}")


def print_mean(name, ratios):
    means = [math.exp(sum(math.log(r[i]) for r in ratios) / len(ratios)) for i in (0, 1)]
    slower = sum(r[1] < 1 for r in ratios)
    print(f"{name}: geometric mean of {len(ratios)}: {means[0]:.2f} by processor time, {means[1]:.2f} by wall time; {slower} slower")


def compare_examples(folder, options):
    """A row for each scene on which povray takes long enough, and the means of each kind; the ratios of all."""
    ratios, kinds = [], {kind: [] for kind in KINDS}
    for path in sorted(folder.rglob("*.pov")):
        name = str(path.relative_to(folder).with_suffix(""))
        if options.only and not any(part in name for part in options.only.split(",")):
            continue
        switches = options.switches.split() + [f"+WT{options.threads}", f"+I{path.name}", "-D", "-P"]
        with tempfile.TemporaryDirectory() as output:
            first = measure(["povray"] + switches + [f"+O{output}/povray.png"], path.parent, options.limit)
        if first is None or first[1] < options.at_least:
            continue
        ratio = compare(name[-32:], path.name, path.parent, options, povray_first=first)
        if ratio:
            ratios.append(ratio)
            text = path.read_text(encoding="latin-1")
            for kind, words in KINDS.items():
                if re.search(words, text):
                    kinds[kind].append(ratio)
    for kind, of_kind in kinds.items():
        if of_kind:
            print_mean(kind, of_kind)
    return ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["shapes", "files", "examples", "large", "noise"])
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--sundog", default="build/release/apps/sundog/sundog pov", help="our command")
    parser.add_argument("--only", help="names of scenes, with commas between them")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--switches", help="default: +W640 +H480 +A0.3; for large +W64 +H48 -A")
    parser.add_argument("--at-least", type=float, default=1, help="examples: povray's least wall seconds")
    parser.add_argument("--limit", type=int, default=0, help="processor seconds after which a program is stopped; 0: none")
    parser.add_argument("--keep", help="folder to write the scenes into")
    options = parser.parse_args()
    options.switches = options.switches or ("+W64 +H48 -A" if options.what == "large" else "+W640 +H480 +A0.3")
    command = options.sundog.split()
    if os.path.exists(command[0]):
        options.sundog = " ".join([os.path.abspath(command[0])] + command[1:])
    if options.what == "noise":
        with tempfile.TemporaryDirectory() as temporary:
            compare_noise(pathlib.Path(temporary), options)
        return 0
    print(f"{'':<32} {'processor seconds':^25}   {'wall seconds':^25}" + (f"   {'peak MiB':^25}" if options.what == "large" else ""))
    print(f"{'scene':<32} " + "   ".join([f"{'sundog':>8} {'povray':>8} {'ratio':>7}"] * (3 if options.what == "large" else 2)))
    ratios = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(options.keep or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        if options.what == "files":
            for scene in options.scenes:
                path = pathlib.Path(scene).resolve()
                ratios.append(compare(path.stem[:32], path.name, path.parent, options))
        elif options.what == "examples":
            ratios = compare_examples(pathlib.Path(options.scenes[0] if options.scenes else EXAMPLES), options)
        else:
            bodies = SHAPES if options.what == "shapes" else LARGE
            wanted = [n.strip() for n in options.only.split(",")] if options.only else list(bodies)
            for name, body in bodies.items():
                if name not in wanted and name.split(",")[0] not in wanted:
                    continue
                text = STAGE + (mesh_text(200_000) if body is None else body() if callable(body) else body)
                file = folder / (name.replace(",", "").replace(" ", "_") + ".pov")
                file.write_text(text)
                ratios.append(compare(name, file.name, folder, options, with_memory=options.what == "large"))
                del text
    ratios = [r for r in ratios if r]
    if ratios:
        print_mean("all", ratios)
    return 0


if __name__ == "__main__":
    sys.exit(main())
