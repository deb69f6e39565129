"""The office building without its rooms: outer walls with windows, floors, ceilings, roof, canopy."""

from sdf_writer import box, plane

from .assembly import Assembly
from .module import part
from .office_plan import (BLIND_EAST, BLIND_NORTH, BLIND_SIDE, BLIND_SOUTH, CLEAR, EAST, EAST_WINDOWS, ENTRANCE,
                          FOOT_Y, NORTH, NORTH_WINDOWS, OUTER, PARAPET, SOUTH, SOUTH_WINDOWS, STAIR_X, STOREY, UPPER_CORRIDOR_X,
                          UPPER_TOP_Y, WEST,
                          WEST_WINDOWS)
from .scenery import write_mesh
from .solid import Solid, write_text
from .surfaces import (BLACK, BLUE, BRICK_PALE, CEILING, CONCRETE, CONCRETE_DARK, GLASS, GREY, LAMINATE, METAL, PLASTER,
                       STEEL, VINYL, WHITE)
from .walls import wall, window_frame

ENTRANCE_HEIGHT = 2.30
ROOF_Z = STOREY + CLEAR
# name, along, its inner face, which way it faces (heading that turns +Y inwards), windows, dark panes
SIDES = (("south", "x", SOUTH, 0, SOUTH_WINDOWS, BLIND_SOUTH), ("north", "x", NORTH, 180, NORTH_WINDOWS, BLIND_NORTH),
         ("west", "y", WEST, 270, WEST_WINDOWS, BLIND_SIDE), ("east", "y", EAST, 90, EAST_WINDOWS, BLIND_EAST + BLIND_SIDE))


def _openings(windows):
    return [(at - width / 2, at + width / 2, sill, head) for at, width, sill, head in windows]


def _side(name, along, inner, heading, windows, blind):
    """One outer wall: brick outside, plaster inside, each half of the thickness."""
    inward = 1 if name in ("south", "west") else -1
    middle, outer = inner - inward * OUTER / 2, inner - inward * OUTER
    room = Assembly()
    entrance = [(-ENTRANCE / 2 - 0.06, ENTRANCE / 2 + 0.06, 0.0, ENTRANCE_HEIGHT + 0.06)] if name == "south" else []
    ends = (WEST - OUTER, EAST + OUTER) if along == "x" else (SOUTH, NORTH)
    inside = (WEST - OUTER / 2, EAST + OUTER / 2) if along == "x" else (SOUTH, NORTH)
    # One opening above another splits a wall no more than one does: storey by storey.
    for low, high in ((0.0, STOREY), (STOREY, PARAPET)):
        def within(rows, low=low, high=high):
            return [(a, b, bottom - low, top - low) for a, b, bottom, top in rows if low <= bottom < high]

        holes = within(_openings(windows + blind))
        brick_span = ends if along == "x" else (SOUTH - OUTER / 2, NORTH + OUTER / 2)
        wall(room, BRICK_PALE, along, sorted((outer, middle)), brick_span, (low, high),
             holes + within(entrance))
        wall(room, PLASTER, along, sorted((middle, inner)), inside, (low, min(high, ROOF_Z)),
             within(_openings(windows)) + within(entrance), skirting=() if name == "north" else (inward,))

    def place(at, z):
        return ((at, middle, z) if along == "x" else (middle, at, z)), heading

    for at, width, sill, head in windows:
        room.put(window_frame(width, head - sill, OUTER, max(1, round(width / 0.9) - 1)), *place(at, sill))
    for at, width, sill, head in blind:
        pane = Assembly().show(GLASS, (-width / 2, width / 2), (-0.03, 0), (0, head - sill))
        pane.put(window_frame(width, head - sill, 0.0, 1), (0, -0.01, 0))
        room.put(pane, *place(at, sill))
    return room


def outer_walls(yard, folder):
    for name, along, inner, heading, windows, blind in SIDES:
        room = _side(name, along, inner, heading, windows, blind)
        yard.model(f"office_wall_{name}", room.link(f"office_wall_{name}", folder))


def entrance_doors():
    """Two glass leaves stand open into the lobby."""
    room, half = Assembly(), ENTRANCE / 2
    for side in (-1, 1):
        room.box(GREY, (side * half, side * (half + 0.06)), (SOUTH - OUTER, SOUTH), (0, ENTRANCE_HEIGHT + 0.06))
        x = (side * (half + 0.01), side * (half + 0.055))
        for y, z in (((3.32, 3.40), (0.02, 2.26)), ((4.10, 4.18), (0.02, 2.26)), ((3.40, 4.10), (0.02, 0.20)),
                     ((3.40, 4.10), (2.14, 2.26))):
            room.show(GREY, x, y, z)
        room.show(STEEL, (side * (half - 0.03), side * half), (4.02, 4.05), (0.90, 1.40))
        room.met.box(sorted(x), (3.32, 4.18), (0.02, 2.26))
    room.box(GREY, (-half, half), (SOUTH - OUTER, SOUTH), (ENTRANCE_HEIGHT, ENTRANCE_HEIGHT + 0.06))
    return room


def _grid(xs, ys, holes):
    """Rectangles that share their corners, so that level ground is found to go on."""
    return [((a, b), (c, d)) for i, (a, b) in enumerate(zip(xs, xs[1:])) for j, (c, d) in enumerate(zip(ys, ys[1:]))
            if (i, j) not in holes]


