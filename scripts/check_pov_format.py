#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that `sundog pov --format` prints scenes that give the same pictures, byte by byte.

    check_pov_format.py PROGRAM [FOLDER [PART-OF-NAME]]

Takes all *.pov below FOLDER (povray-examples) that can be drawn. Each is formatted, and the text drawn from the scene's
own folder, as it names its images and fonts by where they lie. Exits with 1 if any picture differs.
"""
import pathlib
import subprocess
import sys
import tempfile

SIZE = ["+W48", "+H36", "-A", "-D", "-GA", "--device", "cpu"]
TIMEOUT_S = 300


def call(program, words, folder):
    return subprocess.run([program, "pov", *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                          timeout=TIMEOUT_S)


def judge(program, scene, work):
    pictures = [work / "written.png", work / "formatted.png"]
    for picture in pictures:
        picture.unlink(missing_ok=True)
    if call(program, [*SIZE, f"+I{scene.name}", f"+O{pictures[0]}"], scene.parent).returncode != 0:
        return "not drawn"
    text = call(program, [*SIZE, f"+I{scene.name}", "--format"], scene.parent)
    if text.returncode != 0:
        return "not formatted"
    formatted = work / "formatted.pov"
    formatted.write_bytes(text.stdout)
    again = call(program, [*SIZE, f"+I{formatted}", f"+L{scene.parent}", f"+O{pictures[1]}"], scene.parent)
    if again.returncode != 0:
        return "not read: " + again.stderr.decode(errors="replace").split("\n")[0]
    return "same" if pictures[0].read_bytes() == pictures[1].read_bytes() else "another picture"


def main():
    program = str(pathlib.Path(sys.argv[1]).absolute())
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "/usr/share/doc/povray/examples")
    if not folder.is_dir():
        print(f"skipped: there is no {folder} (Debian: povray-examples)")
        return 0
    counts = {}
    with tempfile.TemporaryDirectory() as name:
        for scene in sorted(folder.rglob("*.pov")):
            if len(sys.argv) > 3 and sys.argv[3] not in str(scene):
                continue
            try:
                verdict = judge(program, scene, pathlib.Path(name))
            except subprocess.TimeoutExpired:
                verdict = "too slow"
            counts[verdict.split(":")[0]] = counts.get(verdict.split(":")[0], 0) + 1
            if verdict not in ("same", "not drawn"):
                print(f"{scene.relative_to(folder)}: {verdict}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))
    return 0 if set(counts) <= {"same", "not drawn"} else 1


if __name__ == "__main__":
    sys.exit(main())
