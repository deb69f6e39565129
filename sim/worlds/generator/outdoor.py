"""Module 4, outdoor: a street with a market and parked cars, a builders' yard, and rolling meadows.

The street runs north from y = -60 to y = 240, its middle at x = 0. Carriageway |x| < 3.5, level at z = 0; pavements
from there to the house fronts at |x| = 6, 0.15 high. CLAMP has a lead-in of 0.2 m along the kerbs. In local metres:

    where            model             what
    0, 0             outdoor_start     start pad, heading 0 along the street
    +-4.75, y        pavements         kerb 0.15; none at the square (west, y 20..50) and the lane (east, y 84..90)
    0, 60..64        street            zebra crossing; kerbs dropped on both sides: 0.15 over 1.2 m, from x = +-3.5
    -2.6, 48         cover_wall        blocks 3.6 x 0.6 x 1.6 m across the west half: cover, 102 m from the parked car
    -12, 35          (square)          market square, x -20..-3.5, y 20..50, level with the street
    -9.5, 30.5       stall_fruit       table 2.4 x 0.7 m, top 0.75; its front looks east: approach with heading 90
    -9.5, 40         stall_bread       the same; charge_bag on it
    -9.5, 45         stall_cheese      the same
    -9.43, 40        charge_bag        charge S on the table, axis 0.28 behind its edge; nothing within 0.45 m beside it
    -12.5, 25.2      fountain          basin 3 m across
    2.45, 29         car_silver        4.30 x 1.78 x 1.44 m, heading 0
    5.15, 75         bus_shelter       on the pavement, 4.0 x 1.4 x 2.5 m, open towards the street; bench 0.45
    5.0, 72.3        holdall           a bag beside it; nothing in it
    -2.35, 108       van               5.20 x 2.00 x 2.45 m, heading 180
    2.45, 152.15     parked_car        heading 0, its rear at y = 150; clearance 0.18, its rear edge 0.30 high;
                                       boot open: sill 0.70, floor 0.60, 1.10 wide, 0.85 deep
    2.45, 149.85     charge_car        charge M standing free on the road, axis 0.15 before the car's rear: heading 0
    -1, 164          can_outdoor       drum on level asphalt, 12.3 m from the parked car: approach with heading 0
    -2.45, 190       car_red           heading 180
    0, 246           church            at the street's end
    38, 87           (lane)            x 3.5..72, y 84..90, to the builders' yard, x 18..72, y 90..114

Stations of the yard, all approached with heading 0, begin at y = 96 (mark lines at 94.5):

    22               gravel_strip      3 x 12 m, heaps up to 0.06
    28               pitch_roll_field  2.36 x 6.5 m: half ramps, 0.17 over 0.59 up and down, right track a tile later
    34               outdoor_stepfield 3 x 1.2 m of posts 0.1 m square, 0..0.30; CLAMP is the skin over them
    40               drain_ditch       0.60 wide, 0.30 deep, 4 m long across the way
    46               loading_dock      ramp 2.6 x 6 m to a platform 1.0 high, 12 x 4 m, before the hall at y = 106
    66               bank_20           3 m up at 20 deg, 2 m level, 3 m down

Meadows: path x -60..-20, y 33.5..36.5; relief from (-160, -10), 100 x 120 m, level along its border (relief.py).
"""

import random

from .countryside import bush, church, cover_wall, hedge, hills, low_wall, placed, quarter_of_woods, tree
from .gathered import Gathered, at
from .houses import FLOOR, terrace, terrace_width
from .market import STALLS, TABLE_TOP, empty_crates, fountain, stall
from .module import Module
from .movables import carton, charge, loose_cone, wheeled_bin
from .relief import DEPTH, WIDTH, relief, relief_height
from .scenery import Scenery, start_frame
from .slope import inclined_plane
from .street import (HALF_WIDTH, KERB, LANE, NORTH, PAVEMENT, SOUTH, SQUARE, ZEBRA, all_pavements, pavements, road)
from .street_furniture import (barrier, bench, bollard, bus_shelter, bus_stop, holdall, lamp_post, postbox, road_sign)
from .surfaces import (ASPHALT, CAR_BLUE, CAR_RED, CAR_SILVER, COBBLES, EARTH, GRASS, GRAVEL, GREEN, WHITE)
from .vehicles import car, van
from .vessels import DRUM, drum
from .works_yard import (DITCH_LENGTH, DITCH_WIDTH, barrels, board_fence, container, course_markings, drain_ditch,
                         gravel_strip,
                         hall, loading_dock, pallets, pitch_roll_field, step_field)
