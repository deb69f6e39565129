"""Chassis and flippers: what the robot drives on."""

from sdf_writer import Link, box, cylinder, mesh, pose, sphere

from .cameras import camera
from .dimensions import ALONG_X, ALONG_Y, AXLE_Y, AXLE_Z, FLIPPER, TRACK_X, WHEEL
from .isectors import chassis_isectors
from .lights import chassis_lights
from .surfaces import (GREY, HAZARD, LAMP, LENS, OLIVE, OLIVE_DARK, ORANGE, PAD, RUBBER, STEEL,
                       TAIL_LAMP)


def chassis():
    link = Link("chassis")
    # 120 kg, the tool mount's 2 kg with it: behind the middle, so that the stretched arm is
    # balanced as designed: centre of gravity at y = 0.1083 without a load [C].
    link.mass(122, (0, -0.0175, 0.20))
    link.visual(mesh("meshes/hull.obj"), OLIVE)
    for side in (-1, 1):
        x = side * TRACK_X
        link.visual(mesh("meshes/track.obj"), RUBBER, (x, 0, 0))
        link.visual(box(0.15, 0.62, 0.02), OLIVE_DARK, (side * 0.285, -0.02, 0.325))
        for end in (-1, 1):
            link.visual(cylinder(0.075, 0.03), STEEL, (side * 0.345, end * AXLE_Y, AXLE_Z), ALONG_X)
            link.visual(cylinder(0.03, 0.05), ORANGE, (side * 0.345, end * AXLE_Y, AXLE_Z), ALONG_X)
        for y in (-0.20, -0.07, 0.07, 0.20):
            link.visual(cylinder(0.055, 0.02), GREY, (side * 0.352, y, 0.085), ALONG_X)
            link.visual(cylinder(0.02, 0.03), STEEL, (side * 0.352, y, 0.085), ALONG_X)
        link.visual(cylinder(0.035, 0.03), LAMP, (side * 0.17, 0.438, 0.355), ALONG_Y)
        link.visual(box(0.05, 0.012, 0.03), TAIL_LAMP, (side * 0.17, -0.466, 0.36))
    link.visual(box(0.40, 0.012, 0.045), HAZARD, (0, 0.462, 0.27))
    link.visual(box(0.40, 0.012, 0.045), HAZARD, (0, -0.466, 0.29))
    link.visual(box(0.07, 0.05, 0.05), GREY, (0, 0.415, 0.40))
    link.visual(cylinder(0.018, 0.012), LENS, (0, 0.444, 0.40), ALONG_Y)
    link.visual(box(0.07, 0.05, 0.05), GREY, (0, -0.415, 0.425))
    link.visual(cylinder(0.018, 0.012), LENS, (0, -0.444, 0.40), ALONG_Y)
    # Shoulder, electronics, mast with its radio aerial.
    link.visual(box(0.22, 0.22, 0.08), OLIVE_DARK, (0, -0.10, 0.49))
    link.visual(cylinder(0.07, 0.20), GREY, (0, -0.10, 0.55), ALONG_X)
    link.visual(box(0.14, 0.24, 0.09), GREY, (0.16, -0.30, 0.495))
    link.visual(box(0.10, 0.10, 0.03), GREY, (-0.20, -0.25, 0.465))
    link.visual(cylinder(0.022, 0.64), GREY, (-0.20, -0.25, 0.78))
    link.visual(cylinder(0.026, 0.06), ORANGE, (-0.20, -0.25, 0.98))
    link.visual(cylinder(0.012, 0.05), STEEL, (0.16, -0.38, 0.56))
    link.visual(cylinder(0.004, 0.60), PAD, (0.16, -0.38, 0.86))
    link.visual(sphere(0.010), ORANGE, (0.16, -0.38, 1.16))
    chassis_solids(link)
    link.parts += chassis_isectors()
    link.parts += camera("drive", 75, (0, 0.45, 0.40))
    rear = camera("rear", 75, (0, -0.45, 0.40))
    link.parts += [line.replace(pose((0, -0.45, 0.40), (0, 0, 90))[0],
                                pose((0, -0.45, 0.40), (0, 0, -90))[0]) for line in rear]
    link.parts += chassis_lights()
    return link


def chassis_solids(link):
    """What pushes movable things: hull, tracks, shoulder, electronics, mast."""
    link.collision(box(0.47, 0.90, 0.33), (0, 0, 0.28))
    for side in (-1, 1):
        link.collision(box(0.10, 2 * AXLE_Y, 0.20), (side * TRACK_X, 0, AXLE_Z))
        link.collision(box(0.10, 0.50, 0.12), (side * TRACK_X, 0, 0.06))
        for end in (-1, 1):
            link.collision(cylinder(0.10, 0.10), (side * TRACK_X, end * AXLE_Y, AXLE_Z), ALONG_X)
    link.collision(box(0.22, 0.22, 0.17), (0, -0.10, 0.53))
    link.collision(box(0.14, 0.24, 0.10), (0.16, -0.30, 0.495))
    link.collision(box(0.05, 0.05, 0.66), (-0.20, -0.25, 0.78))


def flipper(name, isectors):
    """Pair of swing arms: frame at the axle, +Y along the arms."""
    link = Link(name).mass(12, (0, 0.17, 0))
    for side in (-1, 1):
        x = side * TRACK_X
        link.visual(mesh("meshes/flipper.obj"), RUBBER, (x, 0, 0))
        link.visual(box(0.085, 0.27, 0.05), OLIVE_DARK, (side * 0.30, 0.21, 0))
        link.visual(cylinder(0.06, 0.11), STEEL, (x, FLIPPER, 0), ALONG_X)
        link.visual(cylinder(0.025, 0.12), ORANGE, (x, FLIPPER, 0), ALONG_X)
    link.visual(cylinder(0.025, 0.52), GREY, (0, 0, 0), ALONG_X)
    for x in (-TRACK_X, TRACK_X):
        link.collision(box(0.07, FLIPPER, 0.17), (x, FLIPPER / 2, 0))
        link.collision(cylinder(WHEEL, 0.11), (x, FLIPPER, 0), ALONG_X)
    link.parts += isectors
    return link
