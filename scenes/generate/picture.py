# SPDX-License-Identifier: Apache-2.0
"""Textures of the gallery: value noise and a PNG writer, with nothing but the standard library."""

import struct
import zlib
from functools import lru_cache
from math import floor


@lru_cache(maxsize=None)
def hashed(x, y, seed):
    """A number in 0..1 from two integers (multiply and xor-shift, 32 bits)."""
    h = (x * 374761393 + y * 668265263 + seed * 2246822519) & 0xFFFFFFFF
    h = ((h ^ (h >> 15)) * 2246822519) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 3266489917) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFF) / 65535.0


def noise(x, y, seed, period_x):
    """Smooth value noise in 0..1 that repeats after period_x cells in x."""
    x0, y0 = floor(x), floor(y)
    fx, fy = x - x0, y - y0
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    left, right = x0 % period_x, (x0 + 1) % period_x
    low, high = hashed(left, y0, seed), hashed(left, y0 + 1, seed)
    low += (hashed(right, y0, seed) - low) * fx
    high += (hashed(right, y0 + 1, seed) - high) * fx
    return low + (high - low) * fy


def fractal(x, y, seed, period_x, octaves):
    """Sum of octaves of noise, 0..1."""
    total = weight = 0.0
    for octave in range(octaves):
        scale = 1 << octave
        total += noise(x * scale, y * scale, seed + octave, period_x * scale) / scale
        weight += 1.0 / scale
    return total / weight


def mix(a, b, t):
    """Between two colours (or numbers), t clamped to 0..1."""
    t = min(max(t, 0.0), 1.0)
    if isinstance(a, tuple):
        return tuple(p + (q - p) * t for p, q in zip(a, b))
    return a + (b - a) * t


def shade(color, factor):
    return tuple(c * factor for c in color)


def byte(value):
    return min(max(int(value * 255 + 0.5), 0), 255)


class Picture:
    """8-bit grey (1 channel) or RGB (3 channels) pixels; (0, 0) is the top left."""

    def __init__(self, width, height, pixel):
        """pixel(x, y) gives a number or a tuple of three, 0..1 (colours as sRGB values)."""
        self.width, self.height = width, height
        values = [pixel(x, y) for y in range(height) for x in range(width)]
        self.channels = 3 if isinstance(values[0], tuple) else 1
        self.data = bytes(byte(c) for v in values for c in (v if self.channels == 3 else (v,)))

    def png(self):
        """PNG (ISO/IEC 15948), each row by the filter with the smallest sum of absolute differences."""
        stride, rows = self.width * self.channels, []
        before = bytes(stride)
        for y in range(self.height):
            row = self.data[y * stride : (y + 1) * stride]
            left = bytes(self.channels) + row[: -self.channels]
            candidates = [
                row,
                bytes((a - b) & 255 for a, b in zip(row, left)),
                bytes((a - b) & 255 for a, b in zip(row, before)),
            ]
            best = min(range(3), key=lambda k: sum(min(v, 256 - v) for v in candidates[k]))
            rows.append(bytes([best]) + candidates[best])
            before = row
        color_type = 2 if self.channels == 3 else 0
        header = struct.pack(">IIBBBBB", self.width, self.height, 8, color_type, 0, 0, 0)
        body = zlib.compress(b"".join(rows), 9)

        def chunk(name, content):
            return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", body) + chunk(b"IEND", b"")


def unpacked(png):
    """A PNG's chunks with the IDAT inflated: equal for equal pixels whatever zlib wrote them."""
    chunks, at = [], 8
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at : at + 8])
        content = png[at + 8 : at + 8 + size]
        chunks.append((name, zlib.decompress(content) if name == b"IDAT" else content))
        at += size + 12
    return chunks
