"""The office's stairs: two flights of 9 x 165/280 side by side, a landing of 1.2 x 2.4 m between them."""

import math

from sdf_writer import box

from .assembly import Assembly
from .module import part
from .office_plan import (CLEAR, FLIGHT_WIDTH, FOOT_Y, LANDING_Y, RISE, RUN, STAIR_X, STEPS, STOREY,
                          UPPER_FOOT_Y, UPPER_TOP_Y, WELL)
from .scenery import write_mesh
from .solid import Solid
from .stairs import flight
from .surfaces import CONCRETE_DARK, DOOR_WOOD, METAL, PLASTER, STEEL, YELLOW_LINE

LANDING_Z = STEPS * RISE
LOWER_X = STAIR_X[0] + FLIGHT_WIDTH / 2
UPPER_X = STAIR_X[1] - FLIGHT_WIDTH / 2
WELL_X = STAIR_X[0] + FLIGHT_WIDTH + WELL / 2
TOP_OF_LOWER = LANDING_Y[0]


def _lower(folder):
    link = part()
    flight(link, FLIGHT_WIDTH, 0, 0, STEPS, RISE, RUN, folder)
    return link


def _landing_and_block():
    """The landing, and what is under the upper flight: a closed cupboard."""
    x0, x1 = STAIR_X
    link = part()
    depth = LANDING_Y[1] - LANDING_Y[0]
    link.solid(box(x1 - x0, depth, LANDING_Z), CONCRETE_DARK,
               ((x0 + x1) / 2, (LANDING_Y[0] + LANDING_Y[1]) / 2, LANDING_Z / 2))
    link.solid(box(FLIGHT_WIDTH, RUN, LANDING_Z), CONCRETE_DARK, (UPPER_X, UPPER_FOOT_Y + RUN / 2, LANDING_Z / 2))
    link.visual(box(FLIGHT_WIDTH, 0.043, 0.043), YELLOW_LINE, (LOWER_X, LANDING_Y[0] + 0.0185, LANDING_Z - 0.0185))
    return link


def _block(folder):
    wide = (UPPER_X - FLIGHT_WIDTH / 2, STAIR_X[1])
    room = Assembly().box(PLASTER, wide, (UPPER_TOP_Y, UPPER_FOOT_Y), (0, LANDING_Z), without=("-z", "+z", "+y", "+x"))
    room.box(PLASTER, (WELL_X - 0.04, STAIR_X[1]), (UPPER_TOP_Y - 0.05, UPPER_TOP_Y), (0, CLEAR), without=("-z",))
    room.show(DOOR_WOOD, (0.82, 1.46), (UPPER_TOP_Y - 0.065, UPPER_TOP_Y - 0.05), (0.02, 1.75), without=("+y",))
    room.show(STEEL, (0.88, 0.90), (UPPER_TOP_Y - 0.10, UPPER_TOP_Y - 0.065), (0.95, 1.07))
    return room.link("cupboard", folder, shadow=False)


def _rail(solid, x, start, end):
    """Handrail and posts along the slope from `start` to `end` (y, z)."""
    for height in (0.35, 0.62, 0.95):
        solid.beam((x, start[0], start[1] + height), (x, end[0], end[1] + height), 0.05 if height > 0.9 else 0.025)
    for i in range(5):
        y, z = (start[k] + (end[k] - start[k]) * i / 4 for k in (0, 1))
        solid.beam((x, y, z - 0.10), (x, y, z + 0.95), 0.03)


def _rails(folder):
    steel = Solid()
    lower = ((FOOT_Y - RUN / 2, 0.05), (TOP_OF_LOWER - 0.06, LANDING_Z - 0.05))
    upper = ((UPPER_FOOT_Y + 0.04, LANDING_Z + 0.08), (UPPER_TOP_Y + 0.02, STOREY))
    link = part()
    for x, (start, end) in ((WELL_X - 0.025, lower), (WELL_X + 0.025, upper)):
        _rail(steel, x, start, end)
        slope = math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
        link.collision(box(0.03, math.dist(start, end), 0.60), (x, (start[0] + end[0]) / 2, (start[1] + end[1]) / 2 + 0.65),
                       (slope, 0, 0), proxy="bump")
    # Round the well on the upper floor.
    y = FOOT_Y - 0.06
    for height in (0.12, 0.35, 0.62, 0.95):
        steel.beam((STAIR_X[0], y, STOREY + height), (WELL_X, y, STOREY + height), 0.05 if height > 0.9 else 0.025)
    for x in (STAIR_X[0] + 0.03, -0.05, WELL_X):
        steel.beam((x, y, STOREY), (x, y, STOREY + 0.95), 0.04)
    link.collision(box(WELL_X - STAIR_X[0], 0.05, 1.0), ((WELL_X + STAIR_X[0]) / 2, y, STOREY + 0.5), proxy="bump")
    # Along the outer walls.
    for x, (start, end) in ((STAIR_X[0] + 0.05, lower), (STAIR_X[1] - 0.05, upper)):
        steel.beam((x, start[0], start[1] + 0.95), (x, end[0], end[1] + 0.95), 0.045)
    return link.visual(write_mesh(steel, "staircase_rails", folder), METAL, shadow=False)


def staircase(yard, folder):
    yard.model("stair_lower", _lower(folder), (LOWER_X, FOOT_Y, 0))
    yard.model("stair_upper", _lower(folder), (UPPER_X, UPPER_FOOT_Y, LANDING_Z), 180)
    yard.model("stair_landing", _landing_and_block())
    yard.model("stair_cupboard", _block(folder))
    yard.model("stair_rails", _rails(folder))
