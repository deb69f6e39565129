"""Module 5, indoor: a two-storey office building, its forecourt and its neighbours.

The building stands at x = -9.3..9.3, y = 3.0..18.94 (office_plan.py); floors at z = 0 and 2.97, ceilings
2.67 above them. Local metres; heading 0 leads north into the building.

    x       y           what
    0       0           start pad, before the entrance: 1.80 clear, two glass leaves stand open
    -4.2..4.2    3.3..8.5    lobby: reception desk (-2.5, 6), two lift doors in the east wall (y = 5.7, 7.4),
                        sofa (3, 3.9); can_lobby at (2.4, 6.3): drum, net 0.50, rim 0.85, approached from
                        the west, heading 270 at (1.35, 6.3), or from the south
    -4.28   4.6         door 0.90 to office_101 (x -9..-4.35, y 3.3..8.5), approached with heading 90
    -0.66..0.54  8.5..13.0   corridor_1, 1.2 wide
    -0.74   11.2        door 0.90 to meeting_room (x -9..-0.81, y 8.65..12.85), half open: look in only
    0.62    10.8        door 0.90 to server_room; aisle of 0.90 between racks, y = 10.8, x = 1.74..5.39;
                        from (0, 10.8), heading 270, straight in
    -0.66..1.74  13.0..15.2  stair hall; closed lever doors at y = 14 on both sides
    -0.66..0.49  15.2..17.44 lower flight, 9 x 165/280; driven with heading 0 at x = 0
    -0.66..1.74  17.44..18.64 landing 2.4 x 1.2 at z = 1.485; the robot turns at y = 17.96..18.01, at
                        x = 0 and at x = 1.08, with flippers up and arm stowed
    0.59..1.74   17.16..14.92 upper flight, driven with heading 180 at x = 1.08
    -0.66..1.74  13.0..14.92 hall of the second floor, z = 2.97
    0.54..1.74   8.5..13.0   corridor_2, 1.2 wide, driven at x = 1.08
    0.46    10.9        door 0.90 to office_201 (x -9..0.39, y 8.65..12.85): turn to heading 90 at (1.08, 10.9)
    -3.9    10.9        charge_desk: trainer S, 30 x 160 mm, 1 kg, on the floor under a desk whose edge is
                        x = -3.6, knee space 0.65 high; hand at it with the robot at x = -2.70, heading 90,
                        preset ground_pick
    0.46    6.0         door 0.90 to office_202 (x -9..0.39, y 3.3..8.5)
    1.82    10.0        door 0.90 to office_203 (x 1.89..9, y 8.65..12.85)
    0.54..4.2    3.3..8.5    lift_lobby_2

Everything 1.2 m wide leaves 0.66 m on one side of the way and 0.54 on the other: on the spot the robot's
corners and their feelers need 0.626. Furniture is BUMP only; floors, landing and flights carry. Movable:
chair_1 office_101, chair_2 meeting_room, chair_3 office_201, chair_4 office_202, bin_1 lobby, bin_2
office_201, bin_3 office_202, indoor_carton_1 lobby, _2 server aisle's end, _3 lift_lobby_2.
Lights: one point light or two a room, ROOM_lamp_N.
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
    trees(yard, [(-14, -3), (15, 6), (14.5, -3), (-17, 11), (24, -9)], 5)
    land(yard)
    return yard
