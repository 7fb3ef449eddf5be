#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""make_islands.py FOLDER: writes the sets of islands that bench_islands packs: charts of meshes that are made here, as masks. A
chart holds the triangles around one that face nearly the same way, laid flat; its mask the texels that bilinear filtering reads
of them. A set has for each island a line `island WIDTH HEIGHT`, then for each row a line of its runs: first column, column
after the last, and so on."""
import heapq
import math
import random
import sys
from pathlib import Path


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def unit(a):
    length = math.sqrt(dot(a, a)) or 1
    return [x / length for x in a]


class Mesh:
    def __init__(self):
        self.points, self.faces, self.known = [], [], {}

    def point(self, p):
        key = tuple(round(c, 6) for c in p)
        if key not in self.known:
            self.known[key] = len(self.points)
            self.points.append(list(p))
        return self.known[key]

    def face(self, *corners):
        row = [self.point(c) for c in corners]
        for i in range(1, len(row) - 1):
            if len({row[0], row[i], row[i + 1]}) == 3:
                self.faces.append((row[0], row[i], row[i + 1]))

    def normal(self, face):
        a, b, c = (self.points[i] for i in face)
        return cross(less(b, a), less(c, a))


def rock(rng):
    """A ball with dents."""
    waves = [([rng.uniform(-3, 3) for _ in range(3)], rng.uniform(0, 6)) for _ in range(8)]

    def moved(p):
        p = unit(p)
        return [c * (1 + 0.06 * sum(math.sin(dot(w, p) + t) for w, t in waves)) for c in p]

    g = (1 + math.sqrt(5)) / 2
    corners = [p for a in (-1, 1) for b in (-g, g) for p in ([0, a, b], [a, b, 0], [b, 0, a])]
    near = min(math.dist(p, q) for p in corners for q in corners if p is not q) * 1.01
    faces = [(p, q, r) for i, p in enumerate(corners) for j, q in enumerate(corners[:i]) for r in corners[:j]
             if max(math.dist(p, q), math.dist(q, r), math.dist(p, r)) < near]
    for _ in range(3):
        halves = [[unit([x + y for x, y in zip(a, b)]) for a, b in ((p, q), (q, r), (r, p))] for p, q, r in faces]
        faces = [each for (p, q, r), (a, b, c) in zip(faces, halves)
                 for each in ((p, a, c), (a, q, b), (c, b, r), (a, b, c))]
    mesh = Mesh()
    for p, q, r in faces:
        p, q, r = (p, q, r) if dot(cross(less(q, p), less(r, p)), p) > 0 else (p, r, q)
        mesh.face(moved(p), moved(q), moved(r))
    return mesh


def knot(rng):
    """A tube along a knot: long bands."""
    def middle(t):
        return [(2 + math.cos(3 * t)) * math.cos(2 * t), (2 + math.cos(3 * t)) * math.sin(2 * t), math.sin(3 * t)]

    mesh, around, along = Mesh(), 12, 160
    rings = []
    for i in range(along):
        t = math.tau * i / along
        way = unit(less(middle(t + 1e-3), middle(t)))
        side = unit(cross(way, unit(middle(t))))
        up, r = cross(side, way), 0.4 + 0.08 * math.sin(5 * t)
        rings.append([[m + r * (math.cos(a) * s + math.sin(a) * u) for m, s, u in zip(middle(t), side, up)]
                      for a in (math.tau * k / around for k in range(around))])
    for i in range(along):
        for k in range(around):
            a, b = rings[i], rings[(i + 1) % along]
            mesh.face(a[k], b[k], b[(k + 1) % around], a[(k + 1) % around])
    return mesh


def gear(rng):
    """Two faces with teeth and a hole, and many small sides."""
    mesh, teeth, half = Mesh(), 22, 0.25
    ring = []
    for k in range(teeth):
        for step, r in ((0, 0.82), (0.25, 1.0), (0.5, 1.0), (0.75, 0.82)):
            a = math.tau * (k + step) / teeth
            ring.append((r * math.cos(a), r * math.sin(a)))
    hole = [(0.3 * math.cos(math.tau * k / len(ring)), 0.3 * math.sin(math.tau * k / len(ring))) for k in range(len(ring))]
    for k in range(len(ring)):
        (ax, ay), (bx, by) = ring[k], ring[(k + 1) % len(ring)]
        (cx, cy), (dx, dy) = hole[k], hole[(k + 1) % len(ring)]
        mesh.face((cx, cy, half), (ax, ay, half), (bx, by, half), (dx, dy, half))
        mesh.face((ax, ay, -half), (cx, cy, -half), (dx, dy, -half), (bx, by, -half))
        mesh.face((ax, ay, -half), (bx, by, -half), (bx, by, half), (ax, ay, half))
        mesh.face((dx, dy, -half), (cx, cy, -half), (cx, cy, half), (dx, dy, half))
    return mesh


def grass(rng):
    """Bent blades of any width and length."""
    mesh = Mesh()
    for blade in range(60):
        x, length, wide, bend = blade * 10, rng.lognormvariate(0, 0.6), rng.lognormvariate(-2.6, 0.5), rng.uniform(-0.7, 0.7)
        rows = []
        for i in range(9):
            t = i / 8
            a = bend * t
            w = wide * (1 - t ** 2) + 0.004
            y, z = length * t * math.cos(a), length * t * math.sin(a)
            rows.append(((x + z - w * math.cos(a), y + w * math.sin(a), 0), (x + z + w * math.cos(a), y - w * math.sin(a), 0)))
        for (a, b), (c, d) in zip(rows, rows[1:]):
            mesh.face(a, b, d, c)
    return mesh


def charts(mesh, limit):
    """Rows of faces that hang together and face within `limit` of their first one, the largest first."""
    normals = [mesh.normal(f) for f in mesh.faces]
    area, units = [math.sqrt(dot(n, n)) for n in normals], [unit(n) for n in normals]
    beside = {}
    for i, f in enumerate(mesh.faces):
        for a, b in zip(f, f[1:] + f[:1]):
            beside.setdefault(frozenset((a, b)), []).append(i)
    left, out = set(range(len(mesh.faces))), []
    for seed in sorted(left, key=lambda i: (-area[i], i)):
        if seed not in left:
            continue
        chart, queue = [], [(0.0, seed)]
        while queue:
            angle, i = heapq.heappop(queue)
            if i not in left:
                continue
            left.remove(i)
            chart.append(i)
            f = mesh.faces[i]
            for a, b in zip(f, f[1:] + f[:1]):
                for j in beside[frozenset((a, b))]:
                    turned = math.acos(max(-1.0, min(1.0, dot(units[j], units[seed]))))
                    if j in left and turned < limit:
                        heapq.heappush(queue, (turned, j))
        out.append((units[seed], chart))
    return out


def flat(mesh, normal, chart, scale, rng):
    """The triangles of a chart in texels."""
    across = unit(cross(normal, [0, 0, 1] if abs(normal[2]) < 0.9 else [0, 1, 0]))
    up, a = cross(normal, across), rng.uniform(0, math.tau)
    out = []
    for i in chart:
        row = []
        for p in (mesh.points[k] for k in mesh.faces[i]):
            u, v = dot(p, across), dot(p, up)
            row.append((scale * (u * math.cos(a) - v * math.sin(a)), scale * (u * math.sin(a) + v * math.cos(a))))
        out.append(row)
    return out


def distance(p, triangle):
    """Of a point from a triangle; 0 inside."""
    signs, nearest = [], math.inf
    for (ax, ay), (bx, by) in zip(triangle, triangle[1:] + triangle[:1]):
        ex, ey, px, py = bx - ax, by - ay, p[0] - ax, p[1] - ay
        signs.append(ex * py - ey * px)
        t = max(0.0, min(1.0, (px * ex + py * ey) / ((ex * ex + ey * ey) or 1)))
        nearest = min(nearest, math.hypot(px - t * ex, py - t * ey))
    return 0.0 if min(signs) >= 0 or max(signs) <= 0 else nearest


def mask(triangles):
    """The texels whose centre lies within a texel of a triangle."""
    left, top = (math.floor(min(c[k] for t in triangles for c in t)) - 1 for k in (0, 1))
    taken = {}
    for t in triangles:
        xs, ys = [c[0] for c in t], [c[1] for c in t]
        for y in range(math.floor(min(ys) - 1), math.ceil(max(ys) + 1)):
            row = taken.setdefault(y - top, set())
            row.update(x - left for x in range(math.floor(min(xs) - 1), math.ceil(max(xs) + 1))
                       if distance((x + 0.5, y + 0.5), t) < 1)
    rows = [sorted(taken.get(y, ())) for y in range(max(taken) + 1)]
    while not rows[0]:
        rows.pop(0)
    while not rows[-1]:
        rows.pop()
    first = min(r[0] for r in rows if r)
    return [[x - first for x in r] for r in rows]


def text_of(rows):
    out = [f"island {max(r[-1] for r in rows if r) + 1} {len(rows)}"]
    for row in rows:
        ends = [x for i, x in enumerate(row) if i == 0 or row[i - 1] != x - 1]
        stops = [x + 1 for i, x in enumerate(row) if i + 1 == len(row) or row[i + 1] != x + 1]
        out.append(" ".join(f"{a} {b}" for a, b in zip(ends, stops)))
    return "\n".join(out)


def main():
    folder = Path(sys.argv[1])
    for name, make, limit, scale in (("rock", rock, 0.7, 90), ("knot", knot, 0.8, 40), ("gear", gear, 0.5, 120),
                                     ("grass", grass, 0.5, 110)):
        rng = random.Random(name)
        mesh = make(rng)
        islands = [mask(flat(mesh, normal, chart, scale, rng)) for normal, chart in charts(mesh, limit)]
        (folder / f"{name}.txt").write_text("\n".join(map(text_of, islands)) + "\n")
        print(name, len(islands), "islands", sum(len(r) for each in islands for r in each), "texels")


if __name__ == "__main__":
    main()
