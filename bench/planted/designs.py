"""The thirty planted surfaces, and the densities of their meshes."""

import numpy as np

import developables as d
from planted import Bump, Planted

DENSITIES = {"coarse": 600, "medium": 2500, "fine": 10_000}  # vertices, about


# Outlines: a -> first and last place on each ruling, in mm.


def band(low, high):
    return lambda a: (np.full_like(a, low), np.full_like(a, high))


def taper(low, first, last):
    """A band whose width goes from first to last."""
    return lambda a: (np.full_like(a, low), low + first + (last - first) * a)


def oval(low, high, end=0.25):
    """Round; the rulings at both ends keep a share of the longest, as triangles would be needles there."""
    middle, half = 0.5 * (low + high), 0.5 * (high - low)

    def outline(a):
        x = (2.0 * a - 1.0) * np.sqrt(1.0 - end * end)
        width = half * np.sqrt(1.0 - x * x)
        return middle - width, middle + width

    return outline


def lens(low, high, end=0.3):
    """As oval, of two parabolas."""
    middle, half = 0.5 * (low + high), 0.5 * (high - low)

    def outline(a):
        width = half * (1.0 - (1.0 - end) * (2.0 * a - 1.0) ** 2)
        return middle - width, middle + width

    return outline


def wavy(low, high, height, waves):
    return lambda a: (low + height * np.sin(2.0 * np.pi * waves * a), high + height * np.cos(2.0 * np.pi * waves * a))


def slanted(low, high, shift):
    """A parallelogram."""
    return lambda a: (low + shift * a, high + shift * a)


def cylinders():
    return [
        Planted("cylinder_eighth", "arc of 45°, a wide low dome", d.cylinder(d.arc(45, 250)),
                band(0, 200), (Bump(0.5, 0.5, 0.48, 0.48, 0.04),)),
        Planted("cylinder_quarter", "arc of 90°, long, a dome at one end", d.cylinder(d.arc(90, 100)),
                band(0, 400), (Bump(0.5, 0.3, 0.4, 0.25, 0.06),)),
        Planted("cylinder_half", "arc of 180°, a high dome", d.cylinder(d.arc(180, 80)),
                band(0, 200), (Bump(0.45, 0.5, 0.35, 0.4, 0.08),)),
        Planted("cylinder_tube", "arc of 270°, a dome and a dent", d.cylinder(d.arc(270, 60)),
                band(0, 180), (Bump(0.28, 0.4, 0.24, 0.35, 0.05), Bump(0.72, 0.6, 0.24, 0.35, -0.05))),
        Planted("cylinder_dents", "arc of 90°, five small bumps and dents", d.cylinder(d.arc(90, 150)),
                band(0, 240), (Bump(0.2, 0.25, 0.17, 0.17, 0.025), Bump(0.75, 0.2, 0.17, 0.17, -0.025),
                               Bump(0.5, 0.5, 0.17, 0.17, 0.025), Bump(0.25, 0.75, 0.17, 0.17, -0.025),
                               Bump(0.8, 0.78, 0.17, 0.17, 0.025))),
        Planted("cylinder_ripples", "arc of 90°, ripples across the rulings", d.cylinder(d.arc(90, 150)),
                band(0, 240), (Bump(0.5, 0.5, 0.45, 0.45, 0.015, waves=1.5),)),
        Planted("ellipse_taper", "half an ellipse, tapered, a wide dent", d.cylinder(d.ellipse(160, 120, 70)),
                taper(0, 220, 120), (Bump(0.45, 0.5, 0.4, 0.4, -0.05),)),
        Planted("parabola_lens", "parabola, lens-shaped, a turned ridge", d.cylinder(d.parabola(240, 50)),
                lens(0, 200), (Bump(0.5, 0.5, 0.42, 0.2, 0.04, turn=35),)),
        Planted("catenary_oval", "catenary, round, a dome", d.cylinder(d.catenary(220, 120)),
                oval(0, 220), (Bump(0.5, 0.5, 0.4, 0.4, 0.05),)),
        Planted("wave_pair", "one wave, a dome on the crest and a dent in the trough", d.cylinder(d.wave(300, 30, 1)),
                band(0, 180), (Bump(0.27, 0.5, 0.22, 0.4, 0.04), Bump(0.73, 0.5, 0.22, 0.4, -0.04))),
        Planted("clothoid_slant", "clothoid turning by 120°, slanted, a dome", d.cylinder(d.clothoid(300, 120)),
                slanted(0, 200, 80), (Bump(0.6, 0.5, 0.35, 0.4, 0.05),)),
        Planted("bent_plate", "plate bent once by 80°, a dome over the bend", d.cylinder(d.bend(90, 80, 60)),
                band(0, 220), (Bump(0.5, 0.5, 0.4, 0.35, 0.05),)),
    ]


