"""Reads the fields of a flattening with meshio and an XML parser, and compares them with the JSON."""

import csv
import json
import sys
import xml.etree.ElementTree

import roundtrip
from roundtrip import check, near, run

try:
    import meshio
    import numpy
except ImportError:
    roundtrip.skip("python3-meshio")

VERTEX_FIELDS = [
    "inner", "defect", "mean_curvature", "edge_strain", "input_defect", "input_mean_curvature",
    "input_edge_strain", "offset", "move",
]  # fmt: skip
TRIANGLE_FIELDS = ["strain_max", "strain_min", "input_strain_max", "input_strain_min"]


class Fields:
    """Points, triangles, and fields by their names, as arrays."""

    def __init__(self, points, triangles, vertices, faces):
        self.points, self.triangles = numpy.array(points), numpy.array(triangles)
        self.vertices, self.faces = vertices, faces


def by_meshio(path):
    mesh = meshio.read(path)
    check([block.type for block in mesh.cells] == ["triangle"], f"{path.name}: triangles only")
    faces = {name: values[0] for name, values in mesh.cell_data.items()}
    return Fields(mesh.points, mesh.cells[0].data, mesh.point_data, faces)


def by_xml(path):
    """What stands in a .vtp file, which meshio does not read."""
    root = xml.etree.ElementTree.parse(path).getroot()
    check(root.get("type") == "PolyData", f"{path.name}: type of the file")
    piece = root.find("PolyData/Piece")

    def arrays(element):
        return {a.get("Name"): numpy.array(a.text.split(), float) for a in piece.find(element)}

    polys = arrays("Polys")
    count = int(piece.get("NumberOfPolys"))
    check((polys["offsets"] == 3 * numpy.arange(1, count + 1)).all(), f"{path.name}: offsets")
    points = arrays("Points")["Points"].reshape(int(piece.get("NumberOfPoints")), 3)
    triangles = polys["connectivity"].reshape(count, 3).astype(int)
    return Fields(points, triangles, arrays("PointData"), arrays("CellData"))


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}


def by_csv(path):
    vertices = table(path.with_name(path.stem + "-vertices.csv"))
    faces = table(path.with_name(path.stem + "-triangles.csv"))
    points = numpy.stack([vertices.pop(c) for c in "xyz"], axis=1)
    triangles = numpy.stack([faces.pop(c) for c in "abc"], axis=1).astype(int)
    check((vertices.pop("vertex") == numpy.arange(len(points))).all(), "numbers of vertices")
    check((faces.pop("triangle") == numpy.arange(len(triangles))).all(), "numbers of triangles")
    return Fields(points, triangles, vertices, faces)


def check_equal(fields, wanted, name):
    check(sorted(fields.vertices) == sorted(VERTEX_FIELDS), f"{name}: fields of vertices")
    check(sorted(fields.faces) == sorted(TRIANGLE_FIELDS), f"{name}: fields of triangles")
    check((fields.points == wanted.points).all(), f"{name}: positions")
    check((fields.triangles == wanted.triangles).all(), f"{name}: triangles")
    for field in VERTEX_FIELDS:
        check((fields.vertices[field] == wanted.vertices[field]).all(), f"{name}: {field}")
    for field in TRIANGLE_FIELDS:
        check((fields.faces[field] == wanted.faces[field]).all(), f"{name}: {field}")


def size(values):
    return float(numpy.abs(values).max())


def check_figures(fields, report):
    vertices, evolve = fields.vertices, report["evolve"]
    inner = vertices["inner"] == 1.0
    check(inner.sum() == evolve["after"]["inner_vertices"], "number of inner vertices")
    for field, figures in (("defect", evolve["after"]), ("input_defect", evolve["before"])):
        defects = vertices[field][inner]
        near(size(defects), figures["e_max"], 0.0, f"largest {field}")
        near(float(numpy.abs(defects).mean()), figures["e_avg"], 1e-15, f"mean {field}")
        near(float((defects**2).sum()), figures["energy"], 1e-14, f"squares of {field}")
        check((vertices[field][~inner] == 0.0).all(), f"{field} of the border")
    for field, unfold in (("edge_strain", "unfold"), ("input_edge_strain", "unfold_before")):
        near(size(vertices[field]), report[unfold]["strain"]["max"], 0.0, f"largest {field}")
    moves, deviation = vertices["move"], evolve["deviation"]
    near(size(moves), deviation["max"], 1e-14 * size(moves), "largest move")
    rms = float(numpy.sqrt((moves[inner] ** 2).mean()))
    near(rms, deviation["rms"], 1e-12 * rms, "rms move")
    check((numpy.abs(vertices["offset"]) <= moves * (1 + 1e-12)).all(), "offset beyond the move")
    check((fields.faces["strain_min"] <= fields.faces["strain_max"]).all(), "order of strains")


def main():
    planish, folder = sys.argv[1], roundtrip.temporary_folder()
    run(planish, "sample", "panel", "-o", folder / "panel.obj", "--vertices", "300")
    reports = {}
    for extension in ("ply", "vtu", "vtp", "csv"):
        reports[extension] = json.loads(run(
            planish, "flatten", folder / "panel.obj", "-o", folder / "out", "--formats", "svg",
            "--method", "controllable", "--sweeps", "5", "--json", "--quiet",
            "--fields", folder / f"fields.{extension}",
        ))  # fmt: skip
    fields = by_meshio(folder / "fields.ply")
    check_figures(fields, reports["ply"])
    processed = meshio.read(folder / "out" / "processed.obj")
    check((fields.points == processed.points).all(), "positions of the processed patch")
    check_equal(by_meshio(folder / "fields.vtu"), fields, "VTU")
    check_equal(by_xml(folder / "fields.vtp"), fields, "VTP")
    check_equal(by_csv(folder / "fields.csv"), fields, "CSV")
    print("fields: all as written")


if __name__ == "__main__":
    sys.exit(main())
