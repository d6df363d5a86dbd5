#!/usr/bin/env python3
"""Tries planish.exe under Wine, as a user of Windows would: names in any script, drive letters, long names, devices,
Ctrl-C, results that are used again, files dropped onto it.

    tests/windows/program.py PLANISH.EXE [LINUX_PLANISH]

Uses the wine of WINEPREFIX. With the Linux program too, the bad files of PLANISH_TEST_DATA have to end with the same
exit code from both.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

EXE = os.path.abspath(sys.argv[1])
LINUX = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
DATA = os.environ.get("PLANISH_TEST_DATA", "")
NAMES = ["Schloß ö", "日本", "Ж", "🧵 שלום", "a 'b' (c) & d%e"]


def planish(*args, folder=None, **more):
    return subprocess.run(["wine", EXE, *args], cwd=folder, capture_output=True, check=False, **more)


def windows_path(path):
    """Z: is the root of this system."""
    return "Z:" + str(path).replace("/", "\\")


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        done = planish("sample", "panel", "--vertices", "300", "-o", "panel.obj", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)

    def files(self):
        return sorted(p.relative_to(self.folder).as_posix() for p in self.folder.rglob("*"))

    def run_well(self, *args):
        done = planish(*args, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        return done


class Names(InFolder):
    def test_in_any_script(self):
        for name in NAMES:
            os.rename(self.folder / "panel.obj", self.folder / f"{name}.obj")
            done = self.run_well("flatten", f"{name}.obj", "--method", "controllable", "--sweeps", "2")
            self.assertIn(name, done.stdout.decode())
            self.assertTrue((self.folder / f"{name}-pattern" / "pattern.svg").is_file(), self.files())
            page = (self.folder / f"{name}-pattern" / "report.html").read_text(encoding="utf-8")
            self.assertIn(name.split()[0], page)
            os.rename(self.folder / f"{name}.obj", self.folder / "panel.obj")

    def test_in_lists_and_products(self):
        names = [f"{name}.obj" for name in NAMES[:3]]
        for name in names:
            shutil.copy(self.folder / "panel.obj", self.folder / name)
        done = self.run_well("measure", *names, "--csv", "Ж.csv")
        self.assertEqual(done.stderr, b"")
        table = (self.folder / "Ж.csv").read_text(encoding="utf-8")
        for name in names:
            self.assertIn(name, table)
        self.run_well("flatten", *names, "-o", "日本/out", "--method", "controllable", "--sweeps", "1")
        for name in NAMES[:3]:
            folder = self.folder / "日本" / "out" / name.replace(" ", "_")
            self.assertTrue((folder / "pattern.svg").is_file(), self.files())

    def test_of_windows(self):
        place = windows_path(self.folder)
        for name in (place + "\\panel.obj", place.replace("\\", "/") + "/panel.obj", ".\\panel.obj",
                     "\\\\?\\" + place + "\\panel.obj"):
            done = self.run_well("measure", name, "--json")
            self.assertGreater(json.loads(done.stdout)["e_max"], 0)
        self.run_well("evolve", place + "\\panel.obj", "-o", place + "\\x\\y.ply", "--sweeps", "1")
        self.assertTrue((self.folder / "x" / "y.ply").is_file(), self.files())

    def test_that_begin_with_a_slash_are_paths(self):
        self.assertEqual(planish("measure", str(self.folder / "panel.obj")).returncode, 0)
        done = planish("measure", "/none.obj")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"/none.obj", done.stderr)

    def test_on_a_drive_that_is_not_there(self):
        for name in ("Q:\\none\\a.obj", "Q:a.obj", "Q:none\\a.obj"):
            done = planish("convert", "panel.obj", name, folder=self.folder, timeout=60)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(b"Q:", done.stderr)

    def test_with_a_quote_are_refused_before_the_work(self):
        done = planish("flatten", "panel.obj", "-o", 'out dm"', folder=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(b"backslash", done.stderr)

    def test_that_are_long(self):
        deep = self.folder.joinpath(*(60 * "x" + str(i) for i in range(6)))
        self.run_well("convert", "panel.obj", windows_path(deep / "a.obj"))
        self.assertEqual((deep / "a.obj").read_bytes(), (self.folder / "panel.obj").read_bytes())

    def test_that_are_no_text(self):
        done = subprocess.run(["wine", EXE, "measure", b"a\xff.obj"], cwd=self.folder, capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 1, done.stderr)

    def test_of_devices(self):
        for args in (("measure", "NUL"), ("convert", "panel.obj", "NUL")):
            done = planish(*args, folder=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(b"NUL: ", done.stderr)
        done = planish("convert", "panel.obj", "NUL.obj", folder=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"name for a device", done.stderr)
        self.assertEqual(self.files(), ["panel.obj"])


class Streams(InFolder):
    def test_have_lines_as_on_other_systems(self):
        self.assertNotIn(b"\r", self.run_well("--help").stdout)
        self.assertNotIn(b"\r", planish("measure", "none.obj").stderr)

    def test_without_a_console_have_no_progress(self):
        done = self.run_well("evolve", "panel.obj", "-o", "a.ply", "--sweeps", "200")
        self.assertNotIn(b"[", done.stderr)

    def test_may_be_closed(self):
        done = planish("flatten", "panel.obj", "--sweeps", "1", "--method", "controllable", folder=self.folder,
                       preexec_fn=lambda: os.close(1))
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertTrue((self.folder / "panel-pattern" / "pattern.svg").is_file())


class Runs(InFolder):
    def test_that_are_interrupted_write_nothing(self):
        self.run_well("sample", "panel", "--vertices", "20000", "-o", "large.ply")
        before = self.files()
        with subprocess.Popen(["wine", EXE, "flatten", "large.ply"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as run:
            time.sleep(2)
            run.send_signal(signal.SIGINT)
            _, said = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 130, said)
        self.assertIn(b"interrupted; nothing was written", said)
        self.assertEqual(self.files(), before)

    def test_are_resumed(self):
        (self.folder / "product").mkdir()
        for i in range(3):
            shutil.copy(self.folder / "panel.obj", self.folder / "product" / f"ö{i}.obj")
        args = ("flatten", "product", "--product", "-o", "out", "--method", "controllable", "--sweeps", "2", "--resume")
        self.run_well(*args)
        pattern = self.folder / "out" / "ö1" / "pattern.svg"
        written = pattern.stat().st_mtime_ns
        again = self.run_well(*args)
        self.assertEqual(again.stdout.decode().count("(from the earlier run)"), 3, again.stdout.decode())
        self.assertEqual(pattern.stat().st_mtime_ns, written)

    def test_replace_files_that_are_there(self):
        for _ in range(2):
            self.run_well("flatten", "panel.obj", "--method", "controllable", "--sweeps", "2")
        self.assertEqual([name for name in self.files() if "partial" in name], [])


class Drops(InFolder):
    """A program that `start` starts has a console of its own, as one that files are dropped onto. Wine makes that
    console on a display only."""

    def setUp(self):
        super().setUp()
        browser = self.folder / "bin" / "xdg-open"  # which Wine opens pages with
        browser.parent.mkdir()
        browser.write_text(f'#!/bin/sh\nprintf "%s" "$1" >"{self.folder}/opened"\n', encoding="utf-8")
        browser.chmod(0o755)
        self.environment = {**os.environ, "PATH": f"{browser.parent}:{os.environ['PATH']}"}

    def drop(self, *names):
        dropped = [windows_path(self.folder / name) for name in names]
        subprocess.run(["xvfb-run", "-a", "wine", "start", "/wait", windows_path(EXE), *dropped], cwd="/",
                       env=self.environment, timeout=120,
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        for _ in range(600):  # in a new Wine the first page takes long
            if (self.folder / "opened").exists():
                break
            time.sleep(0.1)

    def test_flatten_a_mesh_beside_itself_and_open_the_page(self):
        (self.folder / "日本").mkdir()
        os.rename(self.folder / "panel.obj", self.folder / "日本" / "ö b.obj")
        self.drop("日本/ö b.obj")
        self.assertTrue((self.folder / "日本" / "ö b-pattern" / "pattern.svg").is_file(), self.files())
        opened = (self.folder / "opened").read_text(encoding="utf-8")
        self.assertTrue(opened.startswith("file:///") and opened.endswith("-pattern/report.html"), opened)


@unittest.skipUnless(LINUX and os.path.isdir(f"{DATA}/bad"), "no Linux program or no bad files")
class BadFiles(unittest.TestCase):
    def test_end_as_on_linux(self):
        bad = pathlib.Path(DATA) / "bad"
        names = [line.split("\t")[0] for line in (bad / "expect.tsv").read_text(encoding="utf-8").splitlines()[1:]]
        self.assertGreater(len(names), 50)
        for name in names:
            if not (bad / name).exists():
                continue
            args = ["measure", name, "--json"]
            here = subprocess.run([LINUX, *args], cwd=bad, capture_output=True, check=False)
            there = planish(*args, folder=bad)
            self.assertEqual((there.returncode, there.stdout, there.stderr),
                             (here.returncode, here.stdout, here.stderr), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
