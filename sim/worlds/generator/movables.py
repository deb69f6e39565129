"""Things that are pushed, topple, roll and fall: training charges, cartons, cones."""

from sdf_writer import box, cone, cylinder

from .module import part
from .scenery import write_mesh
from .solid import Solid, write_text
from .surfaces import BLACK, CARDBOARD, HAZARD, ORANGE, RED, STEEL, TAPE, WHITE


def cylinder_moments(mass, radius, length):
    across = mass * (3 * radius ** 2 + length ** 2) / 12
    return across, across, mass * radius ** 2 / 2


def box_moments(mass, x, y, z):
    return tuple(mass * (a * a + b * b) / 12 for a, b in ((y, z), (x, z), (x, y)))


def charge(letter, radius, length, mass, folder):
    """Steel cylinder with a hazard band, a cap, two wires and a label towards the south; centred."""
    half = length / 2
    link = part().inertial(mass, cylinder_moments(mass, radius, length))
    link.collision(cylinder(radius, length))
    link.visual(cylinder(radius, length - 0.012), STEEL, (0, 0, -0.006))
    link.visual(cylinder(radius * 0.82, 0.012), RED, (0, 0, half - 0.006))
    link.visual(cylinder(radius + 0.0008, length * 0.16), HAZARD, (0, 0, half * 0.55))
    link.visual(cylinder(radius + 0.0006, length * 0.05), BLACK, (0, 0, -half * 0.82))
    plate = (radius * 0.9, 0.012, length * 0.34)
    front = -radius - 0.002
    link.visual(box(*plate), WHITE, (0, front + plate[1] / 2, -half * 0.22))
    text = write_text(letter, (0, front, -half * 0.22), length * 0.24, radius * 0.12, Solid())
    link.visual(write_mesh(text, f"charge_{letter.lower()}_letter", folder), BLACK)
    for name, surface, side in (("red", RED, 1), ("black", BLACK, -1)):
        wire, outer = Solid(), radius + 0.002
        points = [(side * radius * 0.2, 0, half + 0.002), (side * outer * 0.8, -outer * 0.6, half + 0.002),
                  (side * outer * 0.8, -outer * 0.6, -half * 0.3), (side * outer, 0, -half * 0.6)]
        for start, end in zip(points, points[1:]):
            wire.beam(start, end, 0.004)
        link.visual(write_mesh(wire, f"charge_{letter.lower()}_wire_{name}", folder), surface)
    return link


def carton(x, y, z, mass):
    link = part().inertial(mass, box_moments(mass, x, y, z)).solid(box(x, y, z), CARDBOARD)
    link.visual(box(x + 0.002, 0.05, z + 0.002), TAPE)
    return link.visual(box(x * 0.4, y + 0.003, z * 0.3), WHITE, (0, 0, -z * 0.1))


def loose_cone():
    """Traffic cone; its frame on the ground. It weighs most at the foot."""
    link = part().inertial(2.5, box_moments(2.5, 0.25, 0.25, 0.4), (0, 0, 0.18))
    link.visual(box(0.34, 0.34, 0.03), BLACK, (0, 0, 0.015)).collision(box(0.34, 0.34, 0.03), (0, 0, 0.015))
    link.visual(cone(0.15, 0.67), ORANGE, (0, 0, 0.365))
    link.collision(cylinder(0.11, 0.35), (0, 0, 0.205)).collision(cylinder(0.05, 0.30), (0, 0, 0.53))
    return link.visual(cylinder(0.088, 0.09), WHITE, (0, 0, 0.34))


def wheeled_bin(surface):
    """Two-wheeled bin, 0.58 x 0.70 m, 1.05 high; its frame on the ground."""
    link = part().inertial(14.0, box_moments(14.0, 0.55, 0.60, 0.95), (0, 0, 0.45))
    link.visual(box(0.52, 0.60, 0.86), surface, (0, 0, 0.51)).collision(box(0.52, 0.60, 0.94), (0, 0, 0.47))
    link.visual(box(0.58, 0.70, 0.08), surface, (0, 0, 0.98)).collision(box(0.58, 0.70, 0.10), (0, 0, 0.99))
    link.visual(box(0.50, 0.05, 0.04), BLACK, (0, 0.37, 0.99)).visual(box(0.40, 0.50, 0.08), BLACK, (0, -0.02, 0.04))
    return link.visual(cylinder(0.09, 0.50), BLACK, (0, 0.25, 0.09), (0, 90, 0))
