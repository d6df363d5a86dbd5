#!/usr/bin/env python3
"""Writes the tables of docs/notebook/comparison.md, between its marks, from comparison.csv beside it."""

import csv
import math
import pathlib
import statistics

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs/notebook"
BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"
LARGE = 20_000


def number(row, column):
    return float(row[column]) if row[column] else math.nan


def read(path):
    """patch -> method -> row"""
    table = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            table.setdefault(row["patch"], {})[row["method"]] = row
    return table


def line(cells):
    return "| " + " | ".join(cells) + " |"


def median(values):
    values = [v for v in values if not math.isnan(v)]
    return statistics.median(values) if values else math.nan


def method_table(patches, methods):
    """How each method did over some patches."""
    out = [
        line(["method", "ran", "e_max < 1e-3", "strain under 0.1 %", "strain halved",
              "strain lower", "strain ratio", "deviation", "needles", "rougher by half",
              "seconds per 10 k vertices"]),
        line(["---"] * 11),
    ]  # fmt: skip
    for method in methods:
        pairs = [(p["input"], p[method]) for p in patches if p.get(method, {}).get("e_max")]
        ratio = [number(r, "strain_rms") / number(i, "strain_rms") for i, r in pairs
                 if number(i, "strain_rms") > 1e-9]  # fmt: skip
        needles = sum(
            number(r, "min_angle") < min(0.5 * number(i, "min_angle"), math.radians(1))
            for i, r in pairs
        )
        rougher = sum(number(r, "roughness") > 1.5 * number(i, "roughness") for i, r in pairs)
        pace = median([1e4 * number(r, "seconds") / int(r["vertices"]) for _, r in pairs])
        out.append(line([
            f"`{method}`",
            f"{len(pairs)}",
            str(sum(number(r, "e_max") < 1e-3 for _, r in pairs)),
            str(sum(number(r, "strain_rms") < 1e-3 for _, r in pairs)),
            str(sum(q < 0.5 for q in ratio)),
            str(sum(q < 0.99 for q in ratio)),
            f"{median(ratio):.2g}",
            f"{100 * median([number(r, 'rms_deviation_over_diagonal') for _, r in pairs]):.2g} %",
            str(needles),
            str(rougher),
            f"{pace:.2g}",
        ]))  # fmt: skip
    return out


def patch_table(table, methods):
    """Strain of the pattern, rms in percent, of every patch under every method."""
    out = [line(["patch", "vertices", "input", *methods]), line(["---"] * (len(methods) + 3))]
    for name, rows in table.items():
        cells = [name, rows["input"]["vertices"]]
        for method in ["input", *methods]:
            strain = number(rows.get(method, {"strain_rms": ""}), "strain_rms")
            cells.append("–" if math.isnan(strain) else f"{100 * strain:.2g}")
        out.append(line(cells))
    return out


def tables(path):
    """The tables of the rows in a file of comma-separated values, as Markdown."""
    table = read(path)
    methods = list(dict.fromkeys(m for rows in table.values() for m in rows if m != "input"))
    small = [rows for rows in table.values() if int(rows["input"]["vertices"]) <= LARGE]
    large = [rows for rows in table.values() if int(rows["input"]["vertices"]) > LARGE]
    lines = [f"**{len(small)} patches of up to {LARGE:,} vertices**", ""]
    lines += method_table(small, methods)
    sweeps = "ten sweeps of every method but auto" if "auto" in methods else "ten sweeps each"
    lines += ["", f"**{len(large)} larger patches, {sweeps}**", ""]
    lines += method_table(large, methods)
    lines += ["", "**Strain of the pattern, rms in percent**", "", *patch_table(table, methods)]
    return "\n".join(lines)


def main():
    page = (DOCS / "comparison.md").read_text(encoding="utf-8")
    head, tail = page.split(BEGIN)[0], page.split(END)[1]
    page = head + BEGIN + "\n" + tables(DOCS / "comparison.csv") + "\n" + END + tail
    (DOCS / "comparison.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