def cones():
    return [
        Planted("cone_sector", "arc of 60°, a dome", d.cone(d.circle(60, 100, 100)),
                band(150, 350), (Bump(0.5, 0.5, 0.45, 0.45, 0.05),)),
        Planted("cone_half", "arc of 180°, a dome off the middle", d.cone(d.circle(180, 100, 120)),
                band(100, 300), (Bump(0.6, 0.55, 0.35, 0.4, 0.06),)),
        Planted("cone_lampshade", "arc of 250°, three bumps", d.cone(d.circle(250, 100, 180)),
                band(180, 360), (Bump(0.2, 0.5, 0.17, 0.35, 0.03), Bump(0.5, 0.5, 0.17, 0.35, -0.03),
                                 Bump(0.8, 0.5, 0.17, 0.35, 0.03))),
        Planted("cone_tip", "arc of 120°, close to the apex, a dome", d.cone(d.circle(120, 100, 60)),
                band(60, 280), (Bump(0.5, 0.6, 0.4, 0.35, 0.05),)),
        Planted("cone_oval", "arc of 100°, round, a dent", d.cone(d.circle(100, 100, 90)),
                oval(120, 320), (Bump(0.5, 0.5, 0.38, 0.38, -0.05),)),
        Planted("cone_strip", "arc of 200°, narrow, a long ridge along the strip", d.cone(d.circle(200, 100, 50)),
                band(220, 300), (Bump(0.5, 0.5, 0.45, 0.45, 0.03),)),
        Planted("cone_ellipse", "half an elliptic cone, tapered, a dome and a dent",
                d.cone(d.circle(170, 120, 120, 0.6)),
                taper(120, 160, 220), (Bump(0.3, 0.5, 0.25, 0.4, 0.04), Bump(0.75, 0.5, 0.22, 0.4, -0.04))),
        Planted("cone_crown", "wavy cone, a turned ridge", d.cone(d.crown(140, 100, 80, 20, 1.5)),
                band(120, 300), (Bump(0.5, 0.5, 0.4, 0.2, 0.03, turn=-40),)),
        Planted("cone_wavy_hem", "arc of 90°, wavy outline, a dome", d.cone(d.circle(90, 100, 150)),
                wavy(200, 400, 15, 2), (Bump(0.45, 0.5, 0.4, 0.42, 0.05),)),
    ]


def tangent_surfaces():
    return [
        Planted("helix_flat", "helix of low climb, a dome", d.tangents(d.helix(90, 100, 40)),
                band(60, 220), (Bump(0.5, 0.5, 0.42, 0.42, 0.05),)),
        Planted("helix_steep", "steep helix, a dome at one side", d.tangents(d.helix(120, 60, 80)),
                band(80, 260), (Bump(0.4, 0.55, 0.35, 0.38, 0.05),)),
        Planted("helix_oval", "helix, round, a dent", d.tangents(d.helix(100, 90, 60)),
                oval(70, 260), (Bump(0.5, 0.5, 0.4, 0.4, -0.05),)),
        Planted("helix_ripples", "helix, ripples", d.tangents(d.helix(80, 120, 60)),
                band(100, 280), (Bump(0.5, 0.5, 0.45, 0.45, 0.012, waves=1.5),)),
        Planted("spiral_taper", "helix on a cone, tapered, two domes", d.tangents(d.spiral(110, 70, 1.8, 50)),
                taper(80, 140, 220), (Bump(0.28, 0.5, 0.24, 0.4, 0.04), Bump(0.72, 0.5, 0.24, 0.4, 0.04))),
        Planted("cubic_band", "twisted cubic, a dome", d.tangents(d.twisted_cubic(200, 120, 60)),
                band(80, 260), (Bump(0.5, 0.5, 0.42, 0.42, 0.05),)),
    ]


def planes():
    return [
        Planted("plane_disc", "round, a dome", d.cylinder(d.line(200)),
                oval(0, 200), (Bump(0.5, 0.5, 0.42, 0.42, 0.06),)),
        Planted("plane_bumps", "rectangle, two domes and two dents", d.cylinder(d.line(300)),
                band(0, 200), (Bump(0.27, 0.28, 0.2, 0.25, 0.04), Bump(0.73, 0.28, 0.2, 0.25, -0.04),
                               Bump(0.27, 0.72, 0.2, 0.25, -0.04), Bump(0.73, 0.72, 0.2, 0.25, 0.04))),
        Planted("plane_fan", "sector of 70°, a turned ridge", d.cone(d.circle(70, 100, 0)),
                band(100, 300), (Bump(0.5, 0.5, 0.42, 0.25, 0.05, turn=30),)),
    ]


def designs():
    return [*cylinders(), *cones(), *tangent_surfaces(), *planes()]
