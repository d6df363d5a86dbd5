#!/usr/bin/env python3
"""Asks the shells themselves what they offer with the scripts of `planish completion`.

completion.py PLANISH bash|zsh|fish
"""

import json
import os
import pathlib
import pty
import re
import select
import shlex
import sys
import time

from support import expect, output_of, own_folder, program_from_arguments, skip_without

# What is typed, up to the cursor -> all that is offered, or some of it.
ALL = {
    "planish fl": {"flatten"},
    "planish evo": {"evolve"},
    "planish --threads 2 descr": {"describe"},
    "planish flatten --unit ": {"mm", "cm", "dm", "m", "in"},
    "planish flatten --formats svg,d": {"svg,dxf"},
    "planish flatten --allowance 10mm ": {"a folder/", "panel.obj", "saddle.PLY", "suit.json"},
    "planish evolve ": {"a folder/", "panel.obj", "saddle.PLY"},
    "planish evolve panel.obj --history ": {"a folder/", "figures.csv"},
    "planish flatten panel.obj -o ": {"a folder/"},
    "planish evolve panel.obj --method f": {"flattenable_laplacian", "fairing"},
    "planish evolve panel.obj --prefer ": {"smooth", "flat", "near"},
    "planish flatten panel.obj --material n": {"neoprene"},
    "planish convert panel.obj s": {"saddle.PLY"},
    "planish sample ": {"panel", "saddle", "dome", "cylinder", "cone", "tangent"},
    "planish completion ": {"bash", "zsh", "fish"},
    "planish describe f": {"flatten", "frontier"},
    "planish flatten --allow": {"--allowance"},
}
# Bash alone knows the other names of flags: the rest would list them too.
BASH_ALONE = {"planish flatten --units c": {"cm"}, "planish flatten --unit=c": {"cm"}}
FILES = ("panel.obj", "saddle.PLY", "suit.json", "figures.csv", "notes.txt")


def words_of(line):
    """As bash takes it apart, with the word at the cursor."""
    words = shlex.split(line)
    return words + [""] if line.endswith(" ") else words


def offered_by_bash(script, line):
    words = words_of(line)
    # Bash takes "=" for a word.
    words = [part for word in words for part in (re.split("(=)", word) if "=" in word else [word])]
    command = (
        f"source {script}; COMP_WORDS=({shlex.join(words)}); COMP_CWORD={len(words) - 1}; "
        "_planish; printf '%s\\n' \"${COMPREPLY[@]}\""
    )
    return output_of("bash", "--norc", "-c", command).splitlines()


def offered_by_fish(script, line):
    lines = output_of("fish", "--no-config", "-c", f"source {script}; complete -C {shlex.quote(line)}")
    return [offer.split("\t")[0] for offer in lines.splitlines()]


class Zsh:
    """A zsh at a terminal, which lists what it would offer where Tab is pressed."""

    SETUP = """PS1=; unset zle_bracketed_paste; autoload -U compinit; compinit -u -D
fpath=(. $fpath); source {script}
zstyle ':completion:*' verbose no; zstyle ':completion:*' list-colors ''
compadd() {{
  if [[ ${{@[1,(i)(-|--)]}} == *-(O|A|D)\\ * ]]; then builtin compadd "$@"; return $?; fi
  local -a __hits; builtin compadd -A __hits "$@"
  print -rl -- ${{__hits/#/offer:}} >>$OFFERS
  builtin compadd "$@"
}}
list-offers() {{ : >$OFFERS; zle list-choices; print -r -- end: >>$OFFERS; zle kill-whole-line }}
zle -C list-choices list-choices _main_complete
zle -N list-offers; bindkey '^I' list-offers
print ready
"""

    def __init__(self, script):
        self.offers = pathlib.Path("offers").resolve()
        pathlib.Path("setup.zsh").write_text(self.SETUP.format(script=script), encoding="utf-8")
        environment = os.environ | {"OFFERS": str(self.offers), "TERM": "dumb", "LC_ALL": "C.UTF-8"}
        child, self.terminal = pty.fork()
        if child == 0:
            os.execvpe("zsh", ["zsh", "-f", "-i"], environment)
        self.type("source ./setup.zsh\n")
        self.wait(lambda: b"ready" in self.shown.split(b"setup.zsh", 1)[-1])

    shown = b""

    def type(self, text):
        os.write(self.terminal, text.encode())

    def wait(self, condition):
        end = time.monotonic() + 60
        while not condition():
            expect(time.monotonic() < end, f"zsh does not answer: {self.shown!r}")
            if select.select([self.terminal], [], [], 0.05)[0]:
                self.shown += os.read(self.terminal, 65536)

    def offered(self, line):
        self.offers.write_text("", encoding="utf-8")
        self.type(line + "\t")
        self.wait(lambda: "end:" in self.offers.read_text(encoding="utf-8"))
        lines = self.offers.read_text(encoding="utf-8").splitlines()
        return [offer[len("offer:"):] for offer in lines if offer.startswith("offer:") and offer != "offer:"]


def as_whole_words(line, offered):
    """Shells differ in what they call an offer: zsh leaves out what stands before a comma, and the slash of folders."""
    last = words_of(line)[-1].split("=")[-1]
    before = last[: last.rfind(",") + 1]
    result = set()
    for offer in offered:
        offer = offer.replace("\\ ", " ").rstrip("=").rstrip("/")
        offer += "/" if os.path.isdir(offer) else ""
        result.add(offer if offer.startswith(before) else before + offer)
    return {offer for offer in result if offer.startswith(last)}


def check_every_flag(offered, program):
    """Of each verb every flag is offered."""
    described = json.loads(output_of(program, "describe", "--json"))
    for verb in described["verbs"]:
        flags = [flag["name"] for group in verb["groups"] for flag in group["flags"]]
        flags += [flag["name"] for flag in described["every_verb"]]
        line = f"planish {verb['name']} --"
        missing = set(flags) - as_whole_words(line, offered(line))
        expect(not missing, f"{line!r} lacks {sorted(missing)}")


def main():
    program = program_from_arguments(__doc__)
    shell = sys.argv[2]
    skip_without(shell)
    folder = own_folder()
    for name in FILES:
        pathlib.Path(name).touch()
    pathlib.Path("a folder").mkdir()
    script = pathlib.Path(folder.name, f".script.{shell}")
    script.write_text(output_of(program, "completion", shell), encoding="utf-8")
    output_of(shell, "-n", script)
    if shell == "zsh":
        offered = Zsh(script).offered
    else:
        ask = offered_by_bash if shell == "bash" else offered_by_fish
        offered = lambda line: ask(script, line)
    for line, expected in (ALL | (BASH_ALONE if shell == "bash" else {})).items():
        found = as_whole_words(line, offered(line))
        found -= {"offers", "setup.zsh"}
        expect(found == expected, f"{shell} offers {sorted(found)} behind {line!r} and not {sorted(expected)}")
    check_every_flag(offered, program)


if __name__ == "__main__":
    main()
