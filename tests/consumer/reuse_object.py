#!/usr/bin/env python3
"""Runs a compiler, or copies the object if another build folder has compiled it by the same command.

    reuse_object.py OTHER_FOLDER FOLDER COMMAND...

FOLDER is this build's folder for the project. The commands may differ in these two folders, in the
name of the object and in -Werror. The other build must be up to date.
"""

import json
import os
import pathlib
import shlex
import shutil
import sys


def plain(command, folder):
    """The command without the build folder, the name of the object and -Werror."""
    words = [word.replace(folder, "FOLDER") for word in command if word != "-Werror"]
    # The dependency file.
    while "-MD" in words:
        at = words.index("-MD")
        del words[at:at + 5]  # -MD -MT OBJECT -MF FILE
    words[words.index("-o") + 1] = "OBJECT"
    return words


def same_text(first, second):
    """Whether two files, of which a build folder may have made each, have the same text."""
    return first == second or pathlib.Path(first).read_bytes() == pathlib.Path(second).read_bytes()


def main():
    other, folder, command = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    if "-c" in command:
        source = command[command.index("-c") + 1]
        for entry in json.loads((other / "compile_commands.json").read_text()):
            there = shlex.split(entry["command"])
            if plain(there, str(other)) != plain(command, folder) or not same_text(entry["file"], source):
                continue
            made = other / there[there.index("-o") + 1]
            if made.exists() and made.stat().st_mtime > os.stat(entry["file"]).st_mtime:
                shutil.copyfile(made, command[command.index("-o") + 1])
                with open(command[command.index("-MF") + 1], "w") as depfile:
                    depfile.write(f"{command[command.index('-o') + 1]}: {source}\n")
                sys.exit(0)
    os.execvp(command[0], command)


if __name__ == "__main__":
    main()
