"""What the program writes, read again without it: coordinates stay the texts of the files."""

import re
from fractions import Fraction

import numpy as np

from surface import norm


def texts_of_obj(path):
    """Coordinates of the vertices as they are written."""
    with open(path, encoding="utf-8") as file:
        return [tuple(line.split()[1:4]) for line in file if line.startswith("v ")]


def mesh_of_obj(path):
    positions = np.array(texts_of_obj(path), dtype=float).reshape(-1, 3)
    with open(path, encoding="utf-8") as file:
        triangles = [[int(word.split("/")[0]) - 1 for word in line.split()[1:4]]
                     for line in file if line.startswith("f ")]
    return positions, np.array(triangles, int).reshape(-1, 3)


def rms_strain(patch, flat, triangles):
    """Of the edges' lengths, flat over patch less 1, each weighted by a third of the area of its triangles."""
    a, b, c = (patch[triangles[:, k]] for k in range(3))
    area = 0.5 * norm(np.cross(b - a, c - a))
    squares = weights = 0.0
    for k in range(3):
        p, q = triangles[:, k], triangles[:, (k + 1) % 3]
        strain = norm(flat[q] - flat[p]) / norm(patch[q] - patch[p]) - 1.0
        squares += float(np.sum(area * strain * strain))
        weights += float(np.sum(area))
    return np.sqrt(squares / weights)


TOKEN = re.compile(r"[A-Za-z]|-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def loops_of_path(data):
    """The lines of an SVG path of straight lines; steps from the last point are added exactly."""
    loops, command, numbers = [], "", []
    for token in TOKEN.findall(data):
        if token.isalpha():
            command, numbers = token, []
            if token not in "MLlZz":
                raise ValueError(f"a line that is not straight: {data[:60]}")
            continue
        numbers.append(Fraction(token))
        if len(numbers) < 2:
            continue
        (x, y), numbers = numbers, []
        if command == "M":
            loops.append([(x, y)])
            command = "L"
        elif command == "L":
            loops[-1].append((x, y))
        else:
            loops[-1].append((loops[-1][-1][0] + x, loops[-1][-1][1] + y))
    return loops


def loops_of_svg(path):
    """Closed lines of the layers cut and hole. With --curve-tolerance 0 they are straight from point to point."""
    text = path.read_text(encoding="utf-8")
    layers = re.findall(r'<g id="(?:cut|hole)"[^>]*>(.*?)</g>', text, re.S)
    return [loop for layer in layers for data in re.findall(r'\bd="([^"]*)"', layer) for loop in loops_of_path(data)]


def loops_of_dxf(path):
    """Closed polylines of the layers cut and hole, of DXF R12."""
    lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
    loops, current, layer, kind, x = [], None, "", "", ""
    for code, value in zip(lines[::2], lines[1::2]):
        if code == "0":
            kind = value
            if value == "POLYLINE":
                current, layer = [], ""
            elif value == "SEQEND" and current is not None:
                if layer.lower() in ("cut", "hole"):
                    loops.append(current)
                current = None
        elif code == "8" and kind == "POLYLINE":
            layer = value
        elif code == "10" and kind == "VERTEX":
            x = value
        elif code == "20" and kind == "VERTEX" and current is not None:
            current.append((x, value))
    return loops
