"""Module 5, indoor: a two-storey office building. PLACEHOLDER
"""

from sdf_writer import box, cylinder

from .forecourt import forecourt
from .module import Module, part
from .movables import box_moments, carton, charge, cylinder_moments
from .office_furniture import office_chair, waste_bin
from .office_plan import NORTH, OUTER, SOUTH, STOREY
from .office_rooms import rooms
from .office_shell import canopy, entrance_doors, floors, outer_walls, roof
from .scenery import ground, land, trees
from .staircase import staircase
from .surfaces import CHAIR_BLUE
from .vessels import DRUM, drum

HALF_X, HALF_Y = 30, 20
SEEN = 84
CAN = (2.4, 6.3)
CHARGE = (-3.9, 10.9)
CHARGE_RADIUS, CHARGE_LENGTH, CHARGE_MASS = 0.030, 0.160, 1.0


def movable_chair(folder):
    """On castors; its frame on the floor."""
    link = part().inertial(9.0, box_moments(9.0, 0.5, 0.5, 0.9), (0, 0, 0.36))
    link.collision(cylinder(0.30, 0.09), (0, 0, 0.045)).collision(cylinder(0.03, 0.34), (0, 0, 0.26))
    link.collision(box(0.48, 0.48, 0.08), (0, 0, 0.47)).collision(box(0.44, 0.06, 0.45), (0, -0.26, 0.825))
    return office_chair(CHAIR_BLUE).seen_by(link, "movable_chair", folder)


def movable_bin(folder):
    link = part().inertial(1.2, cylinder_moments(1.2, 0.14, 0.32), (0, 0, 0.14))
    return waste_bin().seen_by(link.collision(cylinder(0.14, 0.32), (0, 0, 0.16)), "movable_bin", folder)


def movables(yard, folder):
    yard.movable("charge_desk", charge("S", CHARGE_RADIUS, CHARGE_LENGTH, CHARGE_MASS, folder),
                 (*CHARGE, STOREY + CHARGE_LENGTH / 2), 0.6, explosive=True)
    for i, (x, y, storey) in enumerate(((-7.1, 4.5, 0), (-2.3, 10.75, 0), (-1.5, 11.6, 1), (-1.3, 5.0, 1))):
        yard.movable(f"chair_{i + 1}", movable_chair(folder), (x, y, storey * STOREY), 0.35)
    for i, (x, y, storey) in enumerate(((1.6, 7.9, 0), (-0.2, 11.9, 1), (-0.2, 7.3, 1))):
        yard.movable(f"bin_{i + 1}", movable_bin(folder), (x, y, storey * STOREY), 0.5)
    for i, (x, y, storey, size) in enumerate(((-1.4, 8.0, 0, (0.40, 0.40, 0.35, 2.0)), (5.9, 10.8, 0, (0.5, 0.35, 0.3, 2.5)),
                                              (3.1, 7.9, 1, (0.40, 0.40, 0.35, 2.0)))):
        yard.movable(f"indoor_carton_{i + 1}", carton(*size), (x, y, storey * STOREY + size[2] / 2), 0.5)


def indoor(folder):
    """Module 5."""
    yard = Module(5, "indoor", (1000, -1000, 0), (2 * HALF_X, 2 * HALF_Y))
    west, east, south, north = -9.3, 9.3, SOUTH - OUTER, NORTH + OUTER
    half = HALF_X
    yard.model("indoor_ground", ground((((-half, west), (-half, half)), ((east, half), (-half, half)),
                                        ((west, east), (-half, south)), ((west, east), (north, half))), half, SEEN))
    forecourt(yard, folder)
    floors(yard, folder)
    outer_walls(yard, folder)
    roof(yard, folder)
    yard.model("office_entrance", entrance_doors().put(canopy()).link("office_entrance", folder))
    rooms(yard, folder)
    staircase(yard, folder)
    yard.vessel("can_lobby", drum(folder), (*CAN, 0), DRUM)
    movables(yard, folder)
    trees(yard, [(-14, -3), (14.5, 5), (14, -3), (-22, -9), (24, -9), (-15, 9), (18, 15), (-18, 16)], 5)
    land(yard)
    return yard
