"""Walls with openings, and what fills the openings: doors and windows."""

from .assembly import Assembly
from .surfaces import DOOR_WOOD, GREY, LAMINATE, SKIRTING, STEEL, WHITE

DOOR_WIDTH, DOOR_HEIGHT = 0.90, 2.05  # clear [m]
LINING = 0.03
LEAF = 0.04
SKIRTING_HEIGHT, SKIRTING_DEPTH = 0.09, 0.012


def doorway(middle):
    """Opening in a wall for a door whose clear width is centred on `middle`."""
    half = DOOR_WIDTH / 2 + LINING
    return (middle - half, middle + half, 0.0, DOOR_HEIGHT + LINING)


def _pieces(span, height, openings):
    """Rectangles (from, to, bottom, top) of a wall round its openings; heights above its foot."""
    at = span[0]
    for start, end, bottom, top in sorted(openings):
        if start > at:
            yield at, start, 0.0, height
        if bottom > 0:
            yield start, end, 0.0, bottom
        if top < height:
            yield start, end, top, height
        at = end
    if at < span[1]:
        yield at, span[1], 0.0, height


def wall(room, surface, along, faces, span, z, openings=(), skirting=(), met=True):
    """Along "x" or "y", between two `faces` of the other axis, from z[0] to z[1]. `skirting`: -1 for the
    lower face, 1 for the upper one."""
    def lay(look, across, a, b, low, high, is_met):
        x, y = ((a, b), across) if along == "x" else (across, (a, b))
        room.box(look, x, y, (z[0] + low, z[0] + high), met=is_met, without=("-z",) if low == 0 else ())

    for a, b, low, high in _pieces(span, z[1] - z[0], openings):
        lay(surface, faces, a, b, low, high, met)
        if low > 0 or high < SKIRTING_HEIGHT:
            continue
        for side in skirting:
            face = faces[1] if side > 0 else faces[0]
            lay(SKIRTING, sorted((face, face + side * SKIRTING_DEPTH)), a, b, 0.0, SKIRTING_HEIGHT, False)


def door_frame(thickness):
    """Linings and architraves of a doorway along X, centred, its wall `thickness` deep about y = 0."""
    frame = Assembly()
    half, deep = DOOR_WIDTH / 2, thickness / 2 + 0.012
    for side in (-1, 1):
        frame.box(LAMINATE, (side * half, side * (half + LINING)), (-deep, deep), (0, DOOR_HEIGHT + LINING))
        for face in (-1, 1):
            y = (face * thickness / 2, face * deep)
            frame.show(LAMINATE, (side * (half + LINING), side * (half + 0.09)), y, (0, DOOR_HEIGHT + 0.09))
    frame.box(LAMINATE, (-half, half), (-deep, deep), (DOOR_HEIGHT, DOOR_HEIGHT + LINING))
    for face in (-1, 1):
        frame.show(LAMINATE, (-half - LINING, half + LINING), (face * thickness / 2, face * deep),
                   (DOOR_HEIGHT + LINING, DOOR_HEIGHT + 0.09))
    return frame


def door_leaf(surface=DOOR_WOOD, window=False):
    """Hinged at the origin, along +X, its thickness towards -Y; lever handles on both sides."""
    leaf = Assembly()
    wide = DOOR_WIDTH - 0.01
    leaf.box(surface, (0, wide), (-LEAF, 0), (0.01, DOOR_HEIGHT - 0.005))
    for side, face in ((1, 0.0), (-1, -LEAF)):
        def plate(look, x, proud, z, face=face, side=side):
            leaf.panel(look, x, face + side * proud, z, side)

        plate(STEEL, (wide - 0.10, wide - 0.06), 0.004, (0.93, 1.15))
        leaf.show(STEEL, (wide - 0.21, wide - 0.07), (face + side * 0.035, face + side * 0.05), (1.065, 1.09))
        leaf.show(STEEL, (wide - 0.09, wide - 0.07), (face, face + side * 0.035), (1.065, 1.09))
        plate(STEEL, (0.05, wide - 0.05), 0.003, (0.03, 0.22))
        if window:
            plate(GREY, (wide - 0.33, wide - 0.15), 0.004, (1.25, 1.85))
    return leaf


def window_frame(width, height, thickness=0.30, mullions=1):
    """In an opening along X with its sill at z = 0, inside towards +Y; the pane is met, not seen."""
    frame = Assembly()
    half, bar = width / 2, 0.05
    y = (-0.05, 0.01)
    for x in ((-half, -half + bar), (half - bar, half)):
        frame.box(WHITE, x, y, (0, height))
    for z in ((0, bar), (height - bar, height)):
        frame.box(WHITE, (-half + bar, half - bar), y, z)
    for i in range(mullions):
        x = -half + width * (i + 1) / (mullions + 1)
        frame.box(WHITE, (x - bar / 2, x + bar / 2), y, (bar, height - bar))
    frame.met.box((-half, half), (-0.02, 0), (0, height))
    frame.box(LAMINATE, (-half - 0.05, half + 0.05), (thickness / 2 - 0.10, thickness / 2 + 0.14), (-0.03, 0.0))
    return frame
