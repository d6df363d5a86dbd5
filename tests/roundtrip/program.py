"""Runs planish on a sample and compares the patterns that it writes with the flat mesh."""

import pathlib
import re
import shutil
import sys

import roundtrip
from roundtrip import check, near, run

try:
    import ezdxf
    from ezdxf import bbox
except ImportError:
    roundtrip.skip("python3-ezdxf")


def flat_size(path):
    """Width and height of a mesh in the plane, in its own unit."""
    places = [line.split()[1:3] for line in path.read_text().splitlines() if line.startswith("v ")]
    xs, ys = [float(x) for x, _ in places], [float(y) for _, y in places]
    return max(xs) - min(xs), max(ys) - min(ys)


def cut_size(path):
    document = ezdxf.readfile(path)
    audit = document.audit()
    check(not audit.errors and not audit.fixes, f"{path.name}: not sound")
    cut = [line for line in document.modelspace().query("POLYLINE") if line.dxf.layer == "cut"]
    check(len(cut) == 1 and cut[0].is_closed, f"{path.name}: one closed outline")
    box = bbox.extents(cut)
    return box.size.x, box.size.y


def main():
    planish = pathlib.Path(sys.argv[1]).resolve()
    folder = roundtrip.temporary_folder()
    patch = folder / "dome.obj"
    run(planish, "sample", "dome", "--vertices", "600", "-o", patch, "--quiet")
    run(planish, "unfold", patch, "-o", folder / "flat.obj", "--quiet")
    run(planish, "flatten", patch, "-o", folder / "out", "--sweeps", "0", "--unit", "cm",
        "--paper", "a4", "--formats", "svg,dxf,pdf,plt", "--quiet")
    wanted = [10.0 * side for side in flat_size(folder / "flat.obj")]
    for found, side in zip(cut_size(folder / "out/pattern.dxf"), wanted):
        near(found, side, 0.002, "side of the pattern in mm")
    numbers = re.findall(r"SP1;\n(.*?)PU;\n", (folder / "out/pattern.plt").read_text(), re.DOTALL)
    places = [int(number) for number in re.findall(r"-?\d+", numbers[0])]
    near((max(places[::2]) - min(places[::2])) / 40.0, wanted[0], 0.03, "width in HPGL")
    near((max(places[1::2]) - min(places[1::2])) / 40.0, wanted[1], 0.03, "height in HPGL")
    if shutil.which("qpdf"):
        for name in ("pattern.pdf", "pattern-a4.pdf"):
            run("qpdf", "--check", folder / "out" / name)
    print("planish: all formats agree with the flat mesh")


if __name__ == "__main__":
    sys.exit(main())
