"""What is built into an office: lamps, lift doors, radiators, signs, extinguishers."""

from .assembly import Assembly
from .surfaces import (BLACK, EXIT_GREEN, GREY, LAMINATE, LAMP, METAL, RED, STEEL, WHITE)


def ceiling_lamp(ceiling, length=1.2, width=0.3):
    """Panel below the ceiling at z = `ceiling`, along X."""
    lamp = Assembly().show(LAMINATE, (-length / 2 - 0.02, length / 2 + 0.02), (-width / 2 - 0.02, width / 2 + 0.02),
                           (ceiling - 0.04, ceiling), without=("+z",))
    z, half, side = ceiling - 0.042, length / 2, width / 2
    lamp.of(LAMP).face((-half, -side, z), (-half, side, z), (half, side, z), (half, -side, z))
    return lamp


def point_light(name, module, xyz, reach):
    """Of a ceiling lamp: SDFormat's point light in the module's frame, `reach` in metres."""
    x, y, z = (round(c, 3) for c in xyz)
    return [f'<light name="{name}" type="point">', f'  <pose relative_to="{module}">{x} {y} {z} 0 0 0</pose>',
            "  <diffuse>1 0.95 0.84 1</diffuse>", "  <specular>0.2 0.2 0.2 1</specular>",
            f"  <attenuation><range>{reach}</range><constant>0.3</constant><linear>0.12</linear>"
            "<quadratic>0.05</quadratic></attenuation>", "  <cast_shadows>false</cast_shadows>", "</light>"]


def lift_door():
    """In a wall along X whose face is y = 0; the lift is behind, towards +Y."""
    lift = Assembly().show(STEEL, (-0.66, -0.55), (-0.03, 0), (0, 2.22)).show(STEEL, (0.55, 0.66), (-0.03, 0), (0, 2.22))
    lift.show(STEEL, (-0.55, 0.55), (-0.03, 0), (2.10, 2.22))
    for side in (-1, 1):
        lift.show(METAL, (side * 0.003, side * 0.55), (-0.012, 0), (0.01, 2.10), without=("+y",))
    lift.show(BLACK, (-0.003, 0.003), (-0.008, 0), (0.01, 2.10), without=("+y",))
    lift.show(BLACK, (-0.16, 0.16), (-0.045, -0.03), (2.13, 2.19)).show(RED, (-0.03, 0.03), (-0.048, -0.045), (2.145, 2.175))
    lift.show(STEEL, (0.80, 0.90), (-0.02, 0), (1.0, 1.25))
    return lift.show(LAMP, (0.835, 0.865), (-0.03, -0.02), (1.14, 1.17)).show(BLACK, (0.835, 0.865), (-0.03, -0.02), (1.06, 1.09))


def radiator(width=1.2):
    """Below a window, on the wall at y = 0, the room towards -Y."""
    thing = Assembly().box(WHITE, (-width / 2, width / 2), (-0.09, -0.05), (0.16, 0.70))
    for i in range(int(width / 0.12)):
        x = -width / 2 + 0.03 + 0.12 * i
        thing.panel(GREY, (x, x + 0.02), -0.092, (0.20, 0.66))
    return thing.show(WHITE, (-width / 2 + 0.1, -width / 2 + 0.13), (-0.05, 0), (0.2, 0.24))


def extinguisher():
    """On the wall at y = 0."""
    thing = Assembly().round(RED, (0, -0.10), 0.075, (0.55, 0.98), 10).round(BLACK, (0, -0.10), 0.03, (0.98, 1.06), 8)
    thing.show(RED, (-0.10, 0.10), (-0.006, 0), (1.35, 1.55), without=("+y",))
    thing.show(WHITE, (-0.03, 0.03), (-0.008, -0.006), (1.39, 1.51), without=("+y",))
    thing.met.box((-0.075, 0.075), (-0.175, 0), (0.5, 1.06))
    return thing


def exit_sign(both_sides=False):
    """Hangs from z = 2.5, read by looking along +Y; a white running man is a bar and an arrow here."""
    sign = Assembly().show(EXIT_GREEN, (-0.22, 0.22), (-0.015, 0.015), (2.24, 2.44))
    for side in (-1, 1) if both_sides else (-1,):
        for x, z in (((-0.14, 0.06), (2.325, 2.355)), ((0.06, 0.09), (2.30, 2.38)), ((0.09, 0.12), (2.32, 2.36)),
                     ((-0.19, -0.16), (2.28, 2.40))):
            sign.panel(WHITE, x, side * 0.018, z, side)
    return sign


def room_plate():
    """Beside a door, on the wall at y = 0."""
    return Assembly().show(STEEL, (-0.08, 0.08), (-0.008, 0), (1.45, 1.61), without=("+y",)).show(
        BLACK, (-0.05, 0.05), (-0.010, -0.008), (1.52, 1.56), without=("+y",))


def clock():
    """On the wall at y = 0: ten past ten."""
    face = Assembly().show(BLACK, (-0.16, 0.16), (-0.03, 0), (1.99, 2.31), without=("+y",))
    face.show(WHITE, (-0.145, 0.145), (-0.033, -0.03), (2.005, 2.295), without=("+y",))
    face.show(BLACK, (-0.008, 0.008), (-0.036, -0.033), (2.14, 2.27), without=("+y",))
    return face.show(BLACK, (-0.008, 0.08), (-0.036, -0.033), (2.14, 2.158), without=("+y",))
