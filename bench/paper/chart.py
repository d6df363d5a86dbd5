"""Charts as SVG: panels side by side, each with curves or points over two axes."""

import dataclasses
import math
from html import escape

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 460, 340, 64, 16, 66, 46
COLORS = ["#c05000", "#0068a0", "#222222", "#6a3d9a"]
DASHES = ["", "7 4", "2 3", "9 3 2 3"]


@dataclasses.dataclass(frozen=True)
class Series:
    name: str
    xs: list
    ys: list
    is_curve: bool = True


@dataclasses.dataclass(frozen=True)
class Axis:
    label: str
    is_log: bool = False

    def place(self, value):
        return math.log10(value) if self.is_log else value

    def ticks(self, low, high):
        """Round values between two places."""
        if not self.is_log:
            step = 10.0 ** math.floor(math.log10((high - low) / 2.0))
            step *= next(k for k in (1, 2, 5, 10) if (high - low) / (k * step) <= 6.0)
            return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]
        powers = range(math.floor(low), math.ceil(high) + 1)
        digits = (1, 2, 5) if high - low < 2.5 else (1,)
        powers = powers if high - low < 9.0 else [p for p in powers if p % 2 == 0]
        values = [digit * 10.0**power for power in powers for digit in digits]
        return [v for v in values if low <= math.log10(v) <= high]


@dataclasses.dataclass(frozen=True)
class Panel:
    title: str
    x: Axis
    y: Axis
    series: list


def span(axis, values):
    """Places of the axis' ends, with some air."""
    places = [axis.place(v) for v in values]
    low, high = min(places), max(places)
    air = 0.06 * (high - low) or 0.5
    return (low - air if axis.is_log or low < 0.0 else 0.0), high + air


def drawn_panel(panel, index):
    left, right = index * WIDTH + LEFT, (index + 1) * WIDTH - RIGHT
    x_low, x_high = span(panel.x, [v for s in panel.series for v in s.xs])
    y_low, y_high = span(panel.y, [v for s in panel.series for v in s.ys])
    x = lambda v: left + (right - left) * (panel.x.place(v) - x_low) / (x_high - x_low)
    y = lambda v: TOP + (HEIGHT - TOP - BOTTOM) * (y_high - panel.y.place(v)) / (y_high - y_low)
    floor = HEIGHT - BOTTOM
    yield f'<text x="{left}" y="20" font-size="14" font-weight="bold">{escape(panel.title)}</text>'
    for value in panel.y.ticks(y_low, y_high):
        yield (
            f'<path d="M{left} {y(value):.1f}H{right}" stroke="#ddd"/>'
            f'<text x="{left - 6}" y="{y(value) + 4:.1f}" text-anchor="end">{value:g}</text>'
        )
    for value in panel.x.ticks(x_low, x_high):
        yield (
            f'<path d="M{x(value):.1f} {TOP}V{floor}" stroke="#eee"/>'
            f'<text x="{x(value):.1f}" y="{floor + 16}" text-anchor="middle">{value:g}</text>'
        )
    yield f'<path d="M{left} {TOP}V{floor}H{right}" stroke="#888" fill="none"/>'
    middle = (left + right) / 2
    yield f'<text x="{middle}" y="{HEIGHT - 8}" text-anchor="middle">{escape(panel.x.label)}</text>'
    yield f'<text x="{left - 6}" y="{TOP - 8}" text-anchor="end">{escape(panel.y.label)}</text>'
    place = left
    for series, color, dash in zip(panel.series, COLORS, DASHES):
        if series.is_curve:
            points = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in zip(series.xs, series.ys))
            style = f'fill="none" stroke="{color}" stroke-width="1.8" stroke-dasharray="{dash}"'
            yield f'<polyline points="{points}" {style}/>'
            yield f'<path d="M{place} 38h22" {style}/>'
        else:
            dots = list(zip(map(x, series.xs), map(y, series.ys))) + [(place + 11, 38)]
            yield from (
                f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{color}" fill-opacity="0.75"/>'
                for a, b in dots
            )
        yield f'<text x="{place + 27}" y="42" fill="{color}">{escape(series.name)}</text>'
        place += 48 + 7 * len(series.name)


def write_svg(path, panels):
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH * len(panels)} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        f'<rect width="{WIDTH * len(panels)}" height="{HEIGHT}" fill="#fff"/>',
    ]
    for index, panel in enumerate(panels):
        lines += drawn_panel(panel, index)
    path.write_text("\n".join([*lines, "</svg>"]) + "\n", encoding="utf-8")
