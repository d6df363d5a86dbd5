"""Numbers and tables as Markdown."""


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
