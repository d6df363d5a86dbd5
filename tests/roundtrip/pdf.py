"""Reads our PDF files with qpdf and poppler, and measures what they show."""

import json
import re
import sys

import roundtrip
from roundtrip import Picture, check, check_square, is_dark, is_red, near, run

DPI = 254  # ten pixels a millimetre
PER_MM = DPI / 25.4
MM_PER_POINT = 25.4 / 72.0


def sound(path):
    """Whether qpdf has nothing against a file: its warnings end it with 3."""
    text = run("qpdf", "--check", path)
    check("No syntax or stream encoding errors" in text, f"{path.name}: {text}")


def pages(path, resolution=DPI):
    stem = path.with_suffix("")
    run("pdftoppm", "-r", str(resolution), path, stem)
    return [Picture(page) for page in sorted(path.parent.glob(f"{stem.name}-[0-9]*.ppm"))]


def size(path):
    found = re.search(r"Page size: +([\d.]+) x ([\d.]+) pts", run("pdfinfo", path))
    return float(found[1]) * MM_PER_POINT, float(found[2]) * MM_PER_POINT


def objects(path):
    document = json.loads(run("qpdf", "--json=1", path))["objects"]
    return [value for value in document.values() if isinstance(value, dict)]


def check_one_page(path):
    sound(path)
    width, height = size(path)
    near(width, 300.0, 0.001, "width of the page")
    near(height, 200.0, 0.001, "height of the page")
    (picture,) = pages(path)
    check_square(picture, PER_MM, 20.0, 200.0 - 130.0, 100.0, path.name)
    blue = lambda r, g, b: b > 200 and r < 130 and g < 130
    # The hidden square of blue lies at the lower left corner.
    box = picture.box(blue)
    check(box[3] < (200.0 - 10.0) * PER_MM, f"{path.name}: the hidden layer shows")
    # Centred text is as far to the left of its place as to the right.
    text = picture.box(blue, bottom=int(30 * PER_MM))
    near((text[0] + text[2]) / 2 / PER_MM, 150.0, 1.5, f"{path.name}: middle of the centred text")
    words = run("pdftotext", path, "-")
    check("Größe 38 (100%%) \\ ± 0.5° × €" in words, f"{path.name}: {words}")
    check("Title:           Größe – 1" in run("pdfinfo", path), f"{path.name}: title")
    layers = [some["/Name"] for some in objects(path) if some.get("/Type") == "/OCG"]
    wanted = ["strain", "cut", "seam", "grain", "notes, hidden", "label"]
    check(layers == wanted, f"{path.name}: layers {layers}")
    catalog = next(some for some in objects(path) if some.get("/Type") == "/Catalog")
    check(catalog["/ViewerPreferences"]["/PrintScaling"] == "/None", "PrintScaling")
    check(len(catalog["/OCProperties"]["/D"]["/OFF"]) == 1, f"{path.name}: one layer is hidden")


def check_long(path):
    """A sheet that no viewer shows on one page at true size: two pages to be joined, behind a map."""
    sound(path)
    sides = [some["/MediaBox"] for some in objects(path) if some.get("/Type") == "/Page"]
    check(len(sides) == 3 and max(map(max, sides)) <= 14400, f"{path.name}: pages {sides}")
    check(b"UserUnit" not in path.read_bytes(), f"{path.name} needs a unit of its own")
    _, left, right = pages(path, 25.4)  # a pixel a millimetre
    step = left.width - 2 * 10 - 10  # between margins, without the overlap
    # The panel has 2 mm around it, half of its line's width is 1 mm.
    begin = left.box(is_red)[0] - (10.0 + 2.0 - 1.0)
    end = right.box(is_red)[2] + step - (10.0 + 2.0 + 1.0)
    near(end - begin, 6500.0, 2.0, f"{path.name}: length of the panel over both pages")


def check_tiles(path):
    sound(path)
    first, *tiles = pages(path)
    check(len(tiles) == 2, f"{path.name}: {len(tiles)} tiles")
    # The test square of the first page, 10 mm from its lower left corner.
    box = first.box(
        is_dark, right=int(65 * PER_MM), top=first.height - int(65 * PER_MM)
    )
    near((box[2] - box[0]) / PER_MM, 50.25, 0.2, f"{path.name}: width of the test square")
    near((box[3] - box[1]) / PER_MM, 50.25, 0.2, f"{path.name}: height of the test square")
    # What is drawn but for the label, from x = 1 to y = 160, has 2 mm around it. This area hangs from
    # the upper left corner of the first frame, 10 mm from the paper's edges.
    left, top = 1.0 - 2.0, 160.0 + 2.0
    box = tiles[0].box(
        is_red, right=int(140 * PER_MM), top=int(60 * PER_MM), bottom=int(200 * PER_MM)
    )
    near(box[0] / PER_MM, 10.0 + 20.0 - left, 0.2, f"{path.name}: left of the square")
    near((box[2] - box[0]) / PER_MM, 100.2, 0.2, f"{path.name}: width of the square")
    near(box[3] / PER_MM, 10.0 + top - 30.0, 0.2, f"{path.name}: bottom of the square")
    # The circle's right end is at x = 280 of the sheet, and the second frame begins 180 mm to the right.
    box = tiles[1].box(is_red)
    near(box[2] / PER_MM, 10.0 + 280.0 - 180.0 - left, 0.2, f"{path.name}: right end on the second tile")


def main():
    roundtrip.need("qpdf", "pdfinfo", "pdftoppm", "pdftotext")
    folder = roundtrip.known_files()
    check_one_page(folder / "known.pdf")
    check_long(folder / "long.pdf")
    check_tiles(folder / "known-a4.pdf")
    sound(folder / "known-letter.pdf")
    print("PDF: all as written")


if __name__ == "__main__":
    sys.exit(main())
