#!/usr/bin/env python3
"""The rooms of the library and the includes between them, read from the code.

A room is a folder below src/, with the private headers in it. The public headers of a folder below
include/planish/ are a room too, the face of that layer: faces include faces alone. A layer is a
first folder, as evolve, with its face and all rooms below it.

    tools/rooms.py              prints each room with its floor, its size and what it includes
    tools/rooms.py --draw       draws docs/media/rooms*.svg
    tools/rooms.py --check      ends with 1 where those pictures are not those of the code

"""

import collections
import html
import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent
PICTURES = REPO / "docs/media"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
FACE = "planish/"
WHOLE = REPO / "include/planish/planish.h"  # includes all other public headers


def sources(folder):
    paths = (REPO / folder).rglob("*")
    return sorted(p for p in paths if p.suffix in {".h", ".cpp"})


def includes(path):
    """Yields (line number, "<" or the quote, what is included)."""
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start(2)) + 1, match[1], match[2]


def room_of(path):
    """ "evolve/auto/near" of src/evolve/auto/near/auto.cpp, "planish/evolve" of a public header."""
    if path.is_relative_to(REPO / "include"):
        return path.parent.relative_to(REPO / "include").as_posix()
    return path.parent.relative_to(REPO / "src").as_posix()


def room_of_include(path, mark, name):
    """The room that an include of the library's own reaches into, or None for other headers."""
    if mark == "<":
        return name.rsplit("/", 1)[0] if name.startswith(FACE) else None
    if (path.parent / name).exists():
        return room_of(path.parent / name)
    return name.rsplit("/", 1)[0]


def layer_of(room):
    return room.removeprefix(FACE).split("/")[0]


def graph():
    """Room -> the other rooms that it includes, and room -> its number of files."""
    arrows, sizes = collections.defaultdict(set), collections.Counter()
    for root in ("include/planish", "src"):
        for path in sources(root):
            if path == WHOLE:
                continue
            room = room_of(path)
            sizes[room] += 1
            for _, mark, name in includes(path):
                target = room_of_include(path, mark, name)
                if target is not None and target != room:
                    arrows[room].add(target)
    return {room: arrows[room] for room in sizes}, sizes


def floors(arrows):
    """Room -> 0 where it includes nothing, else one above the highest that it includes.

    Raises ValueError with the rooms of a circle where there is one."""
    height = {}

    def visit(room, path):
        if room in path:
            raise ValueError(" -> ".join([*path[path.index(room) :], room]))
        if room not in height:
            below = [visit(target, [*path, room]) for target in sorted(arrows.get(room, ()))]
            height[room] = 1 + max(below, default=-1)
        return height[room]

    for room in sorted(arrows):
        visit(room, [])
    return height


def reduced(arrows):
    """Without the arrows that a longer way replaces."""

    def reach(room, seen):
        for target in arrows.get(room, ()):
            if target not in seen:
                seen.add(target)
                reach(target, seen)
        return seen

    return {
        room: {
            target
            for target in targets
            if not any(target in reach(other, set()) for other in targets if other != target)
        }
        for room, targets in arrows.items()
    }


# Pictures.

LINE, PAD, GAP, CHAR, STOREY = 15, 9, 28, 6.9, 46


class Box:
    def __init__(self, lines):
        self.lines = lines
        self.width = 2 * PAD + CHAR * max(map(len, lines)) if lines else 0.0
        self.height = 2 * PAD + LINE * len(lines)
        self.x = self.y = 0.0

    def middle(self):
        return self.x + self.width / 2


def routed(arrows, height):
    """The arrows from floor to floor: longer ones go by empty boxes on the floors between."""
    steps = []
    for name, targets in sorted(arrows.items()):
        for target in sorted(targets):
            way = [name, *((name, target, k) for k in range(height[name] - 1, height[target], -1))]
            steps += zip(way, [*way[1:], target])
    return steps


