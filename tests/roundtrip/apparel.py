"""Reads patterns for apparel programs, and curves in DXF R2000, with ezdxf, and compares them with the
flat mesh and with what was asked for."""

import math
import pathlib
import sys

import roundtrip
from roundtrip import check, near, run

try:
    import ezdxf
    from ezdxf.path import make_path
except ImportError:
    roundtrip.skip("python3-ezdxf")

NOTCHES = [(0.25, "v", 4.0), (0.5, "slit", 0.0), (0.8, "t", 4.0)]  # share of the border, kind, width
MARKS = [(900, "drill"), (1000, "cross"), (1200, "drill")]
LINE = (300, 400, 500)
GRAIN = 30.0
DEPTH = 5.0
POINTS_ONLY = ("4", "13", "80")
LINES_ONLY = ("5", "6", "7")


def flat_mesh(path):
    """Vertices and the outer border, counter-clockwise from its vertex of the smallest number."""
    vertices, following = [], {}
    edges = set()
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append((float(words[1]), float(words[2])))
        if words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
            edges |= set(zip(corners, corners[1:] + corners[:1]))
    for a, b in edges:
        if (b, a) not in edges:
            following[a] = b
    loop = [min(following)]
    while following[loop[-1]] != loop[0]:
        loop.append(following[loop[-1]])
    check(len(loop) == len(following), "the border is one loop")
    return vertices, loop


def place_at(points, share):
    """A place on a closed line, and the direction of the line over 4 mm there."""
    lengths = [math.dist(a, b) for a, b in zip(points, points[1:] + points[:1])]
    total = sum(lengths)

    def at(way):
        way %= total
        for (a, b), length in zip(zip(points, points[1:] + points[:1]), lengths):
            if way <= length:
                return tuple(p + way / length * (q - p) for p, q in zip(a, b))
            way -= length
        return points[0]

    before, after = at(share * total - 2.0), at(share * total + 2.0)
    return at(share * total), math.degrees(math.atan2(after[1] - before[1], after[0] - before[0]))


def distance(p, points):
    """Of a place from a closed line."""
    least = math.inf
    for a, b in zip(points, points[1:] + points[:1]):
        way = (b[0] - a[0], b[1] - a[1])
        square = way[0] ** 2 + way[1] ** 2
        share = 0.0
        if square > 0.0:
            share = ((p[0] - a[0]) * way[0] + (p[1] - a[1]) * way[1]) / square
            share = min(1.0, max(0.0, share))
        least = min(least, math.dist(p, (a[0] + share * way[0], a[1] + share * way[1])))
    return least


def angle_between(a, b, period=360.0):
    return abs((a - b + period / 2.0) % period - period / 2.0)


def block_of(path):
    """The only block of a file, and the file's texts."""
    text = path.read_bytes()
    check(max(text) < 128, f"{path}: not ASCII")
    check(b"TABLE" not in text, f"{path}: tables")
    document = ezdxf.readfile(path)
    check(not document.audit().errors, f"{path}: errors")
    blocks = [block for block in document.blocks if not block.name.startswith("*")]
    check([block.name for block in blocks] == ["Groesse_42"], f"{path}: {blocks}")
    inserts = document.modelspace().query("INSERT")
    check(len(inserts) == 1 and inserts[0].dxf.insert == (0, 0, 0), f"{path}: inserted elsewhere")
    return blocks[0]


def of_layer(block, kind, layers):
    return [entity for entity in block.query(kind) if entity.dxf.layer in layers]


def check_kinds(block, name):
    for layer in POINTS_ONLY + LINES_ONLY:
        check(not of_layer(block, "POLYLINE", (layer,)), f"{name}: a polyline on {layer}")
    for layer in LINES_ONLY[:1] + LINES_ONLY[2:]:
        check(len(of_layer(block, "LINE", (layer,))) == 1, f"{name}: grain on {layer}")
    lines = of_layer(block, "POLYLINE", ("1", "8"))
    vertices = [(v.x, v.y) for line in lines for v in line.points()]
    points = [(p.dxf.location.x, p.dxf.location.y) for p in of_layer(block, "POINT", ("2", "3"))]
    check(sorted(points) == sorted(vertices), f"{name}: turn and curve points")
    corners = [(p.dxf.location.x, p.dxf.location.y) for p in of_layer(block, "POINT", ("2",))]
    check(len(corners) < len(points), f"{name}: every point is a corner")


