# SPDX-License-Identifier: Apache-2.0
"""The gallery's models: one function an OBJ file. Lengths in scene units; the .scene files place cameras and lights."""

from math import cos, pi, radians, sin

from mesh import Model, placed


def table():
    """Three cubes, a cylinder, a sphere and a floor: 1,126 triangles."""
    m = Model("The table", "table.mtl")
    m.object("floor", "slate")
    m.quad([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)])
    half = 0.5
    for name, material, center, yaw_deg, size in [
        ("red_cube", "vermilion", (-1.58, 0.86, 0.6), 14, 1.2),
        ("gold_cube", "gold", (-1.46, 0.9, 1.55), 42, 0.7),
        ("teal_cube", "teal", (0.56, -1.65, 0.36), 30, 0.72),
    ]:
        m.object(name, material)
        m.box((-half, -half, -half), (half, half, half), placed(center, yaw_deg, size))
    m.object("cylinder", "ivory")
    m.cylinder((2.04, 0.02, 0), 0.46, 2.1, 32)
    m.object("sphere", "chrome")
    m.sphere((0.2, 0.02, 0.92), 0.92, 32, 16)
    return m


# The measured box of Cornell University's Program of Computer Graphics, here in units of 100 mm with X to the right,
# Y away from the camera and Z up: classic (x, y, z) becomes (2.764 - x/100, z/100, y/100).
def classic(x, z):
    return (2.764 - x / 100, z / 100)


def cornell():
    """The Cornell box with its two blocks. The tall one is a mirror, turned by 17 degrees more than the original's, so that
    it shows a coloured wall. The ball on the short one is in the .scene file."""
    m = Model("The Cornell box", "cornell.mtl")
    left, right, back, top = -2.764, 2.764, 5.592, 5.488
    m.object("floor", "white")
    m.quad([(left, 0, 0), (right, 0, 0), (right, back, 0), (left, back, 0)])
    m.object("ceiling", "white")
    m.quad([(left, back, top), (right, back, top), (right, 0, top), (left, 0, top)])
    m.object("back_wall", "white")
    m.quad([(left, back, 0), (right, back, 0), (right, back, top), (left, back, top)])
    m.object("left_wall", "red")
    m.quad([(left, 0, 0), (left, back, 0), (left, back, top), (left, 0, top)])
    m.object("right_wall", "green")
    m.quad([(right, back, 0), (right, 0, 0), (right, 0, top), (right, back, top)])
    m.object("lamp_panel", "glow")
    (x1, y0), (x0, y1) = classic(213, 227), classic(343, 332)
    m.quad([(x0, y1, top - 0.01), (x1, y1, top - 0.01), (x1, y0, top - 0.01), (x0, y0, top - 0.01)])
    m.object("short_block", "white")
    m.prism([classic(130, 65), classic(82, 225), classic(240, 272), classic(290, 114)], 0, 1.65)
    m.object("tall_block", "mirror")
    tall = [classic(423, 247), classic(265, 296), classic(314, 456), classic(472, 406)]
    cx, cy = (sum(p[k] for p in tall) / 4 for k in (0, 1))
    m.prism([(x - cx, y - cy) for x, y in tall], 0, 3.30, placed((cx, cy, 0), 17))
    return m


def mirrors():
    """A square hall whose four walls are mirrors in dark frames; columns, glowing ceiling panels, a plinth."""
    m = Model("The hall of mirrors", "mirrors.mtl")
    a, top = 4.0, 4.2
    m.object("floor", "tiles")
    m.quad([(-a, -a, 0), (a, -a, 0), (a, a, 0), (-a, a, 0)])
    m.object("ceiling", "night")
    m.quad([(-a, a, top), (a, a, top), (a, -a, top), (-a, -a, top)])
    corners = [(-a, -a), (a, -a), (a, a), (-a, a)]
    for name, i in [("south", 0), ("east", 1), ("north", 2), ("west", 3)]:
        (x0, y0), (x1, y1) = corners[i], corners[(i + 1) % 4]
        m.object(f"{name}_mirror", "silver")
        m.quad([(x1, y1, 0), (x0, y0, 0), (x0, y0, top), (x1, y1, top)])
    m.object("skirting", "bronze")
    for low, high in [(0.0, 0.12), (top - 0.16, top)]:
        t = 0.05
        m.box((-a, -a, low), (a, -a + t, high))
        m.box((-a, a - t, low), (a, a, high))
        m.box((-a, -a + t, low), (-a + t, a - t, high))
        m.box((a - t, -a + t, low), (a, a - t, high))
    m.object("panels", "panel")
    for x in (-2, 2):
        for y in (-2, 2):
            s, z = 0.55, top - 0.02
            m.quad([(x - s, y + s, z), (x + s, y + s, z), (x + s, y - s, z), (x - s, y - s, z)])
    for i, (x, y) in enumerate([(-2.6, -2.6), (2.6, -2.6), (2.6, 2.6), (-2.6, 2.6)]):
        m.object(f"column_{i + 1}", "marble")
        m.box((-0.42, -0.42, 0), (0.42, 0.42, 0.16), placed((x, y, 0)))
        m.box((-0.42, -0.42, top - 0.16), (0.42, 0.42, top), placed((x, y, 0)))
        shaft = [(0.36, 0.16), (0.36, 0.22), (0.29, 0.34)]
        steps = 6
        shaft += [(0.29 - 0.05 * (k / steps) ** 2, 0.34 + (top - 0.86) * k / steps) for k in range(1, steps + 1)]
        shaft += [(0.36, top - 0.30), (0.36, top - 0.16)]
        m.lathe((x, y, 0), shaft, 24)
    m.object("plinth", "marble")
    m.box((-0.5, -0.5, 0), (0.5, 0.5, 0.14))
    m.box((-0.36, -0.36, 0.14), (0.36, 0.36, 0.86))
    m.box((-0.46, -0.46, 0.86), (0.46, 0.46, 0.98))
    return m


