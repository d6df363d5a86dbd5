#!/usr/bin/env python3
"""Writes the meshes of these products, by formula, in millimetres.

    examples/products/make.py [FOLDER]
"""

import math
import sys
from pathlib import Path


def grid(rows, columns, place):
    """A mesh over a rectangle: place(u, v), both from 0 to 1, u along a row."""
    places = [place(j / columns, i / rows) for i in range(rows + 1) for j in range(columns + 1)]
    triangles = []
    for i in range(rows):
        for j in range(columns):
            a = i * (columns + 1) + j
            b, c, d = a + 1, a + columns + 1, a + columns + 2
            triangles += [(a, b, d), (a, d, c)] if (i + j) % 2 == 0 else [(a, b, c), (b, d, c)]
    return places, triangles


def slit(mesh, vertices, is_beyond):
    """Cuts a mesh along a row of vertices, from the border to the last one, which stays whole."""
    places, triangles = list(mesh[0]), []
    other = {}
    for vertex in vertices[:-1]:
        other[vertex] = len(places)
        places.append(places[vertex])
    for triangle in mesh[1]:
        middle = [sum(places[v][k] for v in triangle) / 3 for k in range(3)]
        triangles.append(tuple(other.get(v, v) for v in triangle) if is_beyond(middle) else triangle)
    return places, triangles


def write(path, mesh):
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in mesh[0]]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh[1]]
    path.write_text("\n".join(lines) + "\n")


def smooth(t):
    return t * t * (3 - 2 * t)


def leg(is_back):
    """Half of a leg, from the hem up to the waist: 1 m high, 186 mm wide at the hem."""

    def place(u, v):
        angle = math.pi * (u - 0.5)
        radius = 93 + 70 * smooth(v) - 14 * math.exp(-((v - 0.35) / 0.2) ** 2)
        seat = 34 * math.exp(-((v - 0.82) / 0.13) ** 2) * math.cos(angle) if is_back else 0.0
        side, out = radius * math.sin(angle), 0.55 * radius * math.cos(angle) + seat
        return (-side, -out, 1000 * v) if is_back else (side, out, 1000 * v)

    rows, columns = 30, 20
    mesh = grid(rows, columns, place)
    if not is_back:
        return mesh[0], [(a, c, b) for a, b, c in mesh[1]]
    middle = [(rows - k) * (columns + 1) + columns // 2 for k in range(5)]
    mesh = slit(mesh, middle, lambda p: p[0] < 0)
    return mesh[0], [(a, c, b) for a, b, c in mesh[1]]


def upper(start, end, low, high):
    """Part of a shoe's upper: along from the toe, around from the outer edge of the sole over the top."""

    def place(u, v):
        along = start + (end - start) * u
        t = along / 270
        width = 44 * math.sqrt(max(1 - (2.2 * t - 1) ** 2, 0.0)) * 0.55 + 20 * smooth(min(1, 3 * t))
        height = 22 + 62 * smooth(t)
        angle = math.radians(low + (high - low) * v)
        return (along, -width * math.cos(angle), height * math.sin(angle))

    mesh = grid(14, 24, place)
    return mesh[0], [(a, c, b) for a, b, c in mesh[1]]


def bag_front():
    """Half of a bag's front, which bulges by 12 mm; its fold is the edge at x = 0."""

    def place(u, v):
        x, y = 150 * u, 250 * v
        return (x, y, 12 * (1 - u * u) * 4 * v * (1 - v))

    return grid(12, 8, place)


def bag_gusset():
    """A strip around the sides and the bottom, 80 mm wide, with round corners."""
    straight, radius = 210.0, 40.0
    bottom, arc = 220.0, math.pi / 2 * radius
    whole = 2 * straight + bottom + 2 * arc

    def along(way):
        if way < straight:
            return (0.0, 250 - way)
        way -= straight
        if way < arc:
            a = way / radius
            return (radius - radius * math.cos(a), 40 - radius * math.sin(a))
        way -= arc
        if way < bottom:
            return (radius + way, 0.0)
        way -= bottom
        if way < arc:
            a = way / radius
            return (260 + radius * math.sin(a), 40 - radius * math.cos(a))
        return (300.0, 40 + way - arc)

    def place(u, v):
        x, y = along(whole * u)
        return (x, y, 80 * v)

    return grid(4, 132, place)


def hull(is_bottom):
    """Side or bottom of a punt of 2.1 m, ruled between its keel, chine and sheer."""

    def keel(t):
        return (2100 * t, 0.0, 90 * (2 * t - 1) ** 2)

    def chine(t):
        return (2100 * t, 330 * (1 - (2 * t - 1) ** 4 * 0.55), 60 + 120 * (2 * t - 1) ** 2)

    def sheer(t):
        return (2100 * t, 420 * (1 - (2 * t - 1) ** 4 * 0.5), 340 + 90 * (2 * t - 1) ** 2)

    low, high = (keel, chine) if is_bottom else (chine, sheer)

    def place(u, v):
        return tuple(a + v * (b - a) for a, b in zip(low(u), high(u)))

    return grid(6, 40, place)


def hat_tip(size):
    girth = 10.0 * size
    radius = girth / (2 * math.pi) - 6

    def place(u, v):
        angle, t = 2 * math.pi * u, v
        return (1.12 * radius * t * math.cos(angle), radius * t * math.sin(angle), 105 + 9 * (1 - t * t))

    rows, columns = 8, 36
    places = [place(0.0, 0.0)]
    places += [place(j / columns, i / rows) for i in range(1, rows + 1) for j in range(columns)]
    triangles = [(0, 1 + j, 1 + (j + 1) % columns) for j in range(columns)]
    for i in range(rows - 1):
        for j in range(columns):
            a, b = 1 + i * columns + j, 1 + i * columns + (j + 1) % columns
            triangles += [(a, a + columns, b + columns), (a, b + columns, b)]
    return places, triangles


def hat_side(size):
    girth = 10.0 * size
    top, bottom = girth / (2 * math.pi) - 6, girth / (2 * math.pi)

    def place(u, v):
        angle = 2 * math.pi * u
        radius = bottom + (top - bottom) * v
        return (1.12 * radius * math.cos(angle), radius * math.sin(angle), 105 * v)

    return grid(8, 48, place)


def hat_brim(size):
    girth = 10.0 * size
    inner = girth / (2 * math.pi)

    def place(u, v):
        angle, radius = 2 * math.pi * u, inner + 62 * v
        stretch = 1.12 - 0.05 * v
        return (stretch * radius * math.cos(angle), radius * math.sin(angle), -16 * v - 8 * v * v)

    mesh = grid(8, 48, place)
    return mesh[0], [(a, c, b) for a, b, c in mesh[1]]


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent / "meshes")
    folder.mkdir(parents=True, exist_ok=True)
    meshes = {
        "leg-front": leg(False),
        "leg-back": leg(True),
        "shoe-vamp": upper(8, 130, 0, 180),
        "shoe-quarter": upper(110, 262, 0, 78),
        "bag-front": bag_front(),
        "bag-gusset": bag_gusset(),
        "hull-side": hull(False),
        "hull-bottom": hull(True),
    }
    for size in (54, 56, 58, 60, 62):
        meshes[f"hat-tip-{size}"] = hat_tip(size)
        meshes[f"hat-side-{size}"] = hat_side(size)
        meshes[f"hat-brim-{size}"] = hat_brim(size)
    for name, mesh in meshes.items():
        write(folder / f"{name}.obj", mesh)


if __name__ == "__main__":
    main()
