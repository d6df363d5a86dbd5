"""Numbers, tables and pages as Markdown."""

import textwrap

WIDTH = 120


def number(value, digits=3):
    """To so many digits that count; tiny ones as powers of ten."""
    if 0.0 < abs(value) < 1e-4:
        return f"{value:.1e}"
    return f"{float(f'{value:.{digits}g}'):.10g}"


def percent(share, digits=3):
    return f"{number(100.0 * share, digits)} %"


def change(before, after, digits=3):
    return f"{number(before, digits)} → {number(after, digits)}"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def picture(file, says):
    return f"![{says}]({file})\n"


def listed(names):
    """a, b and c"""
    names = list(names)
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def wrapped(page):
    """The page with its paragraphs and items in lines of at most WIDTH characters."""
    return "\n\n".join(_wrapped_block(block) for block in page.split("\n\n"))


def _wrapped_block(block):
    lines = block.split("\n")
    if max(map(len, lines)) <= WIDTH or lines[0].startswith(("|", "!", "#", "<", "    ")):
        return block
    items = lines[:1]
    for line in lines[1:]:
        if line.startswith("* "):
            items.append(line)
        else:
            items[-1] += " " + line.strip()
    return "\n".join(_wrapped_item(item) for item in items)


def _wrapped_item(item):
    indent = "  " if item.startswith("* ") else ""
    return textwrap.fill(item, WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
