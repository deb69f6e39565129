"""What stands along a street, each in a frame of its own on the ground."""

import math

from .gathered import Gathered
from .lettering import word
from .solid import Solid
from .surfaces import (BLACK, CAR_BLUE, GREEN, HAZARD, LAMP, METAL, RED, TRIM, WHITE, WOOD, YELLOW_LINE)


def lamp_post():
    """5.5 m, with an arm towards -X."""
    lamp = Gathered()
    post = lamp.of("green", GREEN).ring([(0.10, 0), (0.10, 0.9), (0.06, 0.95), (0.045, 5.5)], sides=6)
    post.beam((0.02, 0, 5.45), (-1.3, 0, 5.75), 0.07).box((-1.82, -1.08), (-0.13, 0.13), (5.68, 5.80))
    lamp.of("lamp", LAMP).box((-1.72, -1.18), (-0.10, 0.10), (5.65, 5.68), without=("+z",))
    lamp.body.box((-0.1, 0.1), (-0.1, 0.1), (0, 3.0))
    return lamp


def bollard():
    post = Gathered()
    post.of("dark", TRIM).ring([(0.07, 0), (0.085, 0.88), (0.0, 0.95)], sides=6)
    post.of("white", WHITE).ring([(0.083, 0.62), (0.086, 0.74)], sides=6)
    post.body.box((-0.075, 0.075), (-0.075, 0.075), (0, 0.95))
    return post


def disc(solid, count, radius, y, turn=0.0):
    """Regular polygon that faces -Y, its middle 2.45 high."""
    angles = [2 * math.pi * (i + turn) / count for i in range(count)]
    return solid.face(*((-radius * math.sin(a), y, 2.45 + radius * math.cos(a)) for a in angles))


def road_sign(kind):
    """On a post of 2.75 m; read by looking along +Y. Kinds: crossing, slow, parking, stop."""
    sign = Gathered()
    sign.of("metal", METAL).ring([(0.03, 0), (0.03, 2.75)], sides=6)
    sign.of("metal", METAL).box((-0.24, 0.24), (-0.045, -0.035), (2.21, 2.69), without=("-y",))
    sign.body.box((-0.03, 0.03), (-0.03, 0.03), (0, 2.7))
    if kind == "slow":
        disc(sign.of("red", RED), 20, 0.36, -0.05)
        disc(sign.of("white", WHITE), 20, 0.27, -0.07)
        word("30", (0, -0.09, 2.45), 0.24, 0.045, sign.of("dark", TRIM), 0.8)
    elif kind == "stop":
        disc(sign.of("red", RED), 8, 0.36, -0.05, 0.5)
        word("STOP", (0, -0.08, 2.45), 0.20, 0.04, sign.of("white", WHITE), 0.7)
    else:
        disc(sign.of("blue", CAR_BLUE), 4, 0.42, -0.05, 0.5)
        white = sign.of("white", WHITE)
        if kind == "parking":
            word("P", (0, -0.08, 2.45), 0.38, 0.07, white, 0.8)
        else:
            white.face((-0.24, -0.07, 2.24), (0.24, -0.07, 2.24), (0, -0.07, 2.68))
            figure = sign.of("dark", TRIM)
            for a, b in (((-0.08, 2.30), (0, 2.40)), ((0, 2.40), (0.07, 2.29)), ((0, 2.38), (0.01, 2.50))):
                figure.beam((a[0], -0.09, a[1]), (b[0], -0.09, b[1]), 0.025)
    return sign


def bench():
    """1.6 m long, seat at 0.45; looks towards -Y."""
    seat = Gathered()
    wood, iron = seat.of("wood", WOOD), seat.of("dark", TRIM)
    for y in (-0.20, -0.06, 0.08):
        wood.box((-0.8, 0.8), (y - 0.05, y + 0.05), (0.41, 0.45))
    for z in (0.60, 0.76):
        wood.box((-0.8, 0.8), (0.18, 0.22), (z - 0.05, z + 0.05))
    for x in (-0.65, 0.65):
        iron.box((x - 0.03, x + 0.03), (-0.22, 0.18), (0, 0.41), without=("-z",))
        iron.box((x - 0.03, x + 0.03), (0.20, 0.25), (0.3, 0.85))
    seat.body.box((-0.8, 0.8), (-0.25, 0.15), (0, 0.45)).box((-0.8, 0.8), (0.15, 0.25), (0, 0.83))
    return seat


def postbox():
    """Its slot towards -Y."""
    box = Gathered()
    box.of("red", RED).ring([(0.22, 0.15), (0.22, 1.32), (0.25, 1.33), (0.25, 1.39), (0.0, 1.45)], sides=12)
    box.of("dark", TRIM).ring([(0.23, 0), (0.23, 0.15), (0.22, 0.15)], sides=12).box((-0.13, 0.13), (-0.24, -0.2),
                                                                                     (1.10, 1.15))
    box.of("white", WHITE).box((-0.11, 0.11), (-0.235, -0.2), (0.84, 1.00))
    box.body.box((-0.22, 0.22), (-0.22, 0.22), (0, 1.4))
    return box


