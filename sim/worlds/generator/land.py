"""The land beyond the fences: meshes of hills and forest."""

import math
import random

from sdf_writer import write_obj


def hill_height(radius, angle):
    """Height of the land round the yard: below the grass at 60 m, hills from 120 m on."""
    rise = max(0.0, radius - 110) ** 1.35 * 0.028
    waves = 1 + 0.45 * math.sin(3 * angle + 0.6) + 0.3 * math.sin(7 * angle + 2) + \
        0.12 * math.sin(17 * angle)
    near = -0.6 + 0.6 * min(1.0, (radius - 55) / 25)
    return near + rise * max(0.15, waves)


def write_hills(path):
    radii = [55, 80, 110, 140, 180, 230, 290, 360, 450]
    sides = 72
    corners = []
    for radius in radii:
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            corners.append((radius * math.cos(angle), radius * math.sin(angle),
                            hill_height(radius, angle)))
    faces = []
    for ring in range(len(radii) - 1):
        for i in range(sides):
            a, b = ring * sides + i, ring * sides + (i + 1) % sides
            faces.append([a, a + sides, b + sides, b])
    write_obj(path, corners, faces)


def write_forest(path):
    """Firs on the slopes, five-sided, in clumps; too far off for more."""
    rng = random.Random(7)
    corners, faces = [], []
    while len(faces) < 2600:
        angle, radius = rng.uniform(0, 2 * math.pi), rng.uniform(72, 300)
        if math.sin(4 * angle + radius / 60) + rng.uniform(-0.6, 0.6) < 0.15:
            continue
        height, width = rng.uniform(6, 12), rng.uniform(1.6, 2.8)
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        z = hill_height(radius, angle) - 0.3
        first = len(corners)
        for i in range(5):
            a = 2 * math.pi * i / 5 + angle
            corners.append((x + width * math.cos(a), y + width * math.sin(a), z + 0.08 * height))
        corners.append((x, y, z + height))
        faces += [[first + i, first + (i + 1) % 5, first + 5] for i in range(5)]
    write_obj(path, corners, faces)