from .zones import level_ground

HALF = 250
SQUARE_X, LANE_X = (-20, -HALF_WIDTH), (HALF_WIDTH, 72)
YARD = ((18, 72), (90, 114))
COURSE = 96  # y where the stations of the yard begin
DITCH_X = 40
STATIONS = ((22, "GRAVEL"), (28, "ROLL"), (34, "STEPS"), (DITCH_X, "DITCH"), (46, "DOCK"), (66, "20"))
RELIEF = (-160, -10)  # south-west corner
PATH = ((RELIEF[0] + WIDTH, SQUARE_X[0]), (33.5, 36.5))
CAR, CAN = (2.45, 152.15), (-1.0, 164.0)
CHARGE_CAR, CHARGE_BAG = (2.45, 149.85), (-9.43, 40.0)
STALL_X, STALL_Y = -9.5, (30.5, 40.0, 45.0)
COVER = (-2.6, 48.0)
SECTIONS = tuple(range(SOUTH, NORTH + 1, 30))
# First y, a multiple of the bay, and its houses from left to right: bays, storeys, colour, shop or number.
WEST = ((-57, ((3, 2, "cream", "2"), (2, 3, "rose", "4"), (4, 2, "white", "TOYS"))),
        (-27, ((2, 3, "rose", "8"), (4, 3, "ochre", "BICYCLES"), (3, 2, "white", "12"))),
        (3, ((2, 2, "rose", "14"), (3, 3, "cream", "CAFE"))),
        (51, ((4, 3, "rose", "BOOKS"), (2, 2, "white", "20"), (3, 3, "cream", "FLOWERS"))),
        (81, ((3, 2, "ochre", "24"), (3, 3, "cream", "SHOES"), (3, 2, "sage", "28"))),
        (111, ((4, 3, "white", "HOTEL"), (2, 3, "clay", "32"), (3, 2, "cream", "34"))),
        (141, ((3, 3, "white", "TAILOR"), (3, 2, "rose", "38"), (3, 3, "ochre", "OPTICIAN"))),
        (171, ((2, 2, "cream", "42"), (4, 3, "sky", "MUSIC"), (3, 2, "white", "46"))),
        (201, ((3, 3, "cream", "48"), (3, 2, "sky", "50"), (3, 3, "rose", "52"))))
EAST = ((-57, ((3, 3, "ochre", "1"), (3, 2, "rose", "3"), (3, 3, "cream", "5"))),
        (-27, ((4, 2, "white", "PHARMACY"), (2, 3, "ochre", "9"), (3, 3, "cream", "11"))),
        (3, ((3, 3, "ochre", "BAKERY"), (3, 2, "cream", "15"), (3, 3, "rose", "BANK"))),
        (33, ((2, 2, "ochre", "19"), (4, 3, "white", "BUTCHER"), (3, 2, "cream", "23"))),
        (66, ((2, 3, "cream", "25"), (3, 2, "clay", "POST"))),
        (93, ((3, 3, "sage", "29"), (3, 2, "white", "31"), (3, 3, "clay", "WINE"))),
        (123, ((3, 2, "cream", "35"), (4, 3, "rose", "RADIO"), (2, 2, "ochre", "39"))),
        (153, ((3, 3, "white", "41"), (3, 3, "rose", "TEA"), (3, 2, "ochre", "45"))),
        (183, ((4, 3, "cream", "KEYS"), (2, 2, "rose", "49"), (3, 3, "white", "51"))),
        (213, ((3, 2, "sky", "53"), (3, 3, "white", "55"), (3, 2, "cream", "57"))))