def barrier():
    """Road closed: striped boards on two feet, 3 m, across Y."""
    whole = Gathered()
    for z in (0.45, 0.85):
        whole.of("hazard", HAZARD).box((-1.5, 1.5), (-0.02, 0.02), (z, z + 0.22))
    for x in (-1.3, 1.3):
        whole.of("dark", TRIM).box((x - 0.03, x + 0.03), (0.02, 0.08), (0.06, 1.1)).box((x - 0.05, x + 0.05),
                                                                                        (-0.3, 0.4), (0, 0.06))
        whole.of("red", RED).box((x - 0.06, x + 0.06), (0, 0.1), (1.1, 1.24))
    whole.body.box((-1.5, 1.5), (-0.05, 0.08), (0, 1.1))
    return whole


def bus_shelter():
    """4.0 x 1.4 m, 2.5 high, open towards -Y; bench, time table, name."""
    whole = Gathered()
    frame, glass = whole.of("dark", TRIM), whole.of("lamp", LAMP)
    for x in (-1.95, -0.65, 0.65, 1.95):
        frame.box((x - 0.04, x + 0.04), (0.62, 0.70), (0, 2.35), without=("-z",))
    for x in (-1.95, 1.95):
        frame.box((x - 0.04, x + 0.04), (-0.62, -0.54), (0, 2.35), without=("-z",))
        for z in (0.25, 2.05):
            frame.box((x - 0.03, x + 0.03), (-0.54, 0.62), (z, z + 0.05))
    for z in (0.25, 2.05):
        frame.box((-1.95, 1.95), (0.63, 0.69), (z, z + 0.05))
    frame.box((-2.10, 2.10), (-0.75, 0.78), (2.35, 2.50))
    # Of the panes one sees the frosted stripes.
    for z0, z1 in ((0.95, 1.03), (1.10, 1.14), (1.50, 1.54)):
        glass.box((-1.91, 1.91), (0.645, 0.655), (z0, z1))
        for x in (-1.95, 1.95):
            glass.box((x - 0.005, x + 0.005), (-0.54, 0.62), (z0, z1))
    whole.of("wood", WOOD).box((-1.5, 0.6), (0.20, 0.52), (0.44, 0.49))
    for x in (-1.3, -0.45, 0.4):
        frame.box((x - 0.03, x + 0.03), (0.33, 0.39), (0, 0.44), without=("-z",))
    time_table(whole)
    whole.of("green", GREEN).box((-1.2, 1.2), (-0.80, -0.75), (2.31, 2.58))
    word("CHURCH STREET", (0, -0.83, 2.445), 0.16, 0.03, whole.of("white", WHITE), 0.85)
    whole.body.box((-1.99, 1.99), (0.61, 0.71), (0, 2.35)).box((-1.5, 0.6), (0.20, 0.52), (0.40, 0.49))
    for x in (-1.95, 1.95):
        whole.body.box((x - 0.04, x + 0.04), (-0.62, 0.62), (0, 2.35))
    return whole


def time_table(whole):
    whole.of("white", WHITE).box((0.85, 1.75), (0.58, 0.62), (0.95, 1.95))
    text = whole.of("black", BLACK)
    for i in range(7):
        z = 1.68 - 0.10 * i
        text.box((0.92, 1.20), (0.572, 0.58), (z, z + 0.03), without=("+y",)).box((1.28, 1.68), (0.572, 0.58),
                                                                                  (z, z + 0.03),
                                                                                  without=("+y",))
    word("TIMES", (1.30, 0.57, 1.85), 0.12, 0.022, text, 0.9)


def bus_stop():
    """Pole with a flag; read by looking along +Y."""
    pole = Gathered()
    pole.of("metal", METAL).ring([(0.035, 0), (0.035, 2.8)], sides=8)
    pole.of("yellow", YELLOW_LINE).box((0.04, 0.54), (-0.02, 0.02), (2.15, 2.75))
    letters = pole.of("black", BLACK)
    word("BUS", (0.29, -0.04, 2.55), 0.20, 0.035, letters, 0.6)
    word("7", (0.29, -0.04, 2.28), 0.16, 0.03, letters)
    pole.body.box((-0.035, 0.035), (-0.035, 0.035), (0, 2.8))
    return pole


def holdall():
    """A bag that somebody left behind."""
    bag, blue = Gathered(), Solid().ring([(0.0, -0.25), (0.13, -0.25), (0.13, 0.25), (0.0, 0.25)], sides=10)
    cloth = bag.of("blue", CAR_BLUE).box((-0.25, 0.25), (-0.13, 0.13), (0.0, 0.22), without=("-z", "+z"))
    cloth.add(blue, lambda c: (c[2], c[0], 0.20 + c[1]))
    dark = bag.of("dark", TRIM)
    for x in (-0.13, 0.13):
        dark.box((x - 0.015, x + 0.015), (-0.14, 0.14), (0.0, 0.345), without=("-z",))
    dark.beam((-0.13, 0, 0.34), (0, 0, 0.42), 0.02).beam((0, 0, 0.42), (0.13, 0, 0.34), 0.02)
    bag.body.box((-0.25, 0.25), (-0.13, 0.13), (0, 0.33))
    return bag
