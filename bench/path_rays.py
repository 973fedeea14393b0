#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How much of the path tracer's time is Embree's own.

    bench/path_rays.py [SCENE ...] [--sundog PROGRAM] [--samples N]

Each scene is drawn by paths under perf(1), and the samples that fall into Embree, with what it calls back for spheres
and boxes, are counted apart from all others of the render threads. Embree finds the very same rays in the very same
packets, so that share is what raw Embree would take for them: the ratio of rays a second inside the path tracer to those of
raw Embree. Needs perf, and the right to use it (kernel.perf_event_paranoid).
"""
import argparse
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CALLED_BACK = re.compile(r"intersect_shapes|occluded_by_shapes|rtc[A-Z]|embree")


def shares(options, scene, folder):
    data, picture = folder / "perf.data", folder / "out.exr"
    subprocess.run(["perf", "record", "-q", "-F", "499", "-o", data, options.sundog, "render", scene, "-o", picture, "--size",
                    "512x512", "--integrator", "path", "--max-depth", "8", "--spp", str(options.samples), "-q"],
                   check=True, stderr=subprocess.DEVNULL)
    lines = subprocess.run(["perf", "report", "-i", data, "--stdio", "--sort", "dso,symbol", "-F", "overhead,dso,symbol"],
                           check=True, capture_output=True, text=True).stdout
    embree = kernel = 0.0
    for line in lines.splitlines():
        found = re.match(r"\s*([0-9.]+)%\s+(\S+)\s+\[.\]\s+(.*)", line)
        if not found:
            continue
        share, dso, symbol = float(found[1]), found[2], found[3]
        if "embree" in dso or CALLED_BACK.search(symbol):
            embree += share
        elif "path_tile" in symbol or "extend_path" in symbol or "sundog::kernel" in symbol:
            kernel += share
    return embree, kernel


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=[ROOT / "scenes/cornell/cornell.scene", ROOT / "scenes/table/table.scene"])
    parser.add_argument("--sundog", default=ROOT / "build/release/apps/sundog/sundog")
    parser.add_argument("--samples", type=int, default=64)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes:
            embree, kernel = shares(options, scene, pathlib.Path(folder))
            print(f"{pathlib.Path(scene).name}: Embree {embree:.1f} %, the kernel {kernel:.1f} % of the time; "
                  f"{embree / (embree + kernel):.2f} of raw Embree's rays a second")


if __name__ == "__main__":
    main()
