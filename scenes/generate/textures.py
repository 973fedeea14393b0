# SPDX-License-Identifier: Apache-2.0
"""The textures of scenes/textured: one function a PNG file. Colours are sRGB values from 0 to 1."""

from functools import lru_cache
from math import atan2, cos, floor, hypot, pi, sin, sqrt

from picture import Picture, fractal, hashed, mix, shade


# The crate's face in units of its width: a frame and a brace of boards over upright planks.
def crate_part(u, v):
    """Which board covers (u, v): (number, along the grain, across it from 0 to 1, height)."""
    frame, brace = 0.15, 0.07
    if v < frame or v > 1 - frame:
        return (1 if v < frame else 2), u, (v if v < frame else v - 1 + frame) / frame, 1.0
    if u < frame or u > 1 - frame:
        return (3 if u < frame else 4), v, (u if u < frame else u - 1 + frame) / frame, 1.0
    diagonal = (u - v) / sqrt(2)
    if abs(diagonal) < brace:
        return 5, (u + v) / sqrt(2), diagonal / (2 * brace) + 0.5, 0.85
    inside = (u - frame) / (1 - 2 * frame) * 4
    plank = floor(inside)
    return 6 + plank, v, inside - plank, 0.45


def crate_edge(across):
    """0 in the gap between boards, 1 on them."""
    return min(min(across, 1 - across) / 0.07, 1.0)


def crate_color(x, y):
    u, v = (x + 0.5) / 256, (y + 0.5) / 256
    part, along, across, _ = crate_part(u, v)
    bend = fractal(along * 3 + part * 7, across * 1.5, part, 4096, 2)
    grain = fractal(along * 2.5 + part * 13, across * 9 + bend * 5, 40 + part, 4096, 2)
    color = mix((0.80, 0.60, 0.36), (0.55, 0.35, 0.17), round(grain * 20) / 20 * 1.5 - 0.25)
    color = shade(color, 0.86 + 0.2 * hashed(part, 3, 9))
    corner_u, corner_v = min(u, 1 - u), min(v, 1 - v)
    if hypot(corner_u - 0.075, corner_v - 0.075) < 0.014:
        color = (0.22, 0.2, 0.2)
    return shade(color, 0.35 + 0.65 * crate_edge(across))


def crate_height(x, y):
    part, _, across, height = crate_part((x + 0.5) / 256, (y + 0.5) / 256)
    return height * crate_edge(across) ** 0.5


# Bricks in running bond: 4 across and 8 courses in a tile.
def brick_part(u, v):
    """(column, course, distance to the brick's edge in units of a course)."""
    course = floor(v * 8)
    across = u * 4 + (0.5 if course % 2 else 0.0)
    column = floor(across) % 4
    fu, fv = across - floor(across), v * 8 - course
    return column, course, min(min(fu, 1 - fu) * 2, min(fv, 1 - fv))


@lru_cache(maxsize=None)
def brick_height(x, y):
    u, v = (x % 256 + 0.5) / 256, (y % 256 + 0.5) / 256
    column, course, edge = brick_part(u, v)
    rough = fractal(u * 16, v * 16, 70, 16, 2)
    face = min(max((edge - 0.07) / 0.09, 0.0), 1.0)
    return face * (0.8 + 0.2 * rough + 0.12 * hashed(column, course, 5)) + (1 - face) * 0.12 * rough


def brick_color(x, y):
    u, v = (x + 0.5) / 256, (y + 0.5) / 256
    column, course, edge = brick_part(u, v)
    speck = round(fractal(u * 20, v * 20, 71, 20, 2) * 14) / 14
    if edge < 0.09:
        return shade((0.66, 0.62, 0.56), 0.8 + 0.3 * speck)
    tone = hashed(column, course, 6)
    color = mix((0.62, 0.26, 0.17), (0.74, 0.42, 0.27), tone)
    return shade(color, 0.72 + 0.4 * speck)


def brick_normal(x, y):
    """Tangent-space normal, green upwards."""
    strength = 256 / 2 * 0.02
    slope_u = (brick_height(x + 1, y) - brick_height(x - 1, y)) * strength
    slope_v = (brick_height(x, y - 1) - brick_height(x, y + 1)) * strength
    size = sqrt(slope_u * slope_u + slope_v * slope_v + 1)
    return tuple(round((c / size * 0.5 + 0.5) * 64) / 64 for c in (-slope_u, -slope_v, 1.0))


LETTERS = {  # 5 by 7 dots
    "S": ("01111", "10000", "10000", "01110", "00001", "00001", "11110"),
    "U": ("10001", "10001", "10001", "10001", "10001", "10001", "01110"),
    "N": ("10001", "11001", "10101", "10101", "10011", "10001", "10001"),
    "D": ("11110", "10001", "10001", "10001", "10001", "10001", "11110"),
    "O": ("01110", "10001", "10001", "10001", "10001", "10001", "01110"),
    "G": ("01110", "10001", "10000", "10111", "10001", "10001", "01110"),
}


