"""Results: figures, drawings, files, reports, products, errors."""

import gc
import json
import pathlib
import resource
import sys
import tempfile
import types
import unittest
import warnings

import numpy as np

import planish
from planish import errors

REPO = pathlib.Path(__file__).resolve().parent.parent.parent.parent


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.panel = planish.sample("panel", vertices=400)
        cls.result = planish.flatten(cls.panel, max_strain="2%", allowance="10mm")
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_flatten(self):
        result = self.result
        n, m = len(self.panel.vertices), len(self.panel.faces)
        self.assertEqual(result.uv.shape, (n, 2))
        self.assertEqual(result.faces.shape, (m, 3))
        self.assertTrue(result.limits_met)
        self.assertTrue(result.usable)
        self.assertLessEqual(result.strain_max, 0.02)
        self.assertAlmostEqual(np.ptp(result.uv[:, 0]), result.width)
        self.assertEqual(result.figures["schema"], 2)
        self.assertEqual(result.fields["defect"].shape, (n,))
        self.assertEqual(result.fields["strain_max"].shape, (m,))

    def test_form(self):
        seat = planish.flatten(self.panel, pick=5)
        self.assertFalse(seat.form_kept)
        self.assertEqual(seat.missed, ["form"])
        self.assertTrue(seat.limits_met)
        self.assertFalse(seat.usable)
        for key in ("limits_met", "usable", "missed"):
            self.assertEqual(getattr(seat, key), seat.figures[key])
        self.assertIn("the form is lost", repr(seat))
        self.assertAlmostEqual(seat.deviation, seat.figures["evolve"]["deviation"]["max"])
        self.assertEqual(seat.smooth, seat.figures["evolve"]["smooth"])
        self.assertEqual(self.result.missed, [])
        self.assertTrue(self.result.form_kept)

    def test_remesh_says_where_vertices_come_from(self):
        result = planish.flatten(planish.sample("panel", vertices=6000), remesh=True)
        self.assertEqual(len(result.source), len(result.vertices))
        self.assertIsNone(self.result.source)

    def test_drawings(self):
        for form, start in {"svg": "<?xml", "dxf": "0\nSECTION\n", "plt": "IN;"}.items():
            text = getattr(self.result, form)(self.path / f"own.{form}")
            self.assertTrue(text.startswith(start), text[:20])
            self.assertEqual((self.path / f"own.{form}").read_bytes().decode(), text)
        self.assertTrue(self.result.pdf().startswith(b"%PDF"))
        self.assertNotEqual(self.result.pdf(paper="a4"), self.result.pdf())
        self.assertNotEqual(self.result.svg(as_designed=True), self.result.svg())
        self.assertEqual(planish.svg(self.result), self.result.svg())
        self.assertNotEqual(self.result.svg(grain=(0, 0, 1)), self.result.svg())
        unfolded = planish.unfold(self.panel, allowance="10mm", grain=[0, 0, 1])
        self.assertEqual(unfolded.svg(), planish.unfold(self.panel).svg(allowance="10mm", grain="0,0,1"))

    def test_sheets_say_what_the_mesh_cannot_show(self):
        places = [(50.0 * i, 300.0 * j, 3.0 * (i - 10) * (j - 0.5)) for j in range(2) for i in range(21)]
        faces = [face for i in range(20) for face in ((i, i + 1, i + 22), (i, i + 22, i + 21))]
        plate = planish.Mesh(np.array(places), np.array(faces))
        words = "see the mesh: no vertex inside"
        unfolded, flattened = planish.unfold(plate), planish.flatten(plate)
        for sheet in (unfolded.svg(), unfolded.svg(grain=90), flattened.svg(), flattened.svg(as_designed=True)):
            self.assertIn(words, sheet)
        for result in (unfolded, flattened, planish.evolve(plate), planish.suggest_cuts(plate)):
            self.assertEqual([caution["code"] for caution in result.figures["cautions"]], ["hidden_curvature"])

    def test_panels_are_the_product(self):
        corners = [(x, y, z) for z in (0, 100) for y in (0, 100) for x in (0, 100)]
        faces = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4)]
        faces += [(2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
        result = planish.suggest_panels(np.array(corners, float), np.array(faces), name="box", effort=1)
        self.assertTrue(result.met)
        self.assertAlmostEqual(result.figures["length"], 700)
        np.testing.assert_array_equal(result.vertices[:8], corners)
        self.assertEqual(len(result.panel_of), len(result.faces))
        self.assertEqual(result.panel_of.dtype, np.uint32)
        self.assertEqual(len(set(result.panel_of)), len(result.pieces))
        self.assertEqual(sum(len(piece.faces) for piece in result.pieces), len(result.faces))
        self.assertEqual(result.lines_text().count("\nl "), len(result.seams))
        self.assertEqual(planish.flatten(result.pieces[0]).figures["unfold"]["overlaps"], False)
        with self.assertRaises(planish.RequestError):
            planish.suggest_panels(self.panel, effort=0)
        with self.assertRaises(planish.Cancelled):
            planish.suggest_panels(self.panel, progress=lambda *_: False)

    def test_drawings_that_cannot_be(self):
        with self.assertRaisesRegex(TypeError, "has a pattern to draw"):
            planish.svg(planish.evolve(self.panel))
        with self.assertRaisesRegex(ValueError, "as_designed goes with"):
            planish.svg(planish.unfold(self.panel), as_designed=True)
        with self.assertRaises(planish.FileError) as caught:
            self.result.svg("/proc/nowhere/pattern.svg")
        self.assertEqual(caught.exception.code, "file_unwritable")
        with self.assertRaisesRegex(planish.RequestError, "allowance is 10000 mm"):
            self.result.svg(allowance="10m")

    def test_reports(self):
        compared = planish.compare(self.panel, methods=["controllable", "fairing"])
        for result in (self.result, compared):
            page = result._repr_html_()
            self.assertTrue(page.startswith("<iframe srcdoc="))
            self.assertNotIn("<html", page)
            self.assertIn("<html", result.report_html())
        self.assertIn("<svg", planish.unfold(self.panel)._repr_html_())

    def test_compare(self):
        compared = planish.compare(self.panel, methods=["controllable", "fairing"], sweeps=3)
        self.assertEqual([run.method for run in compared.runs], ["controllable", "fairing"])
        alone = planish.evolve(self.panel, method="controllable", sweeps=3)
        np.testing.assert_array_equal(compared.runs[0].vertices, alone.vertices)
        self.assertTrue(compared.history_csv().startswith("method,"))
        self.assertIn(compared.best.method if compared.best else "", ["", "controllable", "fairing"])

    def test_product(self):
        meshes = {"front": self.panel, "back": planish.sample("saddle", vertices=300), "broken": self.panel}
        faces = np.concatenate([self.panel.faces, self.panel.faces[:1]])
        meshes["broken"] = planish.Mesh(self.panel.vertices, faces)
        product = planish.flatten_product(meshes, name="suit", max_strain="2%")
        self.assertEqual(product.names, ["front", "back", "broken"])
        self.assertEqual(list(product.failures), ["broken"])
        self.assertIsNone(product.patches[2])
        alone = planish.flatten(meshes["front"], name="front", max_strain="2%")
        np.testing.assert_array_equal(product.patches[0].uv, alone.uv)
        self.assertIn("<svg", product.layout_svg())
        self.assertEqual(product.figures["name"], "suit")
        self.assertEqual(product.missed["broken"], ["failure"])
        self.assertNotIn("front", product.missed)
        paths = product.save(self.path / "suit")
        self.assertEqual(sorted(paths), ["garment_html", "garment_json", "garment_svg"])
        figures = json.loads(pathlib.Path(paths["garment_json"]).read_text(encoding="utf-8"))
        self.assertEqual([patch["name"] for patch in figures["patches"]], product.names)
        self.assertEqual((self.path / "suit/front/pattern.svg").read_text(encoding="utf-8"), product.patches[0].svg())
        self.assertFalse((self.path / "suit/broken").exists())

    def test_product_in_the_wrong_unit(self):
        small = planish.Mesh(0.001 * self.panel.vertices, self.panel.faces)
        product = planish.flatten_product({"front": small, "back": self.panel})
        self.assertIn("size", product.missed["front"])
        self.assertIn("with --unit m it would be", " ".join(product.notes))
        self.assertNotIn("size", product.missed.get("back", []))

    def write_in_inches(self, name, panel):
        path = self.path / name
        planish.write(path, panel)
        path.write_text("# File units = inches\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
        return path

    def test_unit_of_a_file(self):
        path = self.write_in_inches("inches.obj", planish.Mesh(0.01 * self.panel.vertices, self.panel.faces))
        mesh = planish.read(path)
        self.assertEqual(mesh.unit, "in")
        self.assertIn('the file says "File units = inches"', " ".join(mesh.notes))
        other = planish.read(path, unit="cm")
        self.assertEqual(other.unit, "cm")
        self.assertIn("but unit= says cm, which is taken", " ".join(other.notes))
        self.assertIn("the mesh is in in, but unit= says cm", " ".join(planish.unfold(mesh, unit="cm").notes))
        middles = mesh.vertices[mesh.faces].mean(axis=1)
        inner = np.linalg.norm(middles - middles.mean(axis=0), axis=1).argmin()
        holed = planish.Mesh(mesh.vertices, np.delete(mesh.faces, inner, axis=0))
        path = self.write_in_inches("holed.obj", holed)
        corners = mesh.vertices[mesh.faces[inner]]
        millimetres = f"{25.5 * np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).sum():.3f}mm"
        self.assertEqual(len(planish.read(path, fill_holes=millimetres).faces), len(mesh.faces))
        self.assertEqual(len(planish.read(path, fill_holes=millimetres, unit="m").faces), len(holed.faces))

    def test_what_reading_did_is_said_of_results(self):
        twice = planish.Mesh(self.panel.vertices, np.concatenate([self.panel.faces, self.panel.faces[:3]]))
        path = self.path / "twice.obj"
        planish.write(path, twice)
        mesh = planish.read(path)
        for result in (planish.unfold(path), planish.flatten(mesh), planish.evolve(mesh, sweeps=1),
                       planish.flatten_product([path, path]), planish.flatten_product({"one": mesh, "two": mesh})):
            self.assertIn("left out 3 triangles", " ".join(result.notes))

    def test_product_in_the_unit_of_its_files(self):
        paths = [self.write_in_inches(name, self.panel) for name in ("one.obj", "two.obj")]
        alone = planish.flatten(paths[0])
        for patches in (paths, [planish.read(path) for path in paths]):
            product = planish.flatten_product(patches, no_match_seams=True)
            self.assertEqual(product.figures["patches"][0]["unfold"]["unit"], "in")
            np.testing.assert_array_equal(product.patches[0].uv, alone.uv)

    def test_cautions_are_notes(self):
        angles = np.linspace(0.0, np.pi / 2, 5)
        arc = np.stack([1000 * np.cos(angles), np.zeros(5), 1000 * np.sin(angles)], axis=1)
        vertices = np.concatenate([arc + [0.0, y, 0.0] for y in (0.0, 200.0, 400.0)])
        corners = [5 * row + column for row in range(2) for column in range(4)]
        faces = [face for a in corners for face in ((a, a + 1, a + 6), (a, a + 6, a + 5))]
        mesh = planish.Mesh(vertices, faces)
        for result in (planish.unfold(mesh), planish.flatten(mesh), planish.flatten_product([mesh, mesh])):
            self.assertIn("22.5", " ".join(result.notes))

    def test_product_of_files(self):
        paths = [self.path / name for name in ("one.obj", "two.ply")]
        for path in paths:
            planish.write(path, self.panel)
        product = planish.flatten_product(paths)
        self.assertEqual(len(product.patches), 2)
        np.testing.assert_array_equal(product.patches[0].uv, product.patches[1].uv)

    def test_seams_of_a_product_match(self):
        def strip(first):
            columns, rows = np.meshgrid(np.arange(first, first + 7), np.arange(9), indexing="ij")
            x, y = columns.ravel() * 10.0, rows.ravel() * 10.0
            corners = [9 * i + j for i in range(6) for j in range(8)]
            faces = [face for a in corners for face in ((a, a + 9, a + 10), (a, a + 10, a + 1))]
            return planish.Mesh(np.stack([x, y, 0.006 * x * x - 0.004 * y * y], axis=1), faces)

        strips = {"left": strip(0), "right": strip(6)}
        seams = planish.flatten_product(strips, pick=1).figures["seams"]
        self.assertEqual(len(seams), 1)
        self.assertLess(seams[0]["difference"], 1e-6)
        free = planish.flatten_product(strips, pick=1, no_match_seams=True).figures["seams"]
        self.assertGreater(free[0]["difference"], 1e-3)

    def test_product_of_nothing(self):
        with self.assertRaises(planish.FormatError):
            planish.flatten_product([])
        with self.assertRaises(planish.RequestError):
            planish.flatten_product([self.panel], match_seams=True, seam_tolerance=-1.0)

    def test_read_and_write(self):
        for form in ("obj", "ply", "off"):
            planish.write(self.path / f"panel.{form}", self.panel)
            mesh = planish.read(self.path / f"panel.{form}")
            self.assertEqual(mesh.name, "panel")
            np.testing.assert_array_equal(mesh.vertices, self.panel.vertices)
        with self.assertRaises(planish.FileError):
            planish.write(self.path / "panel.step", self.panel)
        bad = self.path / "bad.obj"
        bad.write_text("v 0 0 0\nv 1 0 x\n")
        with self.assertRaises(planish.FormatError) as caught:
            planish.flatten(bad)
        self.assertEqual((caught.exception.place.path, caught.exception.place.line), (str(bad), 2))
        with self.assertRaises(planish.FileError) as caught:
            planish.read(self.path / "none.obj")
        self.assertEqual(caught.exception.code, "file_not_found")

    def test_bytes_that_are_no_text(self):
        bad = self.path / "bad_bytes.obj"
        bad.write_bytes(b"v 0 0 0\nv 1 0 \xff\xfe\n")
        with self.assertRaises(planish.FormatError):
            planish.read(bad)
        with self.assertRaisesRegex(planish.FileError, "is not UTF-8 text"):
            planish.read("none-\udcff.obj")

    def test_names_of_files_in_any_script(self):
        for name in ("ö", "日本", "Ж"):
            path = self.path / f"{name}.obj"
            planish.write(path, self.panel)
            self.assertEqual(planish.read(path).name, name)
            self.assertIn(name, planish.unfold(path).svg())
        with self.assertRaisesRegex(planish.FileError, "日本-none"):
            planish.read(self.path / "日本-none.obj")

    def test_warnings_are_pythons(self):
        wide = planish.sample("cone", vertices=300)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            planish.unfold(wide)

    def test_other_packages_are_imported_late(self):
        self.assertFalse({"trimesh", "pyvista", "matplotlib"} & set(sys.modules))
        made = {}
        trimesh = types.SimpleNamespace(Trimesh=lambda **given: made.update(given) or "made")
        pyvista = types.SimpleNamespace(PolyData=lambda points, faces: (points, faces))
        sys.modules.update(trimesh=trimesh, pyvista=pyvista)
        try:
            self.assertEqual(self.result.to_trimesh(), "made")
            self.assertIs(made["vertices"].base, self.result)
            points, faces = self.result.to_pyvista(flat=True)
        finally:
            del sys.modules["trimesh"], sys.modules["pyvista"]
        np.testing.assert_array_equal(points[:, :2], self.result.uv)
        np.testing.assert_array_equal(faces.reshape(-1, 4)[:, 1:], self.result.faces)
        with self.assertRaisesRegex(ValueError, "no pattern"):
            self.panel.to_meshio(flat=True)


class Errors(unittest.TestCase):
    def test_every_code_has_a_family(self):
        page = (REPO / "docs/errors.md").read_text(encoding="utf-8")
        codes = {line[4:] for line in page.splitlines() if line.startswith("### ")}
        families = {code for codes_ in errors.FAMILIES.values() for code in codes_.split()}
        self.assertEqual(codes - families, {"internal_error", "out_of_memory"})
        self.assertEqual(families - codes, set())

    def test_a_place_shows_what_is_known(self):
        self.assertEqual(repr(errors.Place("a.obj", 3)), "Place(path='a.obj', line=3)")


class Leaks(unittest.TestCase):
    def test_a_thousand_calls(self):
        panel = planish.sample("panel", vertices=100)
        bad = np.array([[0, 1, 999]])

        def call():
            planish.evolve(panel.vertices, panel.faces, sweeps=1, fix=[50])
            result = planish.unfold(panel)
            result.uv, result.faces, result.figures, result.svg()
            for wrong in (lambda: planish.evolve(panel, lambda_max=99.0), lambda: planish.Mesh(panel.vertices, bad)):
                try:
                    wrong()
                except planish.Error:
                    pass

        for _ in range(100):
            call()
        gc.collect()
        before, objects = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, len(gc.get_objects())
        for _ in range(1000):
            call()
        gc.collect()
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        # A leak of one array of the mesh in each call would be 2.4 MB; that of a result a hundred.
        self.assertLess(grown, 2000, "KiB")
        self.assertLess(len(gc.get_objects()) - objects, 100)


if __name__ == "__main__":
    unittest.main()
