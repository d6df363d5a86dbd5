#!/usr/bin/env python3
"""Checks the syntax and warnings (-fsyntax-only) of all sources of a build folder that are not
compiled for the given targets. Exit code 1 if the compiler fails on any.

    check_syntax.py BUILD_FOLDER TARGET...
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys


def without_code(command):
    """The command, with precompiled headers as the plain ones that they are made of."""
    command = re.sub(r"-Xclang -include-pch -Xclang \S+ ", "", command)
    return shlex.split(command) + ["-fsyntax-only"]


def made(entry):
    return re.search(r" -o (\S+) ", entry["command"]).group(1)


def check(entry):
    done = subprocess.run(without_code(entry["command"]), cwd=entry["directory"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder, targets = pathlib.Path(sys.argv[1]), sys.argv[2:]
    needed = set(subprocess.run(["ninja", "-C", folder, "-t", "inputs", *targets], check=True,
                                stdout=subprocess.PIPE, text=True).stdout.splitlines())
    entries = [entry for entry in json.loads((folder / "compile_commands.json").read_text())
               if not entry["file"].endswith("cmake_pch.hxx.cxx") and made(entry) not in needed]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(check, entries))
    for code, text in results:
        print(text, end="")
    print(f"{len(entries)} further sources read")
    sys.exit(1 if any(code for code, text in results) else 0)


if __name__ == "__main__":
    main()
