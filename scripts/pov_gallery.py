#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the contact sheets of docs/pov-gallery.md: the scenes of tests/conformance, ours left, povray's right.

    pov_gallery.py PROGRAM

Needs povray and Pillow (Debian: povray povray-includes python3-pil).
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

ROOT = pathlib.Path(__file__).resolve().parent.parent
GROUPS = {"shapes": ("shape_",), "cameras": ("camera_",), "lights": ("light_", "fog_", "sky_"),
          "patterns": ("pigment_", "texture_"), "normals": ("normal_",), "finishes": ("finish_", "interior_")}
WIDTH, HEIGHT, TEXT, GAP, COLUMNS = 104, 78, 12, 4, 4


def draw(command, scene, picture):
    subprocess.run([*command, f"+I{scene}", f"+O{picture}", f"+W{WIDTH}", f"+H{HEIGHT}", "+A0.1", "-D", "-GA"],
                   cwd=scene.parent, stdin=subprocess.DEVNULL, capture_output=True, check=True, timeout=120)
    return Image.open(picture).convert("RGB")


def sheet(program, scenes, work):
    rows = (len(scenes) + COLUMNS - 1) // COLUMNS
    cell = (2 * WIDTH + 3 * GAP, HEIGHT + TEXT + GAP)
    image = Image.new("RGB", (COLUMNS * cell[0], rows * cell[1]), (32, 32, 32))
    pen = ImageDraw.Draw(image)
    for i, scene in enumerate(scenes):
        x, y = i % COLUMNS * cell[0] + GAP, i // COLUMNS * cell[1]
        pen.text((x, y), scene.stem, fill=(230, 230, 230))
        image.paste(draw([program, "pov"], scene, work / "ours.png"), (x, y + TEXT))
        image.paste(draw(["povray"], scene, work / "theirs.png"), (x + WIDTH + GAP, y + TEXT))
    return image


def main():
    program = str(pathlib.Path(sys.argv[1]).absolute())
    scenes = sorted((ROOT / "tests" / "conformance" / "scenes").glob("*.pov"))
    with tempfile.TemporaryDirectory() as name:
        for group, starts in GROUPS.items():
            chosen = [s for s in scenes if s.stem.startswith(starts)]
            image = sheet(program, chosen, pathlib.Path(name))
            image.save(ROOT / "docs" / "images" / f"pov-{group}.jpg", quality=66, optimize=True)
            print(f"{group}: {len(chosen)} scenes")


if __name__ == "__main__":
    main()