def mirrors_crystal():
    """The octahedron that turns above the plinth: an object of its own, so that it can move."""
    m = Model("The crystal in the hall of mirrors", "mirrors.mtl")
    m.object("crystal", "crystal")
    r, z, h = 0.42, 1.72, 0.62
    ring = [(r * cos(pi * k / 2), r * sin(pi * k / 2), z) for k in range(4)]
    for k in range(4):
        m.face([ring[k], ring[(k + 1) % 4], (0, 0, z + h)])
        m.face([ring[(k + 1) % 4], ring[k], (0, 0, z - h)])
    return m


def glass():
    """A checkered floor with a slab, a prism and a bowl of coloured glass; the balls are in the .scene file."""
    m = Model("Glass", "glass.mtl")
    m.object("floor", "checks")
    m.quad([(-12, -12, 0), (12, -12, 0), (12, 12, 0), (-12, 12, 0)])
    # All stand a little above the floor: where faces coincide, rounding decides which one a ray inside the glass meets.
    above = 0.005
    m.object("slab", "amber")
    m.box((-1.1, -0.09, above), (1.1, 0.09, 2.5), placed((-1.55, 1.55, 0), 28))
    m.object("prism", "emerald")
    corner = [(0.78 * cos(radians(a)), 0.78 * sin(radians(a))) for a in (0, 120, 240)]
    m.prism(corner, above, 1.9, placed((1.95, 0.85, 0), 40))
    m.object("bowl", "sapphire")
    outer, wall, steps = 0.85, 0.09, 12
    angles = [-pi / 2 + (pi / 2 - 0.06) * k / steps for k in range(steps + 1)]
    profile = [(max(outer * cos(t), 0.0), outer * sin(t)) for t in angles]
    profile[0] = (0.0, -outer)
    inner = outer - wall
    profile += [(outer - wall / 2, -0.012)]
    profile += [(inner * cos(t), inner * sin(t)) for t in reversed(angles)]
    profile[-1] = (0.0, -inner)
    m.lathe((1.25, -1.35, outer + above), profile, 40)
    return m


def textured():
    """A corner of a store: brick wall, tiled floor, a crate, a tin and a lampshade with stars cut out."""
    m = Model("Textures", "textured.mtl")
    m.object("floor", "tiles")
    m.quad([(-7, -9, 0), (7, -9, 0), (7, 2.2, 0), (-7, 2.2, 0)], 0.5)
    m.object("wall", "brick")
    m.quad([(-7, 2.2, 0), (7, 2.2, 0), (7, 2.2, 6), (-7, 2.2, 6)], 0.42)
    m.object("crate", "crate")
    m.box((-0.8, -0.8, 0), (0.8, 0.8, 1.6), placed((-1.7, 0.75, 0), 18))
    m.object("tin", "label")
    tin = (-1.55, 0.62, 1.6)
    m.lathe((tin[0], tin[1], tin[2] + 0.06), [(0.4, 0), (0.4, 0.92)], 48)
    m.material("tinplate")
    for z in (0.0, 0.98):
        m.lathe((tin[0], tin[1], tin[2] + z), [(0.4, 0), (0.42, 0.015), (0.42, 0.045), (0.4, 0.06)], 48)
    m.lathe((tin[0], tin[1], tin[2] + 1.0), [(0.4, 0), (0, 0)], 48)
    m.object("shade", "stars")
    m.lathe((0.35, -0.35, 0.12), [(0.5, 0), (0.5, 1.45)], 48, turns_uv=3.0)
    m.object("lamp_foot", "brass")
    m.cylinder((0.35, -0.35, 0), 0.56, 0.12, 48)
    m.object("globe_foot", "brass")
    m.lathe((2.1, 0.45, 0), [(0.55, 0), (0.55, 0.08), (0.12, 0.16), (0.07, 0.5)], 32, smooth=False)
    return m


def textured_globe():
    """The globe, which turns."""
    m = Model("The globe", "textured.mtl")
    m.object("globe", "globe")
    m.sphere((2.1, 0.45, 1.22), 0.78, 48, 24)
    return m


MODELS = {
    "table/table.obj": table,
    "cornell/cornell.obj": cornell,
    "mirrors/mirrors.obj": mirrors,
    "mirrors/crystal.obj": mirrors_crystal,
    "glass/glass.obj": glass,
    "textured/textured.obj": textured,
    "textured/globe.obj": textured_globe,
}
