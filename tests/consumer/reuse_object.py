#!/usr/bin/env python3
"""Runs a compiler, unless an object of the very same command lies in another build folder.

    reuse_object.py OTHER_FOLDER FOLDER COMMAND...

FOLDER is the folder that this build's copy of the project has its files in. Where the commands
differ in more than these two folders, and the name of the object, the compiler runs.
"""

import json
import os
import pathlib
import shlex
import shutil
import sys


def plain(command, folder):
    """The command without the folder it runs for, the object, and what only affects warnings."""
    words = [word.replace(folder, "FOLDER") for word in command if word != "-Werror"]
    # What is written beside the object, for the next build.
    while "-MD" in words:
        at = words.index("-MD")
        del words[at:at + 5]  # -MD -MT OBJECT -MF FILE
    words[words.index("-o") + 1] = "OBJECT"
    return words


def main():
    other, folder, command = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    if "-c" in command:
        source = command[command.index("-c") + 1]
        for entry in json.loads((other / "compile_commands.json").read_text()):
            there = shlex.split(entry["command"])
            if entry["file"] != source or plain(there, str(other)) != plain(command, folder):
                continue
            made = other / there[there.index("-o") + 1]
            if made.exists() and made.stat().st_mtime > os.stat(source).st_mtime:
                shutil.copyfile(made, command[command.index("-o") + 1])
                with open(command[command.index("-MF") + 1], "w") as depfile:
                    depfile.write(f"{command[command.index('-o') + 1]}: {source}\n")
                sys.exit(0)
    os.execvp(command[0], command)


if __name__ == "__main__":
    main()
