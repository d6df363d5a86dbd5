"""Many files, one by one."""

import pathlib
import tempfile
import unittest

import planish


class Many(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)
        self.paths = []
        for shape in ("panel", "saddle", "dome"):
            self.paths.append(self.folder / f"{shape}.obj")
            planish.write(self.paths[-1], planish.sample(shape, vertices=120))
        (self.folder / "bad.obj").write_text("v 0 0\n", encoding="utf-8")
        self.paths.append(self.folder / "bad.obj")

    def test_records_are_in_the_order_of_the_files(self):
        out = self.folder / "out"
        records = planish.flatten_many(self.paths, out=out, workers=2, no_report=True, csv=self.folder / "t.csv")
        self.assertEqual([record["path"] for record in records], [str(path) for path in self.paths])
        self.assertEqual(records[3]["error"]["code"], "malformed_file")
        alone = planish.flatten(planish.read(self.paths[1]), no_report=True)
        self.assertEqual(records[1]["figures"]["strain_rms"], alone.figures["unfold"]["strain"]["rms"])
        self.assertEqual((out / "saddle" / "pattern.svg").read_text(encoding="utf-8"), alone.svg())
        self.assertEqual(len((self.folder / "t.csv").read_text(encoding="utf-8").splitlines()), 5)

    def test_shards_and_resume(self):
        listed = self.folder / "list.txt"
        listed.write_text("panel.obj\nsaddle.obj\ndome.obj\n", encoding="utf-8")
        out = self.folder / "out"
        first = planish.flatten_many(listed, out=out, shard="1/2", no_report=True)
        self.assertEqual([record["patch"] for record in first], ["panel", "dome"])
        again = planish.flatten_many(listed, out=out, resume=True, no_report=True)
        self.assertEqual([record["kept"] for record in again], [True, False, True])

    def test_failures_are_kept(self):
        planish.flatten_many(self.paths, out=self.folder / "o", keep_failures=self.folder / "f", no_report=True)
        self.assertEqual(sorted(path.name for path in (self.folder / "f").iterdir()), ["bad.error.json", "bad.obj"])

    def test_what_is_asked_wrongly_is_refused(self):
        out = self.folder / "out"
        self.assertEqual(planish.flatten_many([], out=out), [])
        with self.assertRaises(planish.RequestError):
            planish.flatten_many(self.paths, out=out, shard="3/2")
        with self.assertRaises(planish.RequestError):
            planish.flatten_many(self.paths[0], out=out)
        with self.assertRaises(planish.FileError):
            planish.flatten_many(self.folder / "nowhere.txt", out=out)
        with self.assertRaises(TypeError):
            planish.flatten_many(self.paths, out=out, fix=[1])
        self.assertFalse(out.exists())

    def test_progress_cancels(self):
        with self.assertRaises(planish.Cancelled):
            planish.flatten_many(self.paths, out=self.folder / "out", progress=lambda *_: False, workers=1)


if __name__ == "__main__":
    unittest.main()
