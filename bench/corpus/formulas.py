"""Surfaces by formula over a plane domain, with random parameters: (u, v) in [0, 1]^2 -> (x, y, z) in mm.

Each family draws its parameters from a generator and returns a function of two arrays. The families go from
developable (scroll, cone) over mildly curved (hull, waves, dome) to what no sheet can be (saddle of high order, torus).
"""

import numpy as np


def stack(x, y, z):
    return np.stack(np.broadcast_arrays(x, y, z), axis=-1)


def dome(rng):
    """A cap of a sphere."""
    radius, angle = rng.uniform(60, 300), np.radians(rng.uniform(20, 110))

    def surface(u, v):
        a, b = angle * (u - 0.5), angle * (v - 0.5)
        return radius * stack(np.sin(a), np.sin(b) * np.cos(a), np.cos(b) * np.cos(a))

    return surface


def saddle(rng):
    """Two, three or four times up and down around the middle."""
    size, lift, order = rng.uniform(80, 400), rng.uniform(0.1, 0.7), rng.integers(2, 5)

    def surface(u, v):
        w = (2.0 * u - 1.0) + 1j * (2.0 * v - 1.0)
        return size * stack(w.real, w.imag, lift * (w**order).real / np.sqrt(2.0) ** order)

    return surface


def waves(rng):
    """A few waves across a plate."""
    width, height = rng.uniform(100, 600, 2)
    count = rng.integers(1, 4)
    turn, phase = rng.uniform(0, 2 * np.pi, (2, count))
    number, lift = rng.uniform(0.5, 2.5, count), rng.uniform(0.01, 0.06, count) * min(width, height)

    def surface(u, v):
        z = sum(h * np.sin(2 * np.pi * n * (np.cos(t) * u + np.sin(t) * v) + p)
                for h, n, t, p in zip(lift, number, turn, phase))
        return stack(width * u, height * v, z)

    return surface


def hull(rng):
    """The side of a hull: sections between keel and sheer, narrower towards stem and transom."""
    length, beam, depth = rng.uniform(2000, 9000), rng.uniform(400, 1500), rng.uniform(400, 1400)
    fullness, flare = rng.uniform(1.8, 3.5), rng.uniform(0.5, 1.6)
    rake, sheer, transom = rng.uniform(0.0, 0.25), rng.uniform(0.0, 0.15), rng.uniform(0.0, 0.7)

    def surface(u, v):
        width = beam * (1.0 - (1.0 - transom * (u < 0.5)) * np.abs(2.0 * u - 1.0) ** fullness)
        height = depth * (v + sheer * (2.0 * u - 1.0) ** 2 * v)
        return stack(length * (u + rake * v * u), (0.02 * beam + width) * (0.1 + 0.9 * v**flare), height)

    return surface


def torus(rng):
    """A piece of a ring, of its outer or inner side."""
    large, small = rng.uniform(120, 300), rng.uniform(30, 110)
    along, around = np.radians(rng.uniform(40, 200)), np.radians(rng.uniform(40, 160))
    start = np.pi if rng.random() < 0.5 else 0.0

    def surface(u, v):
        a, b = along * (u - 0.5), start + around * (v - 0.5)
        r = large + small * np.cos(b)
        return stack(r * np.cos(a), r * np.sin(a), small * np.sin(b))

    return surface


def scroll(rng):
    """A sheet rolled up: a spiral of up to two turns, which is developable."""
    radius, growth, turns = rng.uniform(20, 60), rng.uniform(4, 15), rng.uniform(0.5, 2.0)
    width, slant = rng.uniform(60, 300), rng.uniform(-0.5, 0.5)

    def surface(u, v):
        a = 2 * np.pi * turns * u
        r = radius + growth * a
        return stack(r * np.cos(a), r * np.sin(a), width * (v + slant * u))

    return surface


def cone(rng):
    """A sector of a cone, to nearly all around."""
    angle, slope = np.radians(rng.uniform(40, 320)), rng.uniform(0.2, 3.0)
    low, high = rng.uniform(30, 120), rng.uniform(150, 400)

    def surface(u, v):
        a, r = angle * u, low + (high - low) * v
        return stack(r * np.cos(a), r * np.sin(a), slope * r)

    return surface


def twisted(rng):
    """A ruled strip whose ends are turned against each other."""
    length, width, twist = rng.uniform(200, 900), rng.uniform(40, 200), np.radians(rng.uniform(10, 180))

    def surface(u, v):
        a, r = twist * u, width * (v - 0.5)
        return stack(length * u, r * np.cos(a), r * np.sin(a))

    return surface


def ruffle(rng):
    """A collar with more and more waves towards its outer edge, whose pattern may have to overlap itself."""
    inner, width = rng.uniform(60, 150), rng.uniform(40, 160)
    angle, number, lift = np.radians(rng.uniform(60, 300)), rng.integers(2, 7), rng.uniform(0.05, 0.35)

    def surface(u, v):
        a, r = angle * u, inner + width * v
        return stack(r * np.cos(a), r * np.sin(a), lift * width * v * v * np.sin(number * a))

    return surface


FAMILIES = {family.__name__: family
            for family in (dome, saddle, waves, hull, torus, scroll, cone, twisted, ruffle)}
