"""What the tests of the program from outside share."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def skip_without(*tools):
    for tool in tools:
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed")
            sys.exit(SKIPPED)


def output_of(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=120, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def own_folder():
    """A new folder that is removed at the end; it becomes the current one."""
    folder = tempfile.TemporaryDirectory(prefix="planish-")
    os.chdir(folder.name)
    return folder


def program_from_arguments(usage):
    if len(sys.argv) < 2:
        sys.exit(usage)
    return pathlib.Path(sys.argv[1]).resolve()