def place(boxes, rows, steps):
    """Each floor from the lowest up, its boxes above what they point to; returns the size."""
    below = collections.defaultdict(list)
    for upper, lower in steps:
        below[upper].append(lower)
    for level in sorted(rows):
        aim = {
            name: sum(boxes[t].middle() for t in below[name]) / max(1, len(below[name]))
            for name in rows[level]
        }
        rows[level].sort(key=lambda name: (aim[name], str(name)))
        x, shift = -float("inf"), 0.0
        for name in rows[level]:
            box = boxes[name]
            box.x = max(x, aim[name] - box.width / 2)
            shift += aim[name] - box.middle()
            x = box.x + box.width + GAP
        for name in rows[level]:
            boxes[name].x += shift / len(rows[level])
    left = min(box.x for box in boxes.values()) - GAP
    y = GAP
    for level in sorted(rows, reverse=True):
        tallest = max(boxes[name].height for name in rows[level])
        for name in rows[level]:
            boxes[name].x -= left
            boxes[name].y = y + (0 if boxes[name].lines else tallest / 2)
        y += tallest + STOREY
    return max(box.x + box.width for box in boxes.values()) + GAP, y - STOREY + GAP


def drawn_arrow(a, b):
    x1, y1 = a.middle(), a.y + (a.height if a.lines else 0)
    x2, y2 = b.middle(), b.y
    bend = (y2 - y1) / 2
    tip = ' marker-end="url(#tip)"' if b.lines else ""
    return (
        f'<path d="M{x1:.0f} {y1:.0f}C{x1:.0f} {y1 + bend:.0f} {x2:.0f} {y2 - bend:.0f} '
        f'{x2:.0f} {y2:.0f}" fill="none" stroke="#99a"{tip}/>'
    )


def drawn_box(box):
    out = [
        f'<rect x="{box.x:.0f}" y="{box.y:.0f}" width="{box.width:.0f}" '
        f'height="{box.height:.0f}" rx="4" fill="#eef3fa" stroke="#557"/>'
    ]
    for k, line in enumerate(box.lines):
        style = 'font-weight="bold"' if k == 0 else 'fill="#445"'
        out.append(
            f'<text x="{box.x + PAD:.0f}" y="{box.y + PAD + 11 + LINE * k:.0f}" {style}>'
            f"{html.escape(line)}</text>"
        )
    return out


def picture(arrows, lines_of):
    height = floors(arrows)
    steps = routed(reduced(arrows), height)
    boxes = {name: Box([name, *lines_of(name)]) for name in arrows}
    rows = collections.defaultdict(list)
    for name in sorted(arrows):
        rows[height[name]].append(name)
    for _, lower in steps:
        if lower not in boxes:
            boxes[lower] = Box([])
            rows[lower[2]].append(lower)
    width, total = place(boxes, rows, steps)
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{total:.0f}" '
        f'viewBox="0 0 {width:.0f} {total:.0f}" font-family="sans-serif" font-size="11">',
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" '
        'markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z" fill="#667"/></marker></defs>',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    out += [drawn_arrow(boxes[upper], boxes[lower]) for upper, lower in steps]
    for name in sorted(arrows):
        out += drawn_box(boxes[name])
    return "\n".join([*out, "</svg>", ""])


def of_layers(arrows):
    """Layer -> the other layers that any of its rooms includes."""
    layers = {layer_of(room): set() for room in arrows}
    for room, targets in arrows.items():
        layers[layer_of(room)] |= {layer_of(t) for t in targets} - {layer_of(room)}
    return layers


def within(arrows, layer):
    """The rooms of a layer, its face included, and the arrows between them."""
    own = {room for room in arrows if layer_of(room) == layer}
    return {room: arrows[room] & own for room in own}


def pictures():
    arrows, _ = graph()
    rooms = collections.defaultdict(list)
    for room in sorted(arrows):
        if "/" in room and not room.startswith(FACE):
            rooms[layer_of(room)].append(room.split("/", 1)[1])
    return {
        "rooms.svg": picture(of_layers(arrows), lambda name: rooms[name]),
        "rooms_of_evolve.svg": picture(within(arrows, "evolve"), lambda _: []),
    }


def main():
    if sys.argv[1:] in (["--draw"], ["--check"]):
        stale = []
        for name, text in pictures().items():
            path = PICTURES / name
            if sys.argv[1] == "--draw":
                path.write_text(text, encoding="utf-8")
            elif not path.exists() or path.read_text(encoding="utf-8") != text:
                stale.append(path)
        for path in stale:
            print(f"{path.relative_to(REPO)} is not that of the code: run tools/rooms.py --draw")
        return 1 if stale else 0
    arrows, sizes = graph()
    height = floors(arrows)
    for room in sorted(arrows, key=lambda room: (height[room], room)):
        print(f"{height[room]:2} {room:18} {sizes[room]:3} {' '.join(sorted(arrows[room]))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
