#!/usr/bin/env python3
"""plot_histories.py OUT.svg TITLE NAME=HISTORY.csv ... : e_max over sweeps, on a log axis.

Each HISTORY.csv is what `planish evolve --history` writes; START, the e_max before the first sweep,
is taken from `NAME@START=HISTORY.csv`.
"""
import csv
import math
import sys
from html import escape

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 360, 60, 150, 40, 44
COLORS = ["#c05000", "#0068a0", "#222222", "#6a3d9a"]
DASHES = ["", "7 4", "2 3", "9 3 2 3"]


def read(argument):
    label, path = argument.split("=", 1)
    name, start = label.split("@")
    with open(path, newline="") as file:
        values = [float(row["e_max"]) for row in csv.DictReader(file)]
    return name, [float(start)] + values


def main():
    out, title, *arguments = sys.argv[1:]
    curves = [read(a) for a in arguments]
    low = min(min(v) for _, v in curves)
    high = max(max(v) for _, v in curves)
    bottom, top = math.log10(low) - 0.1, math.log10(high) + 0.1
    sweeps = max(len(v) for _, v in curves) - 1
    x = lambda k: LEFT + (WIDTH - LEFT - RIGHT) * k / sweeps
    y = lambda v: TOP + (HEIGHT - TOP - BOTTOM) * (top - math.log10(v)) / (top - bottom)
    svg = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
        f'<text x="{LEFT}" y="22" font-size="14" font-weight="bold">{escape(title)}</text>',
    ]
    for power in range(math.floor(bottom), math.ceil(top) + 1):
        for digit in (1, 2, 5):
            value = digit * 10.0**power
            if not bottom <= math.log10(value) <= top:
                continue
            svg.append(
                f'<path d="M{LEFT} {y(value):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
                f'<text x="{LEFT - 8}" y="{y(value) + 4:.1f}" text-anchor="end">{value:g}</text>'
            )
    for k in range(0, sweeps + 1, 10):
        svg.append(f'<text x="{x(k):.1f}" y="{HEIGHT - 24}" text-anchor="middle">{k}</text>')
    svg.append(f'<text x="{x(sweeps / 2):.1f}" y="{HEIGHT - 6}" text-anchor="middle">sweep</text>')
    for (name, values), color, dash in zip(curves, COLORS, DASHES):
        points = " ".join(f"{x(k):.1f},{y(v):.1f}" for k, v in enumerate(values))
        svg.append(
            f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.8" '
            f'stroke-dasharray="{dash}"/>'
            f'<text x="{x(sweeps) + 8:.1f}" y="{y(values[-1]) + 4:.1f}" fill="{color}">'
            f"{escape(name)} {values[-1]:.3g}</text>"
        )
    svg.append("</svg>")
    with open(out, "w") as file:
        file.write("\n".join(svg) + "\n")


main()