def floors(yard, folder):
    """Level ground in the building; the slab between the storeys has a hole for the stairs."""
    ground = part()
    size = (EAST - WEST + 2 * OUTER, NORTH - SOUTH + 2 * OUTER)
    ground.collision(plane(*size, 4), ((WEST + EAST) / 2, (SOUTH + NORTH) / 2, 0))
    base, slab = Solid().floor((WEST - OUTER, EAST + OUTER), (SOUTH - OUTER, NORTH + OUTER), 0.002), Solid()
    ground.visual(write_mesh(base, "office_base", folder), VINYL)
    top, under, edges = Solid(), Solid(), Solid()
    split = UPPER_CORRIDOR_X[0]
    for x, y in _grid((WEST, STAIR_X[0], split, STAIR_X[1], EAST), (SOUTH, UPPER_TOP_Y, FOOT_Y, NORTH),
                      ((1, 2), (2, 1), (2, 2))):
        top.floor(x, y, STOREY)
        under.face((x[0], y[0], CLEAR), (x[0], y[1], CLEAR), (x[1], y[1], CLEAR), (x[1], y[0], CLEAR))
    for x, y in (((STAIR_X[0], split), FOOT_Y), ((split, STAIR_X[1]), UPPER_TOP_Y)):
        edges.box(x, (y - 0.02, y), (CLEAR, STOREY), without=("-x", "+x", "-y", "-z", "+z"))
    edges.box((split - 0.02, split), (UPPER_TOP_Y, FOOT_Y), (CLEAR, STOREY), without=("-x", "-y", "+y", "-z", "+z"))
    slab.add(under).add(edges)
    link = part().visual(write_mesh(top, "office_upper_floor", folder), VINYL)
    link.visual(write_mesh(under, "office_ceiling", folder), CEILING)
    link.visual(write_mesh(edges, "office_slab_edge", folder), CONCRETE)
    link.collision(write_mesh(top, "office_upper_floor", folder))
    link.collision(write_mesh(slab, "office_slab_bump", folder), proxy="bump")
    yard.model("office_ground_floor", ground)
    yard.model("office_upper_floor", link)


def roof(yard, folder):
    room = Assembly()
    middle = ((WEST + EAST) / 2, (SOUTH + NORTH) / 2, ROOF_Z + 0.15)
    link = part().visual(box(EAST - WEST + OUTER, NORTH - SOUTH + OUTER, 0.30), CONCRETE_DARK, middle)
    link.collision(box(EAST - WEST + OUTER, NORTH - SOUTH + OUTER, 0.30), middle, proxy="bump")
    ceiling = room.of(CEILING)
    ceiling.face((WEST, SOUTH, ROOF_Z - 0.003), (WEST, NORTH, ROOF_Z - 0.003), (EAST, NORTH, ROOF_Z - 0.003),
                 (EAST, SOUTH, ROOF_Z - 0.003))
    low, high = PARAPET, PARAPET + 0.06
    x0, x1, y0, y1 = WEST - OUTER, EAST + OUTER, SOUTH - OUTER, NORTH + OUTER
    for x, y in (((x0 - 0.04, x1 + 0.04), (y0 - 0.04, y0 + 0.22)), ((x0 - 0.04, x1 + 0.04), (y1 - 0.22, y1 + 0.04)),
                 ((x0 - 0.04, x0 + 0.22), (y0 + 0.22, y1 - 0.22)), ((x1 - 0.22, x1 + 0.04), (y0 + 0.22, y1 - 0.22))):
        room.show(METAL, x, y, (low, high))
    for x, y in ((-5.5, 9), (-3.2, 9), (5, 12)):
        room.show(LAMINATE, (x, x + 1.6), (y, y + 1.2), (ROOF_Z + 0.3, ROOF_Z + 1.6))
        room.round(GREY, (x + 0.8, y + 0.6), 0.45, (ROOF_Z + 1.6, ROOF_Z + 1.75), 12)
    room.show(PLASTER, (-0.9, 2.0), (14.6, 18.6), (ROOF_Z + 0.3, ROOF_Z + 1.5))
    # A band between the storeys all round, and a plinth.
    for z, proud, look in (((2.62, 2.92), 0.03, CONCRETE), ((0.0, 0.35), 0.025, CONCRETE_DARK)):
        doors = ((x0 - proud, -ENTRANCE / 2 - 0.06), (ENTRANCE / 2 + 0.06, x1 + proud)) if z[0] == 0 else ((x0 - proud, x1 + proud),)
        if z[0] == 0:
            doors = ((x0 - proud, -3.8), (-1.4, -ENTRANCE / 2 - 0.06), (ENTRANCE / 2 + 0.06, 1.4), (3.8, x1 + proud))
        for span in doors:
            room.show(look, span, (y0 - proud, y0), z, without=("+y",))
        room.show(look, (x0 - proud, x1 + proud), (y1, y1 + proud), z, without=("-y",))
        room.show(look, (x0 - proud, x0), (y0, y1), z, without=("+x",))
        room.show(look, (x1, x1 + proud), (y0, y1), z, without=("-x",))
    room.seen_by(link, "office_roof", folder)
    yard.model("office_roof", link)


def canopy():
    """Over the entrance, on two columns; the street number, and the company's board."""
    room = Assembly().show(METAL, (-2.4, 2.4), (1.0, 3.0), (2.62, 2.80))
    room.show(LAMINATE, (-2.3, 2.3), (1.1, 3.0), (2.60, 2.62))
    for x in (-2.2, 2.2):
        room.round(STEEL, (x, 1.2), 0.07, (0, 2.62), 12, met=True)
    room.show(BLUE, (-2.2, 2.2), (2.93, 3.0), (3.05, 3.65), without=("+y",))
    write_text("2006", (0, 2.93, 3.35), 0.36, 0.06, room.of(WHITE))
    room.show(BLACK, (1.15, 1.32), (2.96, 3.0), (1.25, 1.60), without=("+y",))
    return room
