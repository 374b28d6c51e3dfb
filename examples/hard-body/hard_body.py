#!/usr/bin/env python3
"""Writes a surface with everything that spoils pictures of real bodies, as PLY. Usage: hard_body.py OUT.ply [COPIES]

On it are: panels that are cut differently on either side of an edge (T-junctions), a thin wing whose two sides have their
own triangles, bodies that run into each other, one of them inside out, a strut of slivers, faces that are there twice,
triangles without area, and points that meet only almost. 20 COPIES, beside and behind each other, have 103,576 triangles
and hundreds of silhouettes. The same bytes each time. Needs Python 3.9 alone.
"""
import math
import random
import sys


class Mesh:
    def __init__(self):
        self.points, self.triangles = [], []
        self.origin = (0, 0, 0)  # Where the next patch's (0, 0, 0) lies.

    def patch(self, at, columns, rows, flip=False):
        """The grid of at(u, v), u and v from 0 to 1."""
        first = len(self.points)
        for j in range(rows + 1):
            for i in range(columns + 1):
                self.points.append(tuple(o + c for o, c in zip(self.origin, at(i / columns, j / rows))))
        for j in range(rows):
            for i in range(columns):
                a, b = first + j * (columns + 1) + i, first + (j + 1) * (columns + 1) + i
                for t in ((a, a + 1, b + 1), (a, b + 1, b)):
                    self.triangles.append(t[::-1] if flip else t)

    def panel(self, corner, u, v, columns, rows, flip=False):
        self.patch(lambda s, t: tuple(c + s * a + t * b for c, a, b in zip(corner, u, v)), columns, rows, flip)


def body(mesh):
    """A car of flat panels, each with its own number of cells: 4 long, 1.6 wide, 1.2 high, with a slanted back."""
    mesh.panel((-2, -0.8, 0), (0, 1.6, 0), (0, 0, 0.7), 7, 5, flip=True)
    mesh.panel((-2, -0.8, 0.7), (0, 1.6, 0), (0.9, 0, 0.5), 11, 3, flip=True)
    mesh.panel((-1.1, -0.8, 1.2), (0, 1.6, 0), (2.1, 0, 0), 4, 9, flip=True)
    mesh.panel((1, -0.8, 1.2), (0, 1.6, 0), (1, 0, -0.6), 13, 6, flip=True)
    mesh.panel((2, -0.8, 0.6), (0, 1.6, 0), (0, 0, -0.6), 3, 2, flip=True)
    mesh.panel((-2, -0.8, 0), (0, 1.6, 0), (4, 0, 0), 5, 8)
    for y, flip in ((-0.8, False), (0.8, True)):
        mesh.panel((-2, y, 0), (4, 0, 0), (0, 0, 0.6), 17, 3, flip)
        mesh.patch(lambda s, t, y=y: (-2 + 4 * s, y, 0.6 + t * (profile(-2 + 4 * s) - 0.6)), 23, 4, flip)


def profile(x):
    if x < -1.1:
        return 0.7 + (x + 2) / 0.9 * 0.5
    return 1.2 if x < 1 else 1.2 - (x - 1) * 0.6


def wing(mesh):
    """Thin as paper: both sides in the same place, cut differently."""
    corner, u, v = (1.2, -1.3, 1.55), (0.9, 0, 0.12), (0, 2.6, 0.1)
    mesh.panel(corner, u, v, 6, 21)
    mesh.panel(corner, u, v, 4, 9, flip=True)


def ball(mesh, centre, radius, cells, inside_out):
    def at(u, v):
        a, b = 2 * math.pi * u, math.pi * v
        return (centre[0] + radius * math.sin(b) * math.cos(a), centre[1] + radius * math.sin(b) * math.sin(a),
                centre[2] - radius * math.cos(b))
    mesh.patch(at, 2 * cells, cells, inside_out)


def strut(mesh, foot, head, radius):
    """Slivers from one end to the other."""
    n, axis = 40, tuple(b - a for a, b in zip(foot, head))
    def at(u, v):
        a = 2 * math.pi * u
        return (foot[0] + v * axis[0] + radius * math.cos(a), foot[1] + v * axis[1] + radius * math.sin(a),
                foot[2] + v * axis[2])
    mesh.patch(at, n, 1)


def spoil(mesh, dice):
    """Points that meet only almost, faces twice, faces without area."""
    mesh.points = [tuple(c + dice.uniform(-2e-6, 2e-6) for c in p) for p in mesh.points]
    count = len(mesh.triangles)
    for k in dice.sample(range(count), count // 20):
        t = mesh.triangles[k]
        mesh.triangles.append((t[1], t[2], t[0]))
    for k in dice.sample(range(count), count // 50):
        t = mesh.triangles[k]
        mesh.triangles.append((t[0], t[1], t[0]))
    dice.shuffle(mesh.triangles)


def main():
    copies = sys.argv[2] if len(sys.argv) == 3 else "1"
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-") or not copies.isdecimal():
        print(__doc__, file=sys.stderr)
        return 2
    mesh = Mesh()
    for i in range(int(copies)):
        mesh.origin = (i % 4 * 4.6, i // 4 * 3, 0)
        body(mesh)
        wing(mesh)
        ball(mesh, (-1.2, 0, 1.25), 0.45, 24, inside_out=True)
        ball(mesh, (0.4, 0.75, 0.1), 0.35, 16, inside_out=False)
        for y in (-1, 1):
            strut(mesh, (1.6, 0.9 * y, 0.7), (1.65, 0.9 * y, 1.62), 0.05)
    spoil(mesh, random.Random(1))
    with open(sys.argv[1], "w", encoding="ascii") as out:
        out.write(f"ply\nformat ascii 1.0\nelement vertex {len(mesh.points)}\nproperty float x\nproperty float y\n"
                  f"property float z\nelement face {len(mesh.triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
        out.writelines(f"{p[0]:.9g} {p[1]:.9g} {p[2]:.9g}\n" for p in mesh.points)
        out.writelines(f"3 {t[0]} {t[1]} {t[2]}\n" for t in mesh.triangles)
    return 0


if __name__ == "__main__":
    sys.exit(main())
