#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the gallery's models and textures into scenes/ (Python 3, standard library only).

    generate.py           write all files
    generate.py --check   write nothing; say which files differ from what would be written, and exit with 1 if any does
"""

import sys
from pathlib import Path

from gltf_attributes import ATTRIBUTES
from gltf_models import GLTF
from models import MODELS
from picture import unpacked
from textures import TEXTURES

SCENES = Path(__file__).resolve().parent.parent


def contents():
    """(file, bytes) of everything, one after the other."""
    for name, make in MODELS.items():
        yield SCENES / name, make().text().encode()
    for name, make in TEXTURES.items():
        yield SCENES / name, make().png()
    for name, make in {**GLTF, **ATTRIBUTES}.items():
        yield SCENES / name, make()


def equal(file, wanted):
    """Equal content; of a PNG, equal pixels (zlib's versions compress differently)."""
    if not file.is_file():
        return False
    found = file.read_bytes()
    return unpacked(found) == unpacked(wanted) if file.suffix == ".png" else found == wanted


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    differing = 0
    for file, wanted in contents():
        if not arguments:
            file.parent.mkdir(exist_ok=True)
            file.write_bytes(wanted)
        elif not equal(file, wanted):
            print(f"{file} is not what generate.py writes")
            differing += 1
    return 1 if differing else 0


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    sys.exit(main(sys.argv[1:]))