SQUARE_HOUSES = ((21, ((2, 3, "ochre", "INN"), (2, 2, "white", "5"))), (39, ((4, 3, "rose", "TOWN HALL"),)))
GARDEN_WALLS = ((-6.3, -30, -27), (-6.3, 78, 81), (-6.3, 108, 111), (-6.3, 138, 141), (-6.3, 168, 171),
                (-6.3, 198, 201),
                (6.3, -30, -27), (6.3, 0, 3), (6.3, 30, 33), (6.3, 60, 66), (6.3, 120, 123), (6.3, 150, 153), (6.3, 180,
                                                                                                               183),
                (6.3, 210, 213))
BOLLARDS = ((-3.8, 21.2, 0), (-3.8, 24.0, 0), (-3.8, 26.8, 0), (-3.8, 43.2, 0), (-3.8, 46.0, 0), (-3.8, 49.0, 0),
            (4.0, 84.4, 0),
            (4.0, 89.6, 0), (-3.9, 65.0, KERB), (3.9, 65.0, KERB), (-3.9, 59.0, KERB), (3.9, 59.0, KERB), (-6.0, 241.5,
                                                                                                           0),
            (-3.0, 241.5, 0), (3.0, 241.5, 0), (6.0, 241.5, 0))
FENCES = ((18, 102, 22, 90), (24.5, 113, 13, 0), (72, 102, 22, 90), (66.5, 113, 11, 0),
          (40, 83.4, 56, 0))  # middle, length, heading
HEDGES = ((-42, 38.6, 30, 0), (-42, 31.4, 30, 0), (-40, 8, 40, 90), (-40, 62, 40, 90), (20, 60, 40, 90),
          (17, -30, 50, 90),
          (-20, 130, 60, 90), (18, 150, 60, 90))
BUSHES = ((-64, 30), (-78, 48), (-104, 32), (-121, 64), (-90, 80), (-27, 29), (14, -3), (30, 74))
TREES = (((-10, -28.5), (10, -28.5)), ((-17.5, 28), (-17.5, 43.5)), ((-10, 79.5), (-10, 109.5), (10, 121.5)),
         ((-10, 139.5), (10, 151.5), (-10, 169.5), (10, 181.5)), ((-14, 244), (14, 244)),
         ((-30, 45), (-28, 24), (-72, 14), (-95, 60), (-130, 24)), ((-110, 95), (-84, 100), (-148, 70), (30, 60)))


def ground():
    """Level but for the pavements, the drain and the relief."""
    ditch = ((DITCH_X - DITCH_LENGTH / 2, DITCH_X + DITCH_LENGTH / 2), (COURSE, COURSE + DITCH_WIDTH))
    holes = [ditch, ((RELIEF[0], RELIEF[0] + WIDTH), (RELIEF[1], RELIEF[1] + DEPTH))]
    holes += [(tuple(sorted((side * HALF_WIDTH, side * PAVEMENT))), y) for side, y in pavements()]
    holes += [(tuple(sorted((side * HALF_WIDTH, side * PAVEMENT))), ZEBRA) for side in (-1, 1)]
    road_x = (-HALF_WIDTH, HALF_WIDTH)
    zones = [("road", None, road_x, (SOUTH, NORTH)), ("asphalt", ASPHALT, LANE_X, LANE),
             ("asphalt", ASPHALT, road_x, (-HALF, SOUTH)),
             ("cobbles", COBBLES, SQUARE_X, SQUARE), ("cobbles", COBBLES, (-12, 12), (NORTH, HALF)), ("earth", EARTH,
                                                                                                      *YARD),
             ("gravel", GRAVEL, *PATH)]
    return level_ground(((-HALF, HALF), (-HALF, HALF)), zones, holes, GRASS, 372)


