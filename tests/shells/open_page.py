#!/usr/bin/env python3
"""--open starts the xdg-open of the search path with the page, says so where there is none, and changes no exit code.

open_page.py PLANISH
"""

import os
import pathlib
import subprocess
import time

from support import expect, output_of, own_folder, program_from_arguments

OPENER = """#!/bin/sh
printf '%s\\n' "$#" "$1" >opened.partial
cat >>opened.partial
mv opened.partial opened
"""


def run(program, *arguments, path):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=120, stdin=subprocess.PIPE,
                          env=os.environ | {"PATH": path})


def opened():
    """What the opener was called with; it may still be at work."""
    end = time.monotonic() + 30
    while not pathlib.Path("opened").exists():
        expect(time.monotonic() < end, "nothing was opened")
        time.sleep(0.02)
    lines = pathlib.Path("opened").read_text(encoding="utf-8").splitlines()
    pathlib.Path("opened").unlink()
    return lines


def main():
    program = program_from_arguments(__doc__)
    kept = own_folder()
    folder = pathlib.Path(kept.name).resolve()
    output_of(program, "sample", "panel", "--vertices", "200", "-o", "-panel.obj")
    (folder / "programs").mkdir()
    opener = folder / "programs" / "xdg-open"
    opener.write_text(OPENER, encoding="utf-8")
    opener.chmod(0o755)
    with_opener = f"{folder}/programs:{os.environ['PATH']}"

    done = run(program, "flatten", "--open", "--", "-panel.obj", path=with_opener)
    expect(done.returncode == 0, done.stderr)
    found = opened()
    expect(found == ["1", f"{folder}/-panel-pattern/report.html"], f"{found} was opened")
    expect("xdg-open" not in done.stderr, done.stderr)

    missed = ["flatten", "./-panel.obj", "--require-target", "--target-e-max", "1e-15", "--sweeps", "1"]
    expect(run(program, *missed, "--open", path=with_opener).returncode == 3, "a target is missed all the same")
    opened()

    done = run(program, "compare", "./-panel.obj", "--methods", "classical", "--open", path=with_opener)
    expect(done.returncode == 2 and "--output" in done.stderr, "compare writes no page without --output")
    done = run(program, "compare", "./-panel.obj", "--methods", "classical", "-o", "out", "--open", path=with_opener)
    expect(done.returncode == 0, done.stderr)
    expect(opened() == ["1", f"{folder}/out/compare.html"], "another page was opened")

    done = run(program, "flatten", "./-panel.obj", "--open", path=str(folder))
    expect(done.returncode == 0, done.stderr)
    notes = [line for line in done.stderr.splitlines() if "xdg-open" in line]
    expect(notes == ["note: cannot open -panel-pattern/report.html: xdg-open is not installed"], done.stderr)


if __name__ == "__main__":
    main()
