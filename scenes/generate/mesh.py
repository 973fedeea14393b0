# SPDX-License-Identifier: Apache-2.0
"""Meshes of the gallery: simple solids, written as Wavefront OBJ. Z is up; faces are counter-clockwise seen from outside."""

from math import cos, hypot, pi, radians, sin


def number(value):
    """Shortest decimal with at most five places, so that files stay small and equal on every machine."""
    text = f"{value:.5f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def placed(center, yaw_deg=0.0, scale=1.0):
    """The map that turns a point about Z, scales it and moves it to `center`; directions use the turn alone."""
    c, s = cos(radians(yaw_deg)), sin(radians(yaw_deg))

    def turn(p):
        return (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2])

    def point(p):
        x, y, z = turn(p)
        return (center[0] + scale * x, center[1] + scale * y, center[2] + scale * z)

    return point, turn


class Model:
    """Collects objects; vertices, texture coordinates and normals are shared where they are equal."""

    def __init__(self, title, mtllib):
        self.lines = [f"# {title}", "# Written by scenes/generate/generate.py", f"mtllib {mtllib}"]
        self.pools = {"v": {}, "vt": {}, "vn": {}}
        self.triangle_count = 0

    def object(self, name, material):
        """Starts an object; following faces belong to it."""
        self.lines += [f"o {name}", f"usemtl {material}"]

    def material(self, name):
        """Changes the material inside an object."""
        self.lines.append(f"usemtl {name}")

    def index(self, kind, values):
        key = " ".join(number(v) for v in values)
        pool = self.pools[kind]
        if key not in pool:
            pool[key] = len(pool) + 1
            self.lines.append(f"{kind} {key}")
        return pool[key]

    def face(self, points, texcoords=None, normals=None):
        """A convex polygon; texcoords and normals, where given, one for each corner."""
        corners = []
        for i, p in enumerate(points):
            corner = str(self.index("v", p))
            if texcoords or normals:
                corner += "/" + (str(self.index("vt", texcoords[i])) if texcoords else "")
            if normals:
                corner += "/" + str(self.index("vn", normals[i]))
            corners.append(corner)
        self.lines.append("f " + " ".join(corners))
        self.triangle_count += len(points) - 2

    def text(self):
        return "\n".join(self.lines) + "\n"

    def box(self, lower, upper, place=placed((0, 0, 0)), uv_scale=None):
        """Six quads. uv_scale: texture repeats a unit of length; None for 0..1 on each face."""
        point, _ = place
        (x0, y0, z0), (x1, y1, z1) = lower, upper
        sides = [
            [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],  # -Y
            [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],  # +X
            [(x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1)],  # +Y
            [(x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1)],  # -X
            [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],  # +Z
            [(x0, y1, z0), (x1, y1, z0), (x1, y0, z0), (x0, y0, z0)],  # -Z
        ]
        for quad in sides:
            self.quad([point(p) for p in quad], uv_scale)

    def quad(self, points, uv_scale=None):
        """A parallelogram; the first corner is (0, 0) of the texture, the second lies along u."""
        u = v = 1.0
        if uv_scale:
            edge = [tuple(b - a for a, b in zip(points[0], points[i])) for i in (1, 3)]
            u, v = (uv_scale * hypot(*e) for e in edge)
        self.face(points, [(0, 0), (u, 0), (u, v), (0, v)])

    def sphere(self, center, radius, segments, rings):
        """Latitude and longitude; texture: u eastwards, v from the south pole up. segments*(2*rings-2) triangles."""

        def vertex(i, j):
            polar, azimuth = pi * j / rings, 2 * pi * i / segments
            n = (sin(polar) * cos(azimuth), sin(polar) * sin(azimuth), -cos(polar))
            return tuple(c + radius * k for c, k in zip(center, n)), (i / segments, j / rings), n

        for j in range(rings):
            for i in range(segments):
                corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]
                if j == 0:
                    del corners[1]
                if j == rings - 1:
                    del corners[2]
                self.face(*map(list, zip(*corners)))

    def lathe(self, center, profile, segments, smooth=True, turns_uv=1.0):
        """Turns the profile [(radius, height), …] about the Z-parallel through center; outside lies to the right of the
        profile's direction. Smooth across the turn and, where `smooth`, along the profile too."""
        tangents = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(profile, profile[1:])]
        lengths = [hypot(*t) for t in tangents]
        flat = [(t[1] / d, -t[0] / d) for t, d in zip(tangents, lengths)]
        total = sum(lengths)

        def profile_normal(edge, end):
            other = edge + (1 if end else -1)
            if not smooth or not 0 <= other < len(flat):
                return flat[edge]
            n = (flat[edge][0] + flat[other][0], flat[edge][1] + flat[other][1])
            d = hypot(*n)
            return (n[0] / d, n[1] / d)

        def vertex(i, radius, height, v, normal):
            c, s = cos(2 * pi * i / segments), sin(2 * pi * i / segments)
            return (
                (center[0] + radius * c, center[1] + radius * s, center[2] + height),
                (turns_uv * i / segments, v),
                (normal[0] * c, normal[0] * s, normal[1]),
            )

        along = 0.0
        for edge, ((r0, h0), (r1, h1)) in enumerate(zip(profile, profile[1:])):
            v0, v1 = along / total, (along + lengths[edge]) / total
            along += lengths[edge]
            n0, n1 = profile_normal(edge, False), profile_normal(edge, True)
            for i in range(segments):
                corners = [vertex(i, r0, h0, v0, n0), vertex(i + 1, r0, h0, v0, n0)]
                corners += [vertex(i + 1, r1, h1, v1, n1), vertex(i, r1, h1, v1, n1)]
                if r0 == 0:
                    del corners[1]
                if r1 == 0:
                    del corners[2]
                self.face(*map(list, zip(*corners)))

    def cylinder(self, center, radius, height, segments):
        """Standing on `center`, closed: 4*segments triangles."""
        self.lathe(center, [(radius, 0), (radius, height)], segments)
        self.lathe(center, [(0, 0), (radius, 0)], segments)
        self.lathe(center, [(radius, height), (0, height)], segments)

    def prism(self, polygon, z0, z1, place=placed((0, 0, 0))):
        """A convex polygon (counter-clockwise seen from above) drawn up from z0 to z1, flat faces."""
        point, _ = place
        count = len(polygon)
        low = [point((x, y, z0)) for x, y in polygon]
        high = [point((x, y, z1)) for x, y in polygon]
        for i in range(count):
            j = (i + 1) % count
            self.quad([low[i], low[j], high[j], high[i]])
        self.face(high, [p for p in polygon])
        self.face(low[::-1], [p for p in polygon[::-1]])