def town(yard, folder):
    """The rows of houses in sections, each with both sides of the street. Their frame lies along it: X
    north, Y west, so that the courses of all roofs run along the street too."""
    for i, (low, high) in enumerate(zip(SECTIONS, SECTIONS[1:])):
        section, middle = Gathered(), (low + high) / 2
        for first, houses in WEST:
            if low <= first < high:
                section.add(terrace(houses, 200 + first), at(first - middle, PAVEMENT))
        for first, houses in EAST:
            if low <= first < high:
                section.add(terrace(houses, 400 + first), at(first + terrace_width(houses) - middle, -PAVEMENT, 0, 180))
        for first, houses in SQUARE_HOUSES:
            if low <= first < high:
                section.add(terrace(houses, 600 + first), at(first - middle, -SQUARE_X[0] + 0.8))
        section.stand(yard, f"houses_{i + 1}", folder, (0, middle, KERB + FLOOR), 90)
    church().stand(yard, "church", folder, (0, 246, 0))
    walls = [(low_wall(high - low), x, (low + high) / 2, 0, 90) for x, low, high in GARDEN_WALLS]
    placed(walls).stand_about(yard, "garden_walls", folder, (0, -110))


def street(yard, folder):
    road().stand_about(yard, "street", folder, (0, -80))
    all_pavements().stand_about(yard, "pavements", folder, (0, -95))
    pad = Scenery("outdoor_start", folder)
    start_frame(pad)
    yard.model("outdoor_start", pad.link())
    lamps = [(lamp_post(), side * 3.95, y, 0 if y == 45 else KERB, 0 if side > 0 else 180)
             for side, y in ((1 if k % 2 else -1, -45 + 30 * k) for k in range(10))]
    for name, half in (("street_lamps_south", lamps[:5]), ("street_lamps_north", lamps[5:])):
        placed(half).stand_about(yard, name, folder, (0, -140 if half == lamps[:5] else -155))
    posts = [(bollard(), x, y, z, 0) for x, y, z in BOLLARDS]
    placed(posts).stand_about(yard, "bollards", folder, (0, 50))
    signs = [(road_sign(kind), 3.9, y, KERB, 0) for kind,
             y in (("crossing", 54), ("slow", -20), ("parking", 142.5), ("stop", 82.5))]
    placed(signs).stand_about(yard, "road_signs", folder, (0, -125))
    benches = [(bench(), *spot) for spot in ((-5.5, 10, KERB, 90), (-16.5, 22, 0, 180), (5.5, 110, KERB, -90),
                                             (-14, 48.6, 0, 0))]
    placed(benches).stand_about(yard, "street_benches", folder, (-10, 40))
    blocks = [(barrier(), x, -56, 0, turn) for x, turn in ((-1.8, 4), (1.8, -4))]
    placed(blocks).stand_about(yard, "road_block", folder, (0, -56))
    for name, thing, x, y, turn in (("bus_shelter", bus_shelter(), 5.15, 75, -90),
                                    ("bus_stop", bus_stop(), 3.85, 71.5, 0),
                                    ("holdall", holdall(), 5.0, 72.3, 20), ("postbox", postbox(), 5.4, 64.8, -90)):
        thing.stand(yard, name, folder, (x, y, KERB), turn)
    cover_wall().stand(yard, "cover_wall", folder, (*COVER, 0))


def market(yard, folder):
    for (name, cloth, title, goods), y in zip(STALLS, STALL_Y):
        free = 0.45 if y == CHARGE_BAG[1] else 0.0
        stall(cloth, title, goods, free).stand(yard, name, folder, (STALL_X, y, 0), 90)
    empty_crates().stand(yard, "empty_crates", folder, (-11.6, 31.6, 0), 80)
    fountain().stand(yard, "fountain", folder, (-12.5, 25.2, 0))


def vehicles(yard, folder):
    for name, thing, x, y, turn in (("parked_car", car(CAR_BLUE, "EOD 44", open_boot=True), *CAR, 0),
                                    ("car_silver", car(CAR_SILVER, "TR 901"), 2.45, 29, 0),
                                    ("car_red", car(CAR_RED, "BK 2760"), -2.45, 190, 180),
                                    ("van", van(WHITE, "PK 518"), -2.35, 108, 180)):
        thing.stand(yard, name, folder, (x, y, 0), turn)