def check_marks(block, name, vertices, outline, is_astm):
    wanted = [place_at(outline, share) + (width, kind) for share, kind, width in NOTCHES]
    notches = of_layer(block, "POINT", ("4", "80"))
    check(len(notches) == len(wanted), f"{name}: {len(notches)} notches")
    for (place, along, width, kind), point in zip(wanted, notches):
        what = f"{name}: notch {kind}"
        near(math.dist(place, (point.dxf.location.x, point.dxf.location.y)), 0.0, 0.01, what)
        near(point.dxf.location.z, DEPTH, 1e-9, f"{what}, depth")
        near(point.dxf.thickness, width, 1e-9, f"{what}, width")
        near(angle_between(point.dxf.angle, along + 90.0), 0.0, 0.1, f"{what}, angle")
        check(point.dxf.layer == ("80" if kind == "t" and is_astm else "4"), f"{what}, layer")
    drills = of_layer(block, "POINT", ("13",))
    check(len(drills) == len(MARKS), f"{name}: {len(drills)} drill holes")
    for (vertex, _), point in zip(MARKS, drills):
        place = (point.dxf.location.x, point.dxf.location.y)
        near(math.dist(vertices[vertex], place), 0.0, 0.01, f"{name}: drill hole")
    grain = of_layer(block, "LINE", ("7",))[0]
    way = grain.dxf.end - grain.dxf.start
    near(angle_between(way.angle_deg, GRAIN, 180.0), 0.0, 0.1, f"{name}: grain")
    inner = of_layer(block, "POLYLINE", ("8",))
    check(len(inner) == 1, f"{name}: inner lines")
    for vertex, place in zip(LINE, inner[0].points()):
        near(math.dist(vertices[vertex], (place.x, place.y)), 0.0, 0.01, f"{name}: inner line")


def check_outline(block, name, outline):
    boundary = of_layer(block, "POLYLINE", ("1",))
    check(len(boundary) == 1 and boundary[0].is_closed, f"{name}: boundary")
    points = [(p.x, p.y) for p in boundary[0].points()]
    check(len(points) <= 40 < len(outline), f"{name}: {len(points)} of {len(outline)} points")
    farthest = max(distance(p, points) for p in outline)
    check(farthest <= 0.151, f"{name}: a vertex is {farthest} mm from the boundary")
    for place in points:
        check(distance(place, outline) <= 0.151, f"{name}: a point is off the border")


def shifted(vertices, to):
    """The vertices with the lower left corner of their box elsewhere."""
    low = [min(v[k] for v in vertices) for k in (0, 1)]
    return [(v[0] - low[0] + to[0], v[1] - low[1] + to[1]) for v in vertices]


def check_profiles(program, folder, panel):
    (folder / "notches.txt").write_text(
        "".join(f"{share} {kind}\n" for share, kind, _ in NOTCHES)
    )
    (folder / "marks.txt").write_text("".join(f"{vertex} {kind}\n" for vertex, kind in MARKS))
    (folder / "line.txt").write_text(" ".join(map(str, LINE)))
    for profile in ("aama", "astm", "clo", "lectra", "optitex", "gerber"):
        out = folder / profile
        run(program, "flatten", panel, "-o", out, "--formats", "dxf", "--dxf-profile", profile,
            "--notches", folder / "notches.txt", "--marks", folder / "marks.txt",
            "--inner-lines", folder / "line.txt", "--grain", f"{GRAIN}deg",
            "--piece-name", "Größe", "--size", "42")
        vertices, loop = flat_mesh(out / "flat.obj")
        block = block_of(out / "pattern.dxf")
        # The sheet has the lower left corner of the pattern 10 mm from the left, 74 mm up.
        vertices = shifted(vertices, (10.0, 74.0))
        outline = [vertices[v] for v in loop]
        check_kinds(block, profile)
        check_marks(block, profile, vertices, outline, profile in ("astm", "optitex", "gerber"))
        check_outline(block, profile, outline)


def check_curves(program, folder, panel):
    out = folder / "r2000"
    run(program, "flatten", panel, "-o", out, "--formats", "dxf", "--dxf-version", "r2000")
    document = ezdxf.readfile(out / "pattern.dxf")
    check(document.dxfversion == "AC1015", f"version {document.dxfversion}")
    audit = document.audit()
    check(not audit.errors and not audit.fixes, f"r2000: {audit.errors} {audit.fixes}")
    vertices, loop = flat_mesh(out / "flat.obj")
    vertices = shifted(vertices, (10.0, 74.0))
    outline = [vertices[v] for v in loop]
    drawn = [e for e in document.modelspace() if e.dxf.layer == "cut"]
    splines = [e for e in drawn if e.dxftype() == "SPLINE"]
    check(splines, "r2000: no spline")
    check(len(drawn) < 20, f"r2000: {len(drawn)} entities for an outline")
    length = 0.0
    for entity in drawn:
        places = [(p.x, p.y) for p in make_path(entity).flattening(0.001)]
        length += sum(math.dist(a, b) for a, b in zip(places, places[1:]))
        for place in places:
            check(distance(place, outline) <= 0.101, "r2000: a curve is off the border")
    around = sum(math.dist(a, b) for a, b in zip(outline, outline[1:] + outline[:1]))
    near(length, around, 0.1, "r2000: length of the outline")


def main():
    check(len(sys.argv) == 2, f"usage: {sys.argv[0]} PROGRAM")
    program = pathlib.Path(sys.argv[1])
    folder = roundtrip.temporary_folder()
    panel = folder / "panel.obj"
    run(program, "sample", "panel", "--vertices", "2000", "-o", panel)
    check_profiles(program, folder, panel)
    check_curves(program, folder, panel)
    print("Patterns for apparel programs: all as asked for")


if __name__ == "__main__":
    sys.exit(main())
