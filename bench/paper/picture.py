"""Pictures of surfaces: seen from the side that shows most, coloured by a value at each vertex,
shaded, several side by side, as PNG."""

import struct
import zlib

import numpy as np

from surface import norm, scattered

# Blue low to red high by way of cyan, green and yellow, as the paper's maps have it, but never so
# dark that the shading could not be seen.
RAINBOW = np.array(
    [[40, 70, 200], [50, 160, 230], [70, 200, 170], [130, 210, 80], [240, 220, 60], [245, 140, 40],
     [215, 30, 35]]
)  # fmt: skip
GREY, RED = np.array([205, 208, 214]), np.array([205, 25, 35])
OVERSAMPLING = 2
HEIGHT, WIDTH = 360, 900  # pixels at most, the gaps between besides


def rainbow(values, highest):
    """Colours of values from 0 to `highest` and above."""
    place = np.clip(np.abs(values) / highest, 0.0, 1.0) * (len(RAINBOW) - 1)
    return np.stack(
        [np.interp(place, np.arange(len(RAINBOW)), RAINBOW[:, k]) for k in range(3)], axis=1
    )


def marked(which):
    """Red where `which` holds, grey elsewhere."""
    return np.where(which[:, None], RED, GREY).astype(float)


def view_of(surface):
    """Rows right, up, towards the eye: looking at the broad side, a little from above and the
    right, the long way upright."""
    x, t = surface.positions, surface.triangles
    _, axes = np.linalg.eigh(np.cov(x.T))
    eye, up = axes[:, 0], axes[:, 2]
    normals = np.cross(x[t[:, 1]] - x[t[:, 0]], x[t[:, 2]] - x[t[:, 0]])
    eye = eye if eye @ normals.sum(axis=0) >= 0.0 else -eye
    up = up if up[np.argmax(np.abs(up))] > 0.0 else -up
    eye = eye + 0.45 * np.cross(up, eye) + 0.25 * up
    eye /= norm(eye)
    up = up - (up @ eye) * eye
    up /= norm(up)
    return np.stack([np.cross(up, eye), up, eye])


def vertex_normals(surface):
    x, t = surface.positions, surface.triangles
    normals = np.cross(x[t[:, 1]] - x[t[:, 0]], x[t[:, 2]] - x[t[:, 0]])
    summed = sum(scattered(len(x), t[:, k], normals) for k in range(3))
    return summed / np.maximum(norm(summed), 1e-300)[:, None]


def fragments(points, triangles, width, height):
    """Pixels of triangles: their numbers, the triangle of each, and the weights of its corners."""
    corner = points[triangles][:, :, :2]
    low = np.maximum(np.ceil(corner.min(axis=1) - 0.5).astype(int), 0)
    high = np.minimum(np.floor(corner.max(axis=1) - 0.5).astype(int), [width - 1, height - 1])
    extent = high - low + 1
    side = np.roll(corner, -2, axis=1) - np.roll(corner, -1, axis=1)  # opposite of each corner
    area = side[:, 0, 0] * side[:, 1, 1] - side[:, 0, 1] * side[:, 1, 0]
    found = []
    # The k-th pixel of all boxes at once: most triangles of a dense patch have few.
    for row in range(extent[:, 1].max()):
        some = np.flatnonzero((extent[:, 1] > row) & (extent[:, 0] > 0) & (area != 0.0))
        column = 0
        while len(some) > 0:
            pixel = low[some] + [column, row]
            to = pixel[:, None] + 0.5 - np.roll(corner[some], -1, axis=1)
            weights = side[some, :, 0] * to[:, :, 1] - side[some, :, 1] * to[:, :, 0]
            weights /= area[some, None]
            inside = np.all(weights >= 0.0, axis=1)
            at = pixel[inside, 1] * width + pixel[inside, 0]
            found.append((at, some[inside], weights[inside]))
            column += 1
            some = some[extent[some, 0] > column]
    return (np.concatenate([part[k] for part in found]) for k in range(3))


def image(surface, colors, view, height):
    """One surface in colours of its vertices on white, `height` pixels high; rows from the top."""
    turned = surface.positions @ view.T
    low, high = turned.min(axis=0), turned.max(axis=0)
    margin = 0.015 * (high[1] - low[1])
    scale = OVERSAMPLING * height / (high[1] - low[1] + 2 * margin)
    width = OVERSAMPLING * int(np.ceil((high[0] - low[0] + 2 * margin) * scale / OVERSAMPLING))
    points = np.stack(
        [
            (turned[:, 0] - low[0] + margin) * scale,
            (high[1] + margin - turned[:, 1]) * scale,
            turned[:, 2],
        ],
        axis=1,
    )
    height *= OVERSAMPLING
    t = surface.triangles
    pixel, triangle, weights = fragments(points, t, width, height)
    depth = np.einsum("ij,ij->i", weights, points[t[triangle], 2])
    order = np.lexsort((depth, pixel))
    front = order[np.append(pixel[order][1:] != pixel[order][:-1], True)]
    at, weights = t[triangle[front]], weights[front][:, :, None]
    normals = np.sum(weights * vertex_normals(surface)[at], axis=1) @ view.T
    # Both sides of a sheet are lit; the light stands over the left shoulder.
    light = np.array([-0.35, 0.45, 0.82])
    lit = np.abs(normals @ light) / np.maximum(norm(normals), 1e-300)
    shade = 0.42 + 0.58 * lit
    canvas = np.full((height * width, 3), 255.0)
    canvas[pixel[front]] = np.minimum(np.sum(weights * colors[at], axis=1) * shade[:, None], 255.0)
    tiles = canvas.reshape(
        height // OVERSAMPLING, OVERSAMPLING, width // OVERSAMPLING, OVERSAMPLING, 3
    )
    return tiles.mean(axis=(1, 3))


def chunk(kind, data):
    check = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)


def write_png(path, pixels):
    """Colours 0 to 255, rows x columns x 3, to 6 bits each: half the size, and nobody sees it."""
    levels = np.clip(np.round(pixels / 255.0 * 63.0), 0, 63)
    sharp = np.round(levels * 255.0 / 63.0).astype(np.uint8)
    rows, columns, _ = sharp.shape
    above = np.vstack([np.zeros((1, columns, 3), np.uint8), sharp[:-1]])
    filtered = np.concatenate(
        [np.full((rows, 1), 2, np.uint8), (sharp - above).reshape(rows, -1)], axis=1
    )
    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head))
        file.write(chunk(b"IDAT", zlib.compress(filtered.tobytes(), 9)) + chunk(b"IEND", b""))


def write_row(path, shown, view):
    """Surfaces side by side, each a pair of surface and colours, all from one view."""
    extents = [np.ptp(surface.positions @ view.T, axis=0) for surface, _ in shown]
    height = int(min(HEIGHT, WIDTH / sum(extent[0] / extent[1] for extent in extents)))
    gap = np.full((height, 24, 3), 255.0)
    parts = []
    for surface, colors in shown:
        parts += [gap, image(surface, colors, view, height)]
    write_png(path, np.concatenate(parts[1:], axis=1))
