"""Developable surfaces as rulings: straight lines of which any two neighbours lie in one plane.

A developable is a function of the number of rulings. It returns a point on each and its unit
direction. Neighbours are coplanar exactly, not only in the limit: rulings of a cylinder are
parallel, those of a cone meet in the apex, and those of a tangent surface are the edges of a
polygon, so that neighbours meet in a corner. A mesh whose edges follow the rulings therefore has no
angle defect but that of rounding.
"""

import numpy as np

FINE = 4001  # samples by which a curve's length is known


def norms(vectors):
    return np.sqrt(np.sum(vectors * vectors, axis=-1))


def evenly(curve, count):
    """Points of a curve over [0, 1], at equal distances along it."""
    t = np.linspace(0.0, 1.0, FINE)
    steps = norms(np.diff(curve(t), axis=0))
    length = np.concatenate([[0.0], np.cumsum(steps)])
    return curve(np.interp(np.linspace(0.0, length[-1], count), length, t))


def cylinder(profile):
    """@param profile a plane curve, t -> (x, z); rulings run along y"""

    def rulings(count):
        x, z = evenly(lambda t: np.stack(profile(t), axis=1), count).T
        points = np.stack([x, np.zeros(count), z], axis=1)
        return points, np.tile([0.0, 1.0, 0.0], (count, 1))

    return rulings


def cone(directrix):
    """@param directrix t -> (x, y, z), seen from the apex at the origin; rulings at equal angles"""

    def rulings(count):
        def on_sphere(t):
            points = np.stack(directrix(t), axis=1)
            return points / norms(points)[:, None]

        directions = evenly(on_sphere, count)
        return np.zeros((count, 3)), directions / norms(directions)[:, None]

    return rulings


def tangents(curve):
    """@param curve t -> (x, y, z); a ruling starts in the middle of each edge of a polygon on it"""

    def rulings(count):
        corners = evenly(lambda t: np.stack(curve(t), axis=1), count + 1)
        edges = np.diff(corners, axis=0)
        return 0.5 * (corners[1:] + corners[:-1]), edges / norms(edges)[:, None]

    return rulings


# Plane curves for cylinders. Lengths are in millimetres.


def line(length):
    return lambda t: (length * t, np.zeros_like(t))


def arc(degrees, radius):
    angle = np.radians(degrees)
    return lambda t: (radius * np.sin(angle * (t - 0.5)), radius * np.cos(angle * (t - 0.5)))


def ellipse(degrees, width, height):
    angle = np.radians(degrees)
    return lambda t: (width * np.sin(angle * (t - 0.5)), height * np.cos(angle * (t - 0.5)))


def parabola(width, height):
    return lambda t: (width * (t - 0.5), height * (1.0 - (2.0 * t - 1.0) ** 2))


def catenary(width, sag):
    """z = sag cosh(x / sag)"""
    return lambda t: (width * (t - 0.5), sag * np.cosh(width * (t - 0.5) / sag))


def wave(width, height, waves):
    return lambda t: (width * t, height * np.sin(2.0 * np.pi * waves * t))


def clothoid(length, turn):
    """Its curvature grows evenly from 0; turn is that of its tangent, in degrees."""
    s = np.linspace(0.0, 1.0, FINE)
    angle = np.radians(turn) * s * s
    steps = [0.5 * (f(angle[1:]) + f(angle[:-1])) * length / (FINE - 1) for f in (np.cos, np.sin)]
    x, z = (np.concatenate([[0.0], np.cumsum(step)]) for step in steps)
    return lambda t: (np.interp(t, s, x), np.interp(t, s, z))


def bend(flange, degrees, radius):
    """A plate that is bent once: straight, an arc, straight."""
    half, whole = np.radians(0.5 * degrees), 2.0 * flange + np.radians(degrees) * radius

    def profile(t):
        s = whole * (t - 0.5)
        angle = np.clip(s / radius, -half, half)
        rest = s - angle * radius
        x = radius * np.sin(angle) + rest * np.cos(angle)
        return x, radius * np.cos(angle) - rest * np.sin(angle)

    return profile


# Curves that a cone passes through.


def circle(degrees, radius, height, squeeze=1.0):
    """@param squeeze of y: below 1, an ellipse"""
    angle = np.radians(degrees)

    def directrix(t):
        turn = angle * (t - 0.5)
        return radius * np.sin(turn), squeeze * radius * np.cos(turn), np.full_like(t, height)

    return directrix


def crown(degrees, radius, height, lift, waves):
    """A circle that goes up and down."""
    angle = np.radians(degrees)

    def directrix(t):
        turn = angle * (t - 0.5)
        z = height + lift * np.sin(2.0 * np.pi * waves * t)
        return radius * np.sin(turn), radius * np.cos(turn), z

    return directrix


# Curves in space for tangent surfaces.


def helix(degrees, radius, climb):
    """@param climb for each radian"""
    angle = np.radians(degrees)
    return lambda t: (radius * np.cos(angle * t), radius * np.sin(angle * t), climb * angle * t)


def spiral(degrees, radius, grown, climb):
    """A helix on a cone: its radius grows by the factor grown."""
    angle = np.radians(degrees)

    def curve(t):
        size = radius * (1.0 + (grown - 1.0) * t)
        return size * np.cos(angle * t), size * np.sin(angle * t), climb * angle * t

    return curve


def twisted_cubic(width, depth, height):
    return lambda t: (width * t, depth * t * t, height * t**3)
