"""Meshes that are extruded from outlines."""

import math

from sdf_writer import write_extrusion

from .dimensions import AXLE_Y, AXLE_Z, FLIPPER, WHEEL


def hull_of_circles(circles, steps=16):
    """Convex hull, counter-clockwise, of points on circles (y, z, radius)."""
    points = sorted({(round(y + r * math.cos(a), 4), round(z + r * math.sin(a), 4))
                     for y, z, r in circles
                     for a in (2 * math.pi * i / steps for i in range(steps))})
    halves = []
    for ordered in (points, points[::-1]):
        half = []
        for p in ordered:
            while len(half) > 1 and ((half[-1][0] - half[-2][0]) * (p[1] - half[-2][1]) -
                                     (half[-1][1] - half[-2][1]) * (p[0] - half[-2][0])) <= 0:
                half.pop()
            half.append(p)
        halves += half[:-1]
    return halves


def write_meshes(meshes):
    """Writes hull, track and flipper into the folder `meshes`."""
    hull = [(-0.38, 0.10), (0.30, 0.10), (0.455, 0.22), (0.46, 0.30), (0.30, 0.45), (-0.42, 0.45),
            (-0.46, 0.40), (-0.46, 0.18)]
    write_extrusion(meshes / "hull.obj", hull, 0.47)
    track = hull_of_circles([(s * AXLE_Y, AXLE_Z, 0.10) for s in (-1, 1)] +
                            [(s * 0.22, 0.10, 0.10) for s in (-1, 1)])
    write_extrusion(meshes / "track.obj", track, 0.10)
    arm = hull_of_circles([(0, 0, 0.085), (FLIPPER, 0, WHEEL)])
    write_extrusion(meshes / "flipper.obj", arm, 0.07)