def label_color(x, y):
    """Twice around the tin: the sun in its halo with a sundog on each side, and the name below."""
    cream, red, night, gold = (0.95, 0.90, 0.78), (0.72, 0.10, 0.08), (0.10, 0.16, 0.34), (0.98, 0.78, 0.25)
    x %= 256
    if y < 14 or y >= 178:
        return red
    if y < 20 or 172 <= y < 178:
        return gold
    if y >= 122:
        column, row = (x - 56) // 4, (y - 132) // 4
        if 0 <= column < 36 and 0 <= row < 7 and column % 6 < 5:
            if LETTERS["SUNDOG"[column // 6]][row][column % 6] == "1":
                return cream
        return red
    dx, dy = x - 127.5, y - 71.0
    radius = hypot(dx, dy)
    sky = mix(night, (0.30, 0.46, 0.70), (y - 20) / 102)
    sky = mix(sky, cream, 0.8 - abs(radius - 40) / 3)
    for side in (-44, 44):
        spot = hypot((dx - side) * 0.8, dy)
        sky = mix(sky, (0.99, 0.86, 0.55), 1.5 - spot / 7)
    rays = 13 + 4 * cos(atan2(dy, dx) * 12)
    return mix(sky, gold, rays - radius + 0.5)


def globe_color(x, y):
    u, v = x / 384, (y + 0.5) / 192
    latitude = pi * (0.5 - v)
    stretch = 6 * cos(latitude) + 0.5
    height = fractal(u * 8, v * 5 + 3, 21, 8, 5) + 0.05 * sin(u * 4 * pi + stretch)
    cold = abs(latitude) / (pi / 2)
    if cold > 0.79 and cold + 0.12 * (fractal(u * 16, v * 8, 31, 16, 2) - 0.5) > 0.86:
        return (0.93, 0.95, 0.97)
    if height < 0.43:
        depth = round((0.43 - height) * 60) / 60
        color = mix((0.24, 0.56, 0.74), (0.06, 0.22, 0.46), depth * 6)
    else:
        color = mix((0.34, 0.55, 0.22), (0.70, 0.56, 0.32), round((height - 0.43) * 60) / 60 * 7)
        color = mix(color, (0.88, 0.84, 0.76), (height - 0.62) * 14)
    meridian = min((u * 24) % 1, 1 - (u * 24) % 1) / 24 * 384
    parallel = min((v * 12) % 1, 1 - (v * 12) % 1) / 12 * 192
    return shade(color, 0.8) if min(meridian, parallel) < 0.6 else color


def star_opacity(x, y):
    """A five-pointed star and small round holes are cut out (0) of the solid shade (1); smooth edges."""

    def star(cx, cy, size, turn):
        dx, dy = (x + 0.5) / 128 - cx, (y + 0.5) / 128 - cy
        angle = (atan2(dx, -dy) + turn) % (2 * pi / 5) - pi / 5
        radius = hypot(dx, dy)
        # The edge from a tip (radius `size`) to a notch (radius 0.42 size), as a straight line.
        px, py = radius * cos(angle), radius * abs(sin(angle))
        notch_x, notch_y = 0.42 * size, 0.0
        tip_x, tip_y = size * cos(pi / 5), size * sin(pi / 5)
        nx, ny = tip_y - notch_y, notch_x - tip_x
        return ((px - notch_x) * nx + (py - notch_y) * ny) / hypot(nx, ny)

    def disk(cx, cy, radius):
        return hypot((x + 0.5) / 128 - cx, (y + 0.5) / 128 - cy) - radius

    holes = [star(0.5, 0.5, 0.27, 0.0), star(0.0, 1.0, 0.2, 0.0), star(1.0, 1.0, 0.2, 0.0)]
    holes += [star(0.5, 1.5, 0.27, 0.0)]
    for cx, cy in [(0.0, 0.35), (1.0, 0.35), (0.5, 1.0), (0.0, 1.65), (1.0, 1.65), (0.22, 0.72), (0.78, 0.72)]:
        holes.append(disk(cx, cy, 0.06))
    holes += [disk(0.22, 1.28, 0.06), disk(0.78, 1.28, 0.06)]
    return min(max(0.5 + min(holes) * 100, 0.0), 1.0)


TEXTURES = {
    "textured/crate.png": lambda: Picture(256, 256, crate_color),
    "textured/crate_height.png": lambda: Picture(256, 256, crate_height),
    "textured/brick.png": lambda: Picture(256, 256, brick_color),
    "textured/brick_normal.png": lambda: Picture(256, 256, brick_normal),
    "textured/label.png": lambda: Picture(512, 192, label_color),
    "textured/globe.png": lambda: Picture(384, 192, globe_color),
    "textured/stars.png": lambda: Picture(128, 256, star_opacity),
}
