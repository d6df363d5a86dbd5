"""Reads our HPGL file with a pen of our own: what a plotter would draw, from the manual's words for
IN, SP, PU and PD alone."""

import re
import sys

import roundtrip
from roundtrip import check, near

UNITS = 40.0  # per millimetre


def draw(text):
    """Pen -> list of lines, each a list of places in millimetres. Any other instruction is a fault."""
    lines, pen, place, is_down, begun = {}, 0, (0.0, 0.0), False, False
    for instruction in text.replace("\n", "").split(";"):
        name, arguments = instruction[:2], instruction[2:]
        numbers = [int(number) for number in re.findall(r"-?\d+", arguments)]
        if name == "IN":
            begun = True
        elif name == "SP":
            check(begun, "a pen is taken before IN")
            pen, is_down = numbers[0], False
        elif name in ("PU", "PD"):
            check(pen > 0, "the head moves without a pen")
            was_down, is_down = is_down, name == "PD"
            for x, y in zip(numbers[::2], numbers[1::2]):
                if is_down and not was_down:
                    lines.setdefault(pen, []).append([place])
                place, was_down = (x / UNITS, y / UNITS), is_down
                if is_down:
                    lines[pen][-1].append(place)
        else:
            check(instruction == "", f"unknown instruction {instruction}")
    check(pen == 0 and not is_down, "the pen is not put away at the end")
    return lines


def main():
    folder = roundtrip.known_files()
    lines = draw((folder / "known.plt").read_text(encoding="ascii"))
    check(sorted(lines) == [1, 2, 3, 4], f"pens {sorted(lines)}: cut, seam, grain and label")
    hole, square, circle = lines[1]
    check(square[0] == square[-1] and circle[0] == circle[-1], "outlines are closed")
    # (1, 1) of the drawing, the lower left corner of all lines and hidden ones, is (0, 0).
    check(set(square) == {(19, 29), (119, 29), (119, 129), (19, 129)}, f"square {square}")
    check(len(hole) == 251 and len(circle) == 721, "number of corners")
    for x, y in circle:
        near(abs(complex(x - 219.0, y - 99.0)), 60.0, 0.018, "radius")
    check(lines[3] == [[(39, 39), (39, 119)]], f"grain line {lines[3]}")
    letters = [place for line in lines[4] for place in line]
    check(min(x for x, _ in letters) >= 0.0 and len(lines[4]) > 40, "letters are drawn")
    print("PLT: all as written")


if __name__ == "__main__":
    sys.exit(main())
