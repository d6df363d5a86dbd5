#!/usr/bin/env python3
"""Sets the pages of `planish man` with groff and man, which warn of every fault, and reads what they print.

manual.py PLANISH
"""

import json
import os
import pathlib
import re
import subprocess

from support import expect, output_of, own_folder, program_from_arguments, skip_without


def warnings_of(*command):
    environment = os.environ | {"LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "80"}
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment)
    expect(done.returncode == 0, f"{command} ends with {done.returncode}: {done.stderr}")
    return done.stderr


def text_of(page):
    """As it is read: without formatting, line ends and hyphens at them."""
    environment = os.environ | {"LC_ALL": "C.UTF-8"}
    text = output_of("groff", "-man", "-Tutf8", "-rLL=1000n", "-P-cbou", page, env=environment)
    return re.sub(r"\s+", " ", text)


def check(page, phrases):
    for command in (
        ("groff", "-man", "-ww", "-Tutf8", "-z", page),
        ("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page),
    ):
        warnings = warnings_of(*command)
        expect(not warnings, f"{page}: {warnings}")
    text = text_of(page)
    for phrase in phrases:
        expect(re.sub(r"\s+", " ", phrase) in text, f"{page} lacks {phrase!r}")


def main():
    program = program_from_arguments(__doc__)
    skip_without("groff", "man")
    _folder = own_folder()
    described = json.loads(output_of(program, "describe", "--json"))
    verbs = [verb["name"] for verb in described["verbs"]]
    page = pathlib.Path("planish.1")
    page.write_text(output_of(program, "man"), encoding="utf-8")
    check(page, [verb["summary"] for verb in described["verbs"]] + [f"planish-{verb}(1)" for verb in verbs])
    for verb in described["verbs"]:
        page = pathlib.Path(f"planish-{verb['name']}.1")
        page.write_text(output_of(program, "man", verb["name"]), encoding="utf-8")
        flags = [flag for group in verb["groups"] for flag in group["flags"]] + described["every_verb"]
        phrases = [verb["summary"], verb["description"], *verb["examples"]]
        for flag in flags:
            value = flag["placeholder"] or ""
            value = f"[={value}]" if flag["value_optional"] else f" {value}"
            phrases += [f"{flag['name']}{value}".strip(), flag["help"]]
        check(page, phrases)


if __name__ == "__main__":
    main()
