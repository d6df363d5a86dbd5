#!/usr/bin/env python3
"""Prints a header as Doxygen should read it: every member with the comment that is for it.

- Options of methods have their words in describe(), for command line and docs: members get them.
- Doxygen gives the comment of `double a, b;` to one of the two: each gets it.
- What every enumeration and every method has is described below.
- Friends, comparisons by default and moves are left out.

Lines keep their numbers. Doxygen calls this for each header (INPUT_FILTER in docs/Doxyfile)."""

import re
import sys

# What all methods say of themselves.
OF_METHODS = {
    "name": "on the command line and in reports",
    "usual_sweeps": "sweeps where no number is given",
    "honours_weights": "takes Constraints::weights",
    "honours_obstacle": "takes Constraints::obstacle",
}

# What stands before a line, if there is no comment.
BEFORE = [
    (r"template <class Visit>$", "Describes the options: see Method."),
    (r"constexpr const auto& names_of\(", "All values with their names, as on the command line."),
    (r"inline constexpr std::array k_\w+ = \{", "All values with their names, as on the command line."),
]

LEFT_OUT = re.compile(r"\s+friend |\s+bool operator==.* = default;|\s+(\w+& operator=|\w+)\(\w+&&\) noexcept;")

KIND = r"(?:static |inline |constexpr )*[\w:<>]+(?:<[^;=]*>)?"
DECLARATION = re.compile(rf"^(\s*)({KIND}) (\w+(?:[,;]| = )[^;]*;)(?:\s*///< (.*))?$")


def words_of_options(text):
    """(struct, member) -> what describe() says of it."""
    words = {}
    for struct, body in re.findall(r"void describe\((\w+)& o, .*?\{\n(.*?)\n\}", text, re.DOTALL):
        for member, strings in re.findall(r'visit\(\s*"\w+",\s*o\.(\w+),\s*((?:"[^"]*"\s*)+)', body):
            words[struct, member] = "".join(re.findall(r'"([^"]*)"', strings))
    return words


def declarators(text):
    """`a = 0.0, b = {}` as its parts."""
    return re.split(r", (?=\w+(?: = |,|$))", text)


def documented(line, before, struct, options):
    """A line that declares members, with a comment for each of them. `before`: the comment above."""
    match = DECLARATION.match(line)
    if not match:
        return line
    indent, kind, names, after = match.groups()
    parts = declarators(names.removesuffix(";"))
    result = []
    for place, part in enumerate(parts):
        name = part.split(" ", 1)[0].split("=")[0]
        words = after or before or options.get((struct, name))
        if words is None and kind.startswith("static constexpr"):
            words = OF_METHODS.get(name)
        needs_none = words is None or (before and place == 0)
        result.append(f"{kind} {part};" + ("" if needs_none else f" /**< {words} */"))
    return indent + " ".join(result)


def main():
    text = open(sys.argv[1], encoding="utf-8").read()
    options = words_of_options(text)
    struct, comment = None, []
    for line in text.splitlines():
        opened = re.match(r"struct (\w+) \{", line)
        struct = opened[1] if opened else None if line == "};" else struct
        is_comment = re.match(r"\s*/// (.*)", line)
        if LEFT_OUT.match(line):
            line = ""
        elif is_comment:
            line = line.replace("\\", "\\\\")
        elif not re.match(r"\s*(using|return) ", line):
            line = documented(line, " ".join(comment), struct, options)
        if not comment:
            words = next((words for pattern, words in BEFORE if re.match(pattern, line)), None)
            line = f"/** {words} */ {line}" if words else line
        print(line)
        comment = comment + [is_comment[1]] if is_comment else []


if __name__ == "__main__":
    main()
