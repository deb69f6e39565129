"""What stands about in every training area."""

from sdf_writer import box, cone, cylinder, sphere

from .module import part
from .surfaces import (ALONG_X, BARK, BLACK, BLUE, BRICK, BRICK_PALE, CONCRETE, CONCRETE_DARK, GLASS, GREEN,
                       HAZARD, LEAVES, METAL, NEEDLES, ORANGE, ROOF, WHITE, WOOD, WOOD_DARK)


def traffic_cone():
    link = part().solid(box(0.34, 0.34, 0.03), BLACK, (0, 0, 0.015))
    link.solid(cone(0.15, 0.67), ORANGE, (0, 0, 0.365))
    link.visual(cylinder(0.088, 0.09), WHITE, (0, 0, 0.34))
    return link


def crate(size):
    link = part().solid(box(size, size, size), WOOD, (0, 0, size / 2))
    for z in (0.05, size - 0.05):
        link.visual(box(size + 0.03, size + 0.03, 0.07), WOOD_DARK, (0, 0, z))
    for side in (-1, 1):
        link.visual(box(0.07, size + 0.02, size), WOOD_DARK, (side * size * 0.46, 0, size / 2))
    return link


def barrel(surface):
    link = part().solid(cylinder(0.29, 0.88), surface, (0, 0, 0.44))
    for z in (0.03, 0.30, 0.60, 0.86):
        link.visual(cylinder(0.30, 0.03), METAL, (0, 0, z))
    return link


def container():
    """A 20-foot shipping container: 6.06 x 2.44 x 2.59 m, ribbed."""
    link = part().solid(box(6.06, 2.44, 2.59), BLUE, (0, 0, 1.295))
    for i in range(19):
        x = -2.7 + i * 0.30
        link.visual(box(0.12, 2.50, 2.25), BLUE, (x, 0, 1.295))
    for x in (-3.0, 3.0):
        for y in (-1.19, 1.19):
            link.visual(box(0.14, 0.14, 2.62), METAL, (x, y, 1.31))
    for y in (-0.75, -0.25, 0.25, 0.75):
        link.visual(cylinder(0.02, 2.3), METAL, (3.06, y, 1.30))
    return link.visual(box(0.01, 1.2, 0.35), WHITE, (3.04, 0, 2.0))


def building():
    """Training house, 8 x 6 m: four walls with a door and windows, a gable roof."""
    link = part().solid(box(8, 6, 3), BRICK_PALE, (0, 0, 1.5))
    link.visual(box(8.1, 6.1, 0.35), CONCRETE_DARK, (0, 0, 0.175))
    for side in (-1, 1):
        link.visual(box(8.8, 3.75, 0.12), ROOF, (0, side * 1.62, 3.72), (side * -25, 0, 0))
        # The gables: three steps of wall under the roof.
        for step in range(3):
            link.visual(box(0.24, 4.6 - 1.7 * step, 0.45), BRICK_PALE,
                        (side * 3.88, 0, 3.2 + 0.42 * step))
    link.visual(box(0.6, 0.6, 1.5), BRICK, (2.2, 0.9, 4.4))
    for x in (-2.6, 2.6):
        for side in (-1, 1):
            link.visual(box(1.5, 0.06, 1.2), WHITE, (x, side * 3.0, 1.75))
            link.visual(box(1.3, 0.08, 1.0), GLASS, (x, side * 3.0, 1.75))
            link.visual(box(0.06, 0.10, 1.0), WHITE, (x, side * 3.0, 1.75))
    link.visual(box(1.15, 0.06, 2.2), WHITE, (0, -3.0, 1.1))
    link.visual(box(0.95, 0.08, 2.05), GREEN, (0, -3.0, 1.03))
    link.visual(sphere(0.04), METAL, (0.36, -3.06, 1.05))
    for y in (-1.5, 1.5):
        link.visual(box(0.06, 1.4, 1.2), WHITE, (4.0, y, 1.75))
        link.visual(box(0.08, 1.2, 1.0), GLASS, (4.0, y, 1.75))
    link.solid(box(2.0, 1.0, 0.02), CONCRETE, (0, -3.5, 0.01))
    return link


def broadleaf(scale, rng):
    link = part().solid(cylinder(0.16 * scale, 2.2 * scale), BARK, (0, 0, 1.1 * scale))
    for dx, dy, dz, r in ((0, 0, 3.3, 1.35), (0.8, 0.2, 2.8, 0.9), (-0.6, 0.5, 2.9, 0.95),
                          (-0.1, -0.8, 2.7, 0.85)):
        link.visual(sphere(r * scale), LEAVES,
                    (dx * scale, dy * scale, (dz + rng.uniform(-0.1, 0.1)) * scale))
    return link


def conifer(scale):
    link = part().solid(cylinder(0.13 * scale, 1.2 * scale), BARK, (0, 0, 0.6 * scale))
    for z, radius, length in ((1.7, 1.35, 1.9), (2.9, 1.05, 1.8), (4.0, 0.72, 1.6)):
        link.visual(cone(radius * scale, length * scale), NEEDLES, (0, 0, z * scale))
    return link


def hurdle(height):
    """Round bar across the lane, its top `height` above the ground."""
    radius = height / 2
    link = part().visual(cylinder(radius, 2.4), METAL, (0, 0, radius), ALONG_X)
    link.collision(cylinder(radius, 2.4), (0, 0, radius), ALONG_X)
    for side in (-1, 1):
        link.visual(box(0.10, 0.30, height + 0.05), HAZARD, (side * 1.25, 0, (height + 0.05) / 2))
    return link
