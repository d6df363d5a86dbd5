"""Renders our SVG file with librsvg and measures what it shows."""

import subprocess
import sys

import roundtrip
from roundtrip import Picture, check_square, run

PER_MM = 10.0


def main():
    roundtrip.need("rsvg-convert", "pdftoppm")
    folder = roundtrip.known_files()
    # By way of a PDF, which keeps the size; a PNG would have to be unpacked here.
    run("rsvg-convert", "-f", "pdf", "-o", folder / "svg.pdf", folder / "known.svg")
    run("pdftoppm", "-r", str(25.4 * PER_MM), "-singlefile", folder / "svg.pdf", folder / "svg")
    picture = Picture(folder / "svg.ppm")
    roundtrip.near(picture.width, 300.0 * PER_MM, 2.0, "width of the picture")
    roundtrip.near(picture.height, 200.0 * PER_MM, 2.0, "height of the picture")
    check_square(picture, PER_MM, 20.0, 200.0 - 130.0, 100.0, "known.svg")
    print("SVG: all as written")


if __name__ == "__main__":
    sys.exit(main())
