"""Keywords are the program's flags: each has one, or a reason why not."""

import inspect
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import planish

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))
import generate  # noqa: E402

OWN = {"mesh", "faces", "name", "progress", "own", "patches", "result", "path", "as_designed"}
VERBS = ["measure", "flatten", "evolve", "unfold", "compare", "suggest_cuts", "suggest_panels", "sample"]


class Keywords(unittest.TestCase):
    def keywords_of(self, function):
        return set(inspect.signature(getattr(planish, function)).parameters) - OWN

    def test_every_flag_is_a_keyword_or_left_out(self):
        description = planish.describe()
        globals_ = {generate.keyword_of(flag) for flag in description["every_verb"]}
        for function in VERBS:
            verb = next(v for v in description["verbs"] if v["name"] == generate.FUNCTIONS[function][0])
            flags = {generate.keyword_of(flag) for group in verb["groups"] for flag in group["flags"]} | globals_
            left_out = set(generate.LEFT_OUT) | set(generate.LEFT_OUT_OF.get(function, {}))
            keywords = self.keywords_of(function)
            self.assertEqual(keywords - flags, set(), function)
            self.assertEqual(flags - keywords - left_out, set() if function != "sample" else {"threads"}, function)
            self.assertEqual(keywords & left_out, set(), function)

    def test_left_out_flags_are_there(self):
        description = planish.describe()
        flags = {generate.keyword_of(flag) for flag in description["every_verb"]}
        flags |= {generate.keyword_of(f) for v in description["verbs"] for g in v["groups"] for f in g["flags"]}
        self.assertEqual(set(generate.LEFT_OUT) - flags, set())

    def test_product_has_the_flags_of_several_patches(self):
        of_products = {"seam_tolerance", "no_match_seams"}
        given = self.keywords_of("flatten") - set(generate.LEFT_OUT_OF["flatten_product"]) | of_products
        self.assertEqual(self.keywords_of("flatten_product"), given | set(generate.READING))

    def test_of_reading_go_with_files_only(self):
        mesh = planish.sample("panel", vertices=300)
        with self.assertRaisesRegex(planish.RequestError, "--weld.*read"):
            planish.flatten_product({"front": mesh, "back": mesh}, weld=True)

    def test_sources_are_up_to_date(self):
        packages = pathlib.Path(planish._core.__file__).parent.parent
        tool = HERE.parent / "tools/generate.py"
        done = subprocess.run([sys.executable, tool, packages, "--check"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class Values(unittest.TestCase):
    def setUp(self):
        self.mesh = planish.sample("panel", vertices=300)

    def refuse(self, words, **keywords):
        with self.assertRaisesRegex(planish.RequestError, words) as caught:
            planish.evolve(self.mesh, **keywords)
        self.assertIsInstance(caught.exception, ValueError)

    def test_numbers_keep_all_digits(self):
        for third in (1 / 3, np.float64(1 / 3), "0.3333333333333333", np.array(1 / 3)):
            result = planish.evolve(self.mesh, method="classical", lambda_=third, sweeps=np.int32(1))
            self.assertEqual(result.figures["options"]["lambda"], 1 / 3)

    def test_ranges_are_the_programs(self):
        self.refuse("--lambda-max", lambda_max=11.0)
        self.refuse("--sweeps", sweeps=-1)
        self.refuse("--sweeps", sweeps=1.5)
        self.refuse("--lambda-max", lambda_max=float("nan"))
        self.refuse("--threads", threads=5000)
        self.refuse("unknown method clasical; did you mean classical", method="clasical")
        self.refuse("method controllable has no flag --tau", tau=0.5)
        self.refuse("--method needs a value", method="")

    def test_types(self):
        for value in ({}, object(), True, 1j, [None]):
            with self.assertRaises(TypeError):
                planish.evolve(self.mesh, lambda_max=value)
        with self.assertRaisesRegex(TypeError, "remesh must be True or False, not of type int"):
            planish.evolve(self.mesh, remesh=1)
        with self.assertRaisesRegex(TypeError, "unexpected keyword"):
            planish.evolve(self.mesh, lambda_maxx=1.0)
        with self.assertRaisesRegex(ValueError, "number 0"):
            planish.unfold(self.mesh, piece_name="a\0b")

    def test_none_and_false_are_left_out(self):
        one = planish.evolve(self.mesh, remesh=False, max_deviation=None)
        np.testing.assert_array_equal(one.vertices, planish.evolve(self.mesh).vertices)

    def test_text_of_any_kind(self):
        for text in ("-x", "--note", "a=b", "日本 ö Ж", "{}", "[1,2]", " ", '"'):
            svg = planish.unfold(self.mesh, note=text, piece_name="front").svg()
            self.assertIn("front", svg)

    def test_rows_and_files_say_the_same(self):
        by_rows = planish.evolve(self.mesh, fix=[150, 151], sweeps=3)
        by_array = planish.evolve(self.mesh, fix=np.array([150, 151]), sweeps=3)
        mask = np.isin(np.arange(len(self.mesh.vertices)), [150, 151])
        for some_mask in (mask, list(mask)):
            by_mask = planish.evolve(self.mesh, fix=some_mask, sweeps=3)
            np.testing.assert_array_equal(by_mask.vertices, by_rows.vertices)
        np.testing.assert_array_equal(by_rows.vertices, by_array.vertices)
        np.testing.assert_array_equal(by_rows.vertices[150], self.mesh.vertices[150])
        weights = np.ones(len(self.mesh.vertices))
        weights[100] = 5.0
        by_list = planish.evolve(self.mesh, method="least_norm", weights=weights)
        by_map = planish.evolve(self.mesh, method="least_norm", weights={100: 5.0})
        np.testing.assert_array_equal(by_list.vertices, by_map.vertices)

    def test_bad_rows_name_the_keyword(self):
        with self.assertRaises(planish.FormatError) as caught:
            planish.evolve(self.mesh, fix=[0, 300_000])
        self.assertEqual((caught.exception.place.path, caught.exception.place.line), ("fix", 2))
        self.assertTrue(str(caught.exception).startswith("fix:2: "))

    def test_sequences_of_another_length(self):
        count = len(self.mesh.vertices)
        for keyword, value in (("fix", np.ones(5, bool)), ("fix", [True] * (count + 1)), ("weights", np.ones(5))):
            with self.assertRaisesRegex(ValueError, f"{keyword} has .* but the mesh has {count} vertices"):
                planish.evolve(self.mesh, method="least_norm", **{keyword: value})

    def test_values_stay_what_they_are(self):
        package = HERE.parent
        for path in [*package.glob("src/*"), *package.glob("planish/**/*.py")]:
            self.assertNotRegex(path.read_text(encoding="utf-8"), r"\brepr\(|[Tt]empfile|NamedTemporary", path)

    def test_rows_hold_numbers_as_texts_do(self):
        by_numbers = planish.unfold(self.mesh, allowance=10, notches=[[0, "v"], [0.25, "t", "double"], [np.float64(0.5)]])
        by_texts = planish.unfold(self.mesh, allowance="10mm", notches=["0 v", "0.25 t double", "50% # middle"])
        self.assertEqual(by_numbers.svg(), by_texts.svg())
        for row, words in (([0.5, "w"], "notches:1: .*no kind of notch"), ([-1], "notches:1: \"-1\" is not the number")):
            with self.assertRaisesRegex(planish.Error, words):
                planish.unfold(self.mesh, notches=[row])

    def test_grain_and_fold_are_numbers(self):
        by_numbers = planish.unfold(self.mesh, grain=np.array([0.1, 0, 1 / 3])).svg()
        self.assertEqual(by_numbers, planish.unfold(self.mesh, grain="0.1,0,0.3333333333333333").svg())
        self.assertEqual(planish.unfold(self.mesh, grain=30).svg(), planish.unfold(self.mesh, grain="30deg").svg())
        with self.assertRaisesRegex(planish.RequestError, "--grain is \"0,1\" but must be a direction"):
            planish.unfold(self.mesh, grain=[0, 1])
        with self.assertRaisesRegex(planish.RequestError, "--fold is \"1.5\" but must be a whole number"):
            planish.unfold(self.mesh, fold=[0, 1.5])

    def test_obstacles_are_meshes(self):
        middle = self.mesh.vertices.mean(axis=0) - [0, 0, 50]
        corners = middle + 10 * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
        sides = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
        by_arrays = planish.evolve(self.mesh, method="local_perturbation", sweeps=2, obstacle=(corners, sides))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "obstacle.ply")
            planish.write(path, corners, sides)
            by_file = planish.evolve(self.mesh, method="local_perturbation", sweeps=2, obstacle=path)
        np.testing.assert_array_equal(by_arrays.vertices, by_file.vertices)
        with self.assertRaisesRegex(planish.MeshError, "the obstacle: .* no inside"):
            planish.evolve(self.mesh, method="local_perturbation", obstacle=self.mesh)

    def test_cuts_of_a_suggestion(self):
        dome = planish.sample("dome", vertices=400)
        cuts = planish.suggest_cuts(dome, max_strain="5%")
        result = planish.unfold(dome, cut=cuts.cuts, max_strain="5%")
        np.testing.assert_array_equal(result.uv, cuts.uv)
        self.assertTrue(result.notes[0].startswith("cut: cut open along"), result.notes)

    def test_seams_of_panels(self):
        dome = planish.sample("dome", vertices=400)
        panels = planish.suggest_panels(dome, max_rms_strain="1%", effort=1, symmetric="no")
        self.assertTrue(panels.met)
        result = planish.unfold(panels, cut=panels.seams, cut_along="edges", max_rms_strain="1%")
        self.assertAlmostEqual(result.figures["cut"]["length"], panels.figures["length"], 9)

    def test_cuts_by_words(self):
        cylinder = planish.sample("cylinder", vertices=400)
        one = planish.unfold(cylinder, cut="line 0 209")
        several = planish.unfold(cylinder, cut=["line 0 209"])
        rows = planish.unfold(cylinder, cut=[[0, 209]])
        np.testing.assert_array_equal(one.uv, several.uv)
        np.testing.assert_array_equal(one.uv, rows.uv)


if __name__ == "__main__":
    unittest.main()