def builders_yard(yard, folder):
    links = (gravel_strip(folder), pitch_roll_field(folder), step_field(folder), drain_ditch(folder),
             loading_dock().link("loading_dock", folder), inclined_plane(20))
    names = ("gravel_strip", "pitch_roll_field", "outdoor_stepfield", "drain_ditch", "loading_dock", "bank_20")
    for name, link, (x, _) in zip(names, links, STATIONS):
        yard.model(name, link, (x, COURSE, 0))
    course_markings(STATIONS, COURSE).stand_about(yard, "yard_markings", folder, (44, 94))
    hall().stand(yard, "hall", folder, (46, COURSE + 10, 0))
    fences = [(board_fence(length), x, y, 0, turn) for x, y, length, turn in FENCES]
    placed(fences).stand_about(yard, "board_fences", folder, (44, 100))
    for name, thing, x, y, turn in (("yard_container", container(), 68.4, 109.5, 0),
                                    ("yard_pallets", pallets(), 36.8, 103.5, 12),
                                    ("yard_barrels", barrels(), 56.5, 104.8, 0)):
        thing.stand(yard, name, folder, (x, y, 0), turn)


def meadows(yard, folder):
    yard.model("relief", relief(folder), (*RELIEF, 0))
    green = [(hedge(length, 1.3, i), x, y, 0, turn) for i, (x, y, length, turn) in enumerate(HEDGES)]
    green += [(bush(i), x, y, on_relief(x, y) - 0.1, 40 * i) for i, (x, y) in enumerate(BUSHES)]
    for name, side in (("hedges_west", -1), ("hedges_east", 1)):
        placed(thing for thing in green if side * thing[1] > 0).stand_about(yard, name, folder, (side * 40, 40))
    rng = random.Random(4)
    for i, spots in enumerate(TREES):
        grown = [(tree(rng.uniform(1.0, 1.6), rng, 3 if abs(x) < 20 else 2), x, y, on_relief(x, y), 0) for x,
                 y in spots]
        placed(grown).stand_about(yard, f"outdoor_trees_{i + 1}", folder, spots[0])
    for quarter in range(4):
        far = ((260, 0), (0, 260), (-260, 0), (0, -260))[quarter]
        quarter_of_woods(quarter, 254).stand_about(yard, f"outdoor_woods_{quarter + 1}", folder, far)
    hills().stand(yard, "outdoor_hills", folder)


def on_relief(x, y):
    return relief_height(x - RELIEF[0], y - RELIEF[1])


def loose_things(yard, folder):
    x, y = CHARGE_CAR
    yard.movable("charge_car", charge("M", 0.060, 0.240, 3.0, folder), (x, y, 0.12), 0.6, explosive=True)
    x, y = CHARGE_BAG
    yard.movable("charge_bag", charge("S", 0.030, 0.160, 1.0, folder), (x, y, TABLE_TOP + 0.08), 0.6, explosive=True)
    for i, (x, y, z, size) in enumerate(((-11.9, 39.4, 0, (0.45, 0.35, 0.30, 2.0)),
                                         (5.3, 106.5, KERB, (0.50, 0.35, 0.30, 2.5)))):
        yard.movable(f"outdoor_carton_{i + 1}", carton(*size), (x, y, z + size[2] / 2), 0.5)
    for i, (x, y) in enumerate(((-1.0, 143.0), (1.6, 158.5))):
        yard.movable(f"outdoor_cone_{i + 1}", loose_cone(), (x, y, 0), 0.7)
    yard.movable("wheeled_bin", wheeled_bin(GREEN), (5.2, 158.0, KERB), 0.6)


def outdoor(folder):
    """Module 4."""
    yard = Module(4, "outdoor", (-900, -900, 0), (2 * HALF, 2 * HALF))
    ground().stand(yard, "outdoor_ground", folder)
    for build in (street, town, market, vehicles, builders_yard, meadows, loose_things):
        build(yard, folder)
    yard.vessel("can_outdoor", drum(folder), (*CAN, 0), DRUM)
    return yard
