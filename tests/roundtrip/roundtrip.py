"""What the round trips share: ending with a word, running a tool, measuring a picture.

A script is called with the program that makes its files, and ends with 0, with 1 and a word on what
is wrong, or with 77 where a tool that reads them is not installed.
"""

import atexit
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def need(*tools):
    missing = [tool for tool in tools if shutil.which(tool) is None]
    if missing:
        skip(", ".join(missing))


def skip(what):
    print(f"skipped: {what} is not installed")
    sys.exit(SKIPPED)


def check(right, message):
    if not right:
        print(f"WRONG: {message}")
        sys.exit(1)


def near(value, wanted, tolerance, what):
    check(abs(value - wanted) <= tolerance, f"{what} is {value}, not {wanted} to {tolerance}")


def run(*command):
    """Standard output of a command that must succeed."""
    done = subprocess.run([str(part) for part in command], capture_output=True, check=False)
    text = (done.stdout + done.stderr).decode(errors="replace")
    check(done.returncode == 0, f"{command[0]} ended with {done.returncode}:\n{text}")
    return done.stdout.decode(errors="replace")


def temporary_folder():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="planish_roundtrip_"))
    atexit.register(shutil.rmtree, folder)
    return folder


def known_files():
    """The folder where the program that was named has written the known drawing."""
    check(len(sys.argv) == 2, f"usage: {sys.argv[0]} PROGRAM")
    folder = temporary_folder()
    run(sys.argv[1], folder)
    return folder


class Picture:
    """A binary PPM file: pixels as (r, g, b), from the upper left corner."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        kind, width, height, largest, self.pixels = data.split(maxsplit=4)
        check(kind == b"P6" and largest == b"255", f"{path} is no picture that is known")
        self.width, self.height = int(width), int(height)
        # One white space ends the head; split() may have taken pixels for more of it.
        self.pixels = data[len(data) - 3 * self.width * self.height :]

    def box(self, is_wanted, left=0, top=0, right=None, bottom=None):
        """The box (left, top, right, bottom) around all pixels that are wanted, in pixels."""
        xs, ys = [], []
        for y in range(top, bottom or self.height):
            row = self.pixels[3 * y * self.width : 3 * (y + 1) * self.width]
            for x in range(left, right or self.width):
                if is_wanted(*row[3 * x : 3 * x + 3]):
                    xs.append(x)
                    ys.append(y)
        check(xs, "nothing of that colour is in the picture")
        return min(xs), min(ys), max(xs) + 1, max(ys) + 1


def is_red(r, g, b):
    return r > 200 and g < 130 and b < 130


def is_dark(r, g, b):
    return max(r, g, b) < 110


def check_square(picture, per_millimetre, left, top, side, what):
    """Measures the red square whose lower left part lies before x = 125 and below y = 60 mm."""
    box = picture.box(is_red, right=int(125 * per_millimetre), top=int(60 * per_millimetre))
    line = 0.2  # the width of the line lies half outside
    for found, wanted, name in (
        (box[0] / per_millimetre, left - line / 2, "left"),
        (box[1] / per_millimetre, top - line / 2, "top"),
        ((box[2] - box[0]) / per_millimetre, side + line, "width"),
        ((box[3] - box[1]) / per_millimetre, side + line, "height"),
    ):
        near(found, wanted, 0.2, f"{what}: {name} of the square in mm")
