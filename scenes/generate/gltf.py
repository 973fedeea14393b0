# SPDX-License-Identifier: Apache-2.0
"""A writer of small glTF 2.0 files with everything in them. Y is up, as glTF has it."""

import base64
import json
import struct
import zlib
from math import cos, pi, sin

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
FLOAT = 5126


def rounded(value):
    """So that files are the same on every machine."""
    return round(value, 5) + 0.0


def png(width, height, pixels):
    """An RGBA picture that isn't compressed, so that no library's version shows. `pixels`: rows from the top."""
    raw = b"".join(b"\0" + bytes(c for x in range(width) for c in pixels(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    stored = b"\x78\x01\x01" + struct.pack("<HH", len(raw), 65535 - len(raw)) + raw + struct.pack(">I", zlib.adler32(raw))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", stored) + chunk(b"IEND", b"")


class Asset:
    """Collects a file's parts; each method returns the part's number."""

    def __init__(self):
        self.root = {"asset": {"version": "2.0", "generator": "scenes/generate/generate.py"}}
        self.bytes = b""

    def add(self, kind, **part):
        self.root.setdefault(kind, []).append(part)
        return len(self.root[kind]) - 1

    def use(self, *extensions, required=False):
        for kind in ["extensionsUsed"] + ["extensionsRequired"] * required:
            known = self.root.setdefault(kind, [])
            known += [e for e in extensions if e not in known]

    def view(self, data, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.bytes += data
        return self.add("bufferViews", buffer=0, byteOffset=len(self.bytes) - len(data), byteLength=len(data), **more)

    def packed(self, rows, component=FLOAT):
        form = FORMATS[component]
        return b"".join(struct.pack("<" + form, rounded(v) if form == "f" else v) for row in rows for v in row)

    def accessor(self, rows, component=FLOAT, **more):
        rows = [row if isinstance(row, (tuple, list)) else (row,) for row in rows]
        width = len(rows[0])
        # Vertices' numbers begin at multiples of four bytes.
        size = struct.calcsize(FORMATS[component]) * width
        stride = {}
        if width > 1 and size % 4:
            form = f"<{width}{FORMATS[component]}{4 - size % 4}x"
            data = b"".join(struct.pack(form, *row) for row in rows)
            stride = {"byteStride": struct.calcsize(form)}
        else:
            data = self.packed(rows, component)
        if component == FLOAT and width == 3:
            more.setdefault("min", [min(rounded(row[i]) for row in rows) for i in range(3)])
            more.setdefault("max", [max(rounded(row[i]) for row in rows) for i in range(3)])
        return self.add("accessors", bufferView=self.view(data, **stride), componentType=component, count=len(rows),
                        type=TYPES[width], **more)

    def primitive(self, shape, material=None, **more):
        """Of positions, normals, texture coordinates and corners."""
        positions, normals, uvs, corners = shape
        attributes = {"POSITION": self.accessor(positions), "NORMAL": self.accessor(normals),
                      "TEXCOORD_0": self.accessor(uvs)}
        part = {"attributes": attributes, "indices": self.accessor(corners, 5123), **more}
        if material is not None:
            part["material"] = material
        return part

    def mesh(self, shape, material=None, **more):
        return self.add("meshes", primitives=[self.primitive(shape, material)], **more)

    def texture(self, picture, **sampler):
        image = self.add("images", bufferView=self.view(picture), mimeType="image/png")
        return {"index": self.add("textures", source=image, **({"sampler": self.add("samplers", **sampler)} if sampler else {}))}

    def material(self, color=None, metallic=0, roughness=1, **more):
        pbr = {"metallicFactor": metallic, "roughnessFactor": roughness}
        if color is not None:
            pbr["baseColorFactor" if isinstance(color, list) else "baseColorTexture"] = color
        return self.add("materials", pbrMetallicRoughness=pbr, **more)

    def light(self, kind, intensity, color=(1, 1, 1), **more):
        self.use("KHR_lights_punctual")
        lights = self.root.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"type": kind, "intensity": intensity, "color": list(color), **more})
        return {"KHR_lights_punctual": {"light": len(lights) - 1}}

    def animate(self, times, *channels):
        """Channels of (node, path, values, interpolation)."""
        samplers, targets = [], []
        for node, path, values, mode in channels:
            samplers.append({"input": self.accessor(times), "output": self.accessor(values), "interpolation": mode})
            targets.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
        return self.add("animations", samplers=samplers, channels=targets)

    def show(self, *nodes):
        self.root["scenes"] = [{"nodes": list(nodes)}]
        self.root["scene"] = 0

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        self.root["buffers"] = [{"byteLength": len(self.bytes), "uri": uri}]
        parts = ",\n".join(f"  {json.dumps(k)}: " + self.lines(v) for k, v in self.root.items())
        return ("{\n" + parts + "\n}\n").encode()

    @staticmethod
    def lines(value):
        """Lists with an element a line."""
        if isinstance(value, list):
            return "[\n" + ",\n".join("    " + json.dumps(v) for v in value) + "\n  ]"
        return json.dumps(value)

    def binary(self):
        self.root["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.root).encode()
        text += b" " * (-len(text) % 4)
        data = self.bytes + b"\0" * (-len(self.bytes) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def turn(axis, angle_deg):
    """A quaternion about the x, y or z axis (0 to 2)."""
    half = angle_deg * pi / 360
    q = [0, 0, 0, rounded(cos(half))]
    q[axis] = rounded(sin(half))
    return q


def quad(width, height, repeat=1):
    """Upright, facing +Z."""
    x, y = width / 2, height / 2
    return ([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], [(0, 0, 1)] * 4,
            [(0, repeat), (repeat, repeat), (repeat, 0), (0, 0)], [0, 1, 2, 0, 2, 3])


def floor(size, repeat=1):
    h = size / 2
    return ([(-h, 0, h), (h, 0, h), (h, 0, -h), (-h, 0, -h)], [(0, 1, 0)] * 4,
            [(0, repeat), (repeat, repeat), (repeat, 0), (0, 0)], [0, 1, 2, 0, 2, 3])


def box(size=1, steps=1):
    """Around the origin; each side of steps * steps squares."""
    positions, normals, uvs, corners = [], [], [], []
    for axis in range(3):
        for sign in (1, -1):
            u, v = [(1, 2), (2, 0), (0, 1)][axis]
            first = len(positions)
            for j in range(steps + 1):
                for i in range(steps + 1):
                    p, n = [0, 0, 0], [0, 0, 0]
                    p[axis], n[axis] = sign * size / 2, sign
                    p[u], p[v] = size * (i / steps - 0.5) * sign, size * (j / steps - 0.5)
                    positions.append(tuple(p))
                    normals.append(tuple(n))
                    uvs.append((i / steps, 1 - j / steps))
            for j in range(steps):
                for i in range(steps):
                    a = first + j * (steps + 1) + i
                    b, c, d = a + 1, a + steps + 2, a + steps + 1
                    corners += [a, b, c, a, c, d]
    return positions, normals, uvs, corners


def sphere(radius=1, around=24, rings=12):
    positions, normals, uvs, corners = [], [], [], []
    for j in range(rings + 1):
        for i in range(around + 1):
            theta, phi = pi * j / rings, 2 * pi * i / around
            n = (sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi))
            normals.append(n)
            positions.append(tuple(radius * c for c in n))
            uvs.append((i / around, j / rings))
    for j in range(rings):
        for i in range(around):
            a = j * (around + 1) + i
            b = a + around + 1
            corners += ([a, b, b + 1] if j < rings - 1 else []) + ([a, b + 1, a + 1] if j > 0 else [])
    return positions, normals, uvs, corners
