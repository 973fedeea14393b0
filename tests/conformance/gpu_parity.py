#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws POV-Ray scenes on the CPU and on the GPU and tells how alike the pictures are.

    gpu_parity.py SUNDOG FOLDER RESULTS.json [PART ...]

Every .pov file below FOLDER (of which a path contains one of the PARTs, if any are given) is drawn at 160x120, one sample a
pixel, by the program SUNDOG. RESULTS.json is written after each scene and read at the start: scenes that are in it
aren't drawn again, so the work can be stopped and continued. At the end a table of what came of it is printed. A software GPU
compiles its shaders for half a minute and more a scene: some hundred scenes take hours, which is why this is no test.
"""
import collections
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

SIZE = "160x120"
SECONDS = 600
PARITY = 1.0  # percent of the pixels that may differ by more than 2/255


def run(command, folder):
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return -1, f"took longer than {SECONDS} s"
    return done.returncode, done.stdout + done.stderr


def reasons(text):
    """Why a scene isn't drawn, without names and places."""
    found = []
    for line in text.splitlines():
        line = re.sub(r"^(error: )?\S*:\d+:(\d+:)? ?", "", line.strip())
        line = re.sub(r"object '.*?' ", "object ", line)
        if "use --device cpu" in line:
            found.append(line.replace("; use --device cpu", ""))
    return found


def compare(program, scene, scratch):
    pictures = {}
    for device in ("cpu", "gpu"):
        pictures[device] = os.path.join(scratch, device + ".png")
        status, text = run([program, "render", scene, "-o", pictures[device], "--size", SIZE, "--device", device],
                           os.path.dirname(scene))
        if status != 0:
            why = reasons(text)
            if device == "gpu" and why:
                return {"refused": why}
            return {"failed": device + ": " + text.strip()[-300:]}
        if device == "gpu":
            seconds = re.search(r"([\d.]+) s, ", text)
    _, text = run([program, "compare", pictures["cpu"], pictures["gpu"]], scratch)
    different = re.search(r"differing pixels\s+([\d.]+)", text)
    if not different:
        return {"failed": "compare: " + text.strip()[-300:]}
    return {"different": float(different.group(1)), "seconds": float(seconds.group(1)) if seconds else 0}


def main():
    program, folder, results = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3]
    done = json.load(open(results)) if os.path.exists(results) else {}
    scratch = tempfile.mkdtemp()
    # Some scenes write files beside themselves.
    copy = os.path.join(scratch, "scenes")
    shutil.copytree(folder, copy, symlinks=False)
    scenes = sorted(os.path.join(path, name) for path, _, names in os.walk(copy) for name in names
                    if name.endswith(".pov"))
    for scene in scenes:
        name = os.path.relpath(scene, copy)
        if name in done or (sys.argv[4:] and not any(part in name for part in sys.argv[4:])):
            continue
        done[name] = compare(program, scene, scratch)
        print(name, done[name], flush=True)
        with open(results, "w") as file:
            json.dump(done, file, indent=1, sort_keys=True)
    shutil.rmtree(scratch)
    drawn = {name: r for name, r in done.items() if "different" in r}
    alike = [name for name, r in drawn.items() if r["different"] <= PARITY]
    refused = [r for r in done.values() if "refused" in r]
    print(f"{len(done)} scenes: {len(alike)} alike, {len(drawn) - len(alike)} drawn otherwise, {len(refused)} refused, "
          f"{len(done) - len(drawn) - len(refused)} failed")
    for name, r in sorted(drawn.items(), key=lambda item: -item[1]["different"]):
        if r["different"] > PARITY:
            print(f"  {r['different']:7.3f} %  {name}")
    for why, count in collections.Counter(why for r in refused for why in set(r["refused"])).most_common():
        print(f"  {count:4}  {why}")


if __name__ == "__main__":
    main()
