"""The office's rooms, storey by storey: walls, doors, floors, furniture, lamps."""

from .assembly import Assembly
from .building_services import (ceiling_lamp, clock, exit_sign, extinguisher, lift_door, point_light, radiator,
                                room_plate)
from .office_furniture import (bookshelf, cabinet, conference_table, desk, drawer_unit, low_table, notice_board,
                               office_chair, plant, printer, reception_desk, server_rack, sofa, visitor_chair,
                               wall_screen, whiteboard)
from .office_plan import (CLEAR, CORRIDOR_X, EAST, FOOT_Y, HALL_DOOR_Y, HALL_Y, LOBBY_X, LOBBY_Y, MEETING_DOOR_Y, NORTH,
                          OFFICE_101_DOOR_Y, OFFICE_201_DOOR_Y, OFFICE_202_DOOR_Y, OFFICE_203_DOOR_Y, PARTITION,
                          ROOMS_Y, SERVER_DOOR_Y, SERVER_X, SERVER_Y, SOUTH, STAIR_X, STOREY, UPPER_CORRIDOR_X, UPPER_TOP_Y,
                          WEST)
from .surfaces import (CARPET_BLUE, CARPET_GREY, CHAIR_BLUE, CONCRETE_DARK, FLOOR_TILE, GREY, PLASTER, PLASTER_BLUE)
from .walls import door_frame, door_leaf, doorway, wall

CORRIDOR_OPENING = (*CORRIDOR_X, 0.0, 2.40)


class Room:
    """Furniture in the module's frame, posed at the room's middle so that pictures cull it as a whole."""

    def __init__(self, name, x, y, storey, floor=None):
        self.name, self.z = name, storey * STOREY
        self.middle = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, self.z)
        self.things, self.lights = Assembly(), []
        if floor:
            self.things.pave(floor, self._from(x, 0), self._from(y, 1), 0.004)

    def _from(self, pair, axis):
        return tuple(c - self.middle[axis] for c in pair)

    def put(self, thing, x, y, heading=0, z=0.0):
        """`x`, `y`: in the module's frame; z above the room's floor."""
        self.things.put(thing, (x - self.middle[0], y - self.middle[1], z), heading)
        return self

    def lamp(self, x, y, heading=0, reach=9, lit=True):
        self.put(ceiling_lamp(CLEAR), x, y, heading)
        if lit:
            self.lights.append(((x, y, self.z + CLEAR - 0.12), reach))
        return self

    def door(self, x, y, along, thickness=PARTITION):
        return self.put(door_frame(thickness), x, y, 0 if along == "x" else 90)

    def build(self, yard, folder):
        yard.model(self.name, self.things.link(self.name, folder, shadow=False), self.middle)
        for i, (at, reach) in enumerate(self.lights):
            yard.lights += point_light(f"{self.name}_lamp_{i + 1}", yard.name, at, reach)


def ground_walls():
    walls, z = Assembly(), (0.0, CLEAR)
    (x0, x1), (y0, y1) = CORRIDOR_X, ROOMS_Y
    both = (-1, 1)
    wall(walls, PLASTER, "x", (8.5, 8.65), (WEST, 6.45), z, [CORRIDOR_OPENING], both)
    wall(walls, PLASTER, "y", (LOBBY_X[0] - PARTITION, LOBBY_X[0]), LOBBY_Y, z, [doorway(OFFICE_101_DOOR_Y)], both)
    wall(walls, PLASTER_BLUE, "y", (LOBBY_X[1], LOBBY_X[1] + PARTITION), LOBBY_Y, z, (), (-1,))
    wall(walls, PLASTER, "y", (x0 - PARTITION, x0), (8.65, FOOT_Y), z,
         [doorway(MEETING_DOOR_Y), doorway(HALL_DOOR_Y)], both)
    wall(walls, PLASTER, "y", (x1, x1 + PARTITION), (8.65, HALL_Y[0]), z, [doorway(SERVER_DOOR_Y)], both)
    wall(walls, PLASTER, "x", (y1, HALL_Y[0]), (x1 + PARTITION, STAIR_X[1]), z, (), (1,))
    wall(walls, PLASTER, "y", (STAIR_X[1], STAIR_X[1] + PARTITION), (y1, UPPER_TOP_Y), z, [doorway(HALL_DOOR_Y)], (-1,))
    # Beside the stairs, through both storeys.
    wall(walls, PLASTER, "y", (x0 - PARTITION, x0), (FOOT_Y, NORTH), (0.0, STOREY + CLEAR))
    wall(walls, PLASTER, "y", (STAIR_X[1], STAIR_X[1] + PARTITION), (UPPER_TOP_Y, NORTH), (0.0, STOREY + CLEAR))
    wall(walls, PLASTER, "x", (y1, HALL_Y[0]), (WEST, x0 - PARTITION), z, (), (-1,))
    wall(walls, PLASTER, "x", (SERVER_Y[0] - PARTITION, SERVER_Y[0]), (SERVER_X[0], 6.45), z, (), (1,))
    wall(walls, PLASTER, "x", (SERVER_Y[1], SERVER_Y[1] + PARTITION), (SERVER_X[0], 6.45), z, (), (-1,))
    wall(walls, PLASTER, "y", (SERVER_X[1], SERVER_X[1] + PARTITION), SERVER_Y, z, (), (-1,))
    return walls


def upper_walls():
    walls, z = Assembly(), (STOREY, STOREY + CLEAR)
    (x0, x1), (y0, y1) = UPPER_CORRIDOR_X, ROOMS_Y
    both = (-1, 1)
    wall(walls, PLASTER, "y", (x1, x1 + PARTITION), (8.65, UPPER_TOP_Y), z,
         [doorway(OFFICE_203_DOOR_Y), doorway(HALL_DOOR_Y)], both)
    wall(walls, PLASTER, "y", (x0 - PARTITION, x0), (SOUTH, y1), z,
         [doorway(OFFICE_202_DOOR_Y), doorway(OFFICE_201_DOOR_Y)], both)
    wall(walls, PLASTER, "x", (y1, HALL_Y[0]), (WEST, x0), z, (), both)
    wall(walls, PLASTER, "y", (STAIR_X[0] - PARTITION, STAIR_X[0]), (HALL_Y[0], FOOT_Y), z, (), (1,))
    wall(walls, PLASTER, "x", (8.5, 8.65), (WEST, x0 - PARTITION), z, (), both)
    wall(walls, PLASTER_BLUE, "x", (8.5, 8.65), (x1, EAST), z, (), both)
    wall(walls, PLASTER, "x", (y1, HALL_Y[0]), (x1 + PARTITION, EAST), z, (), (-1,))
    wall(walls, PLASTER_BLUE, "y", (LOBBY_X[1], LOBBY_X[1] + PARTITION), LOBBY_Y, z, (), (-1,))
    return walls


def lobby():
    room = Room("lobby", LOBBY_X, LOBBY_Y, 0, FLOOR_TILE)
    room.put(reception_desk(), -2.55, 6.0, 55).put(office_chair(), -3.25, 6.75, 225)
    room.put(cabinet(1.0, 0.80), -3.4, 8.27).put(notice_board(), -2.2, 8.5).put(clock(), -3.4, 8.5)
    for y in (5.7, 7.4):
        room.put(lift_door(), LOBBY_X[1], y, 270)
    room.put(sofa(), 3.0, 3.85, 180).put(low_table(), 3.0, 4.75).put(plant(1.7, 3), 1.55, 3.65)
    room.put(plant(1.5, 4), 3.85, 8.1).put(plant(1.4, 5), -3.85, 3.7)
    room.put(extinguisher(), 1.0, 8.5).put(exit_sign(), -0.06, 8.46)
    room.put(exit_sign(), 0, 3.36, 180).put(room_plate(), LOBBY_X[0], OFFICE_101_DOOR_Y + 0.75, 90)
    room.put(wall_screen(1.2), 2.4, 8.5).door(LOBBY_X[0] - PARTITION / 2, OFFICE_101_DOOR_Y, "y")
    room.put(door_leaf(), LOBBY_X[0] - PARTITION, OFFICE_101_DOOR_Y + 0.45, 172)
    for x in (-2.4, 2.4):
        room.lamp(x, 5.9, 90, 10)
    return room.lamp(0, 4.6, 0, 10, lit=False).lamp(0, 7.4, 0, 10, lit=False)


def corridor():
    x0, x1 = CORRIDOR_X
    room = Room("corridor_1", CORRIDOR_X, (8.5, HALL_Y[0]), 0)
    room.door(x0 - PARTITION / 2, MEETING_DOOR_Y, "y").door(x1 + PARTITION / 2, SERVER_DOOR_Y, "y")
    # Half open into the meeting room, hinged on its north jamb.
    room.put(door_leaf(), x0 - PARTITION, MEETING_DOOR_Y + 0.45, 225)
    # Open at a right angle into the server room: beside the aisle.
    room.put(door_leaf(GREY, window=True), x1 + PARTITION, SERVER_DOOR_Y + 0.45 + 0.045, 0)
    for y, x, heading in ((MEETING_DOOR_Y - 0.75, x0, 90), (SERVER_DOOR_Y - 0.75, x1, 270)):
        room.put(room_plate(), x, y, heading)
    room.put(notice_board(), x1, 12.1, 270)
    for y, lit in ((9.4, True), (11.9, True)):
        room.lamp(-0.06, y, 90, 7, lit)
    return room


def stair_hall():
    x0, x1 = STAIR_X
    room = Room("stair_hall", STAIR_X, (HALL_Y[0], NORTH), 0)
    for x, face, heading, hinge in ((x0 - PARTITION / 2, x0, 90, 0.45), (x1 + PARTITION / 2, x1, 270, -0.45)):
        room.door(x, HALL_DOOR_Y, "y").put(room_plate(), face, HALL_DOOR_Y + 0.75 * (1 if hinge < 0 else -1), heading)
        # Closed: lever doors to the plant room and to the toilets.
        room.put(door_leaf(), x + (0.02 if hinge > 0 else -0.02), HALL_DOOR_Y + hinge, 270 if hinge > 0 else 90)
    room.put(extinguisher(), 1.20, HALL_Y[0], 180).put(exit_sign(both_sides=True), -0.06, HALL_Y[0] + 0.05, 180)
    return room.lamp(0.54, 14.1, 0, 8)


def meeting_room():
    room = Room("meeting_room", (WEST, CORRIDOR_X[0] - PARTITION), ROOMS_Y, 0, CARPET_GREY)
    room.put(conference_table(), -5.2, 10.75)
    for i in range(4):
        room.put(visitor_chair(), -6.5 + 0.85 * i, 9.85, 0 if i != 2 else 12)
        room.put(visitor_chair(), -6.5 + 0.85 * i, 11.65, 180)
    room.put(visitor_chair(), -7.4, 10.75, 270)
    room.put(whiteboard(2.4), -5.2, 12.85).put(wall_screen(1.6), -3.0, 8.65, 180)
    room.put(cabinet(1.2, 0.85), -6.6, 8.87, 180).put(cabinet(1.2, 0.85), -5.3, 8.87, 180)
    room.put(plant(1.6, 7), -8.6, 12.45).put(radiator(1.8), WEST, 10.75, 90)
    room.put(notice_board(), -2.2, 12.85)
    return room.lamp(-6.6, 10.75, 0, 8).lamp(-3.6, 10.75, 0, 8).lamp(-1.6, 10.75, 90, 8, lit=False)


def server_room():
    (x0, _), (y0, y1) = SERVER_X, SERVER_Y
    room = Room("server_room", SERVER_X, SERVER_Y, 0, CONCRETE_DARK)
    for row in (-1, 1):
        for i in range(6):
            room.put(server_rack(), x0 + 1.35 + 0.61 * i, SERVER_DOOR_Y + row * (0.45 + 0.50))
    room.things.show(GREY, (-1.9, 2.3), (-0.10, 0.10), (2.25, 2.31)).show(GREY, (-1.9, 2.3), (-1.0, -0.8), (2.25, 2.31))
    room.put(extinguisher(), SERVER_X[1], y1 - 0.5, 270)
    return room.lamp(2.2, SERVER_DOOR_Y, 0, 7).lamp(4.8, SERVER_DOOR_Y, 0, 7)


def office_101():
    room = Room("office_101", (WEST, LOBBY_X[0] - PARTITION), LOBBY_Y, 0, CARPET_BLUE)
    for i, (x, y, heading) in enumerate(((-8.0, 4.6, 90), (-8.0, 7.0, 90), (-5.9, 7.6, 0))):
        room.put(desk(1.6, 1 + i % 2, (1, -1, 1)[i], i + 20), x, y, heading)
    room.put(office_chair(), -5.85, 6.85, 8)
    room.put(bookshelf(0.9, 5, 21), -4.55, 7.2, 270).put(cabinet(0.8, 1.8), -6.8, 3.53, 180)
    room.put(radiator(1.6), -5.6, SOUTH, 180).put(radiator(1.6), -7.9, SOUTH, 180).put(radiator(1.8), WEST, 5.9, 90)
    return room.put(plant(1.2, 22), -4.75, 8.1).lamp(-6.7, 4.6, 0, 8).lamp(-6.7, 7.0, 0, 8, lit=False)


def office_201():
    room = Room("office_201", (WEST, UPPER_CORRIDOR_X[0] - PARTITION), ROOMS_Y, 1, CARPET_BLUE)
    x0 = UPPER_CORRIDOR_X[0]
    room.door(x0 - PARTITION / 2, OFFICE_201_DOOR_Y, "y")
    room.put(door_leaf(), x0 - PARTITION, OFFICE_201_DOOR_Y + 0.45, 172).put(room_plate(), x0, OFFICE_201_DOOR_Y - 0.75, 90)
    # The charge stands under the first of them, its knee space towards the door.
    for i, (x, y, heading, drawers) in enumerate(((-4.0, 10.9, 90, 0), (-4.85, 10.9, 270, 1), (-8.0, 10.9, 90, 0),
                                                  (-1.6, 12.4, 0, -1), (-3.6, 12.4, 0, 1))):
        room.put(desk(1.6, 1 + i % 2, drawers, i), x, y, heading)
    for x, y, heading in ((-5.7, 10.7, 260), (-3.5, 11.55, 25), (-7.2, 10.9, 100)):
        room.put(office_chair(CHAIR_BLUE), x, y, heading)
    for i in range(4):
        room.put(bookshelf(0.9, 5, i), -1.0 - 0.92 * i, 8.83, 180)
    room.put(whiteboard(1.8), -6.6, 8.65, 180).put(cabinet(0.8, 1.8), -8.0, 8.88, 180).put(printer(), -8.6, 12.45)
    room.put(plant(1.5, 8), -0.1, 9.1).put(plant(1.3, 9), -5.2, 12.4).put(radiator(1.8), WEST, 10.75, 90)
    return room.lamp(-1.6, 10.75, 90, 9).lamp(-4.4, 10.75, 90, 9, lit=False).lamp(-7.2, 10.75, 90, 9)


def office_202():
    room = Room("office_202", (WEST, UPPER_CORRIDOR_X[0] - PARTITION), LOBBY_Y, 1, CARPET_GREY)
    x0 = UPPER_CORRIDOR_X[0]
    room.door(x0 - PARTITION / 2, OFFICE_202_DOOR_Y, "y")
    room.put(door_leaf(), x0 - PARTITION, OFFICE_202_DOOR_Y + 0.45, 172).put(room_plate(), x0, OFFICE_202_DOOR_Y - 0.75, 90)
    for i, x in enumerate((-7.6, -5.5, -3.4)):
        room.put(desk(1.6, 2 - i % 2, (-1) ** i, 30 + i), x, 4.6, 180).put(office_chair(), x + 0.1, 5.35, 170 + 10 * i)
        room.put(desk(1.6, 1 + i % 2, (-1) ** i, 40 + i), x, 7.4, 0).put(office_chair(), x - 0.1, 6.6, 5 * i)
        room.put(radiator(1.6), x + 0.4, SOUTH, 180)
    room.put(bookshelf(0.9, 5, 31), -0.6, 8.33).put(bookshelf(0.9, 5, 32), -1.52, 8.33)
    room.put(cabinet(0.8, 1.1), -0.35, 3.55, 180).put(plant(1.5, 33), -1.2, 3.75)
    return room.lamp(-7.0, 5.95, 0, 9).lamp(-4.3, 5.95, 0, 9, lit=False).lamp(-1.6, 5.95, 0, 9)


def office_203():
    room = Room("office_203", (UPPER_CORRIDOR_X[1] + PARTITION, EAST), ROOMS_Y, 1, CARPET_BLUE)
    x1 = UPPER_CORRIDOR_X[1]
    room.door(x1 + PARTITION / 2, OFFICE_203_DOOR_Y, "y").put(room_plate(), x1, OFFICE_203_DOOR_Y - 0.75, 270)
    room.put(door_leaf(), x1 + PARTITION, OFFICE_203_DOOR_Y - 0.45, 352)
    room.put(desk(1.8, 2, 1, 50), 7.2, 10.4, 270).put(office_chair(), 8.0, 10.4, 85)
    room.put(visitor_chair(), 6.3, 10.0, 270).put(visitor_chair(), 6.3, 10.9, 275)
    room.put(sofa(3), 4.0, 12.4).put(low_table(), 4.0, 11.5).put(bookshelf(0.9, 5, 51), 5.6, 8.83, 180)
    room.put(bookshelf(0.9, 5, 52), 6.52, 8.83, 180).put(plant(1.6, 53), 8.6, 12.45).put(radiator(1.8), EAST, 10.75, 270)
    room.put(whiteboard(1.6), 3.9, 8.65, 180)
    return room.lamp(3.6, 10.75, 90, 9).lamp(6.8, 10.75, 90, 9)


def lift_lobby():
    x0, x1 = UPPER_CORRIDOR_X
    room = Room("lift_lobby_2", (x0, LOBBY_X[1]), LOBBY_Y, 1, FLOOR_TILE)
    for y in (5.7, 7.4):
        room.put(lift_door(), LOBBY_X[1], y, 270)
    room.put(radiator(1.8), 2.4, SOUTH, 180).put(plant(1.6, 61), 3.75, 3.75).put(plant(1.3, 62), 3.8, 8.1)
    room.put(notice_board(), 2.6, 8.5).put(clock(), 3.6, 8.5).put(exit_sign(both_sides=True), 1.14, 8.6)
    return room.lamp(2.4, 5.9, 90, 9)


def upper_corridor():
    x0, x1 = UPPER_CORRIDOR_X
    room = Room("corridor_2", (STAIR_X[0], x1), (8.5, HALL_Y[1]), 1)
    room.put(extinguisher(), 0.0, HALL_Y[0], 180).put(notice_board(), x1, 11.9, 270)
    room.door(x1 + PARTITION / 2, HALL_DOOR_Y, "y").put(door_leaf(), x1 + PARTITION / 2 - 0.02, HALL_DOOR_Y - 0.45, 90)
    room.put(drawer_unit(), -0.38, 13.4, 90)
    return room.lamp(1.14, 10.0, 90, 7).lamp(0.54, 14.0, 0, 8)


def rooms(yard, folder):
    for name, walls in (("ground_walls", ground_walls()), ("upper_walls", upper_walls())):
        yard.model(f"office_{name}", walls.link(f"office_{name}", folder, shadow=False))
    for room in (lobby(), corridor(), stair_hall(), meeting_room(), server_room(), office_101(), office_201(),
                 office_202(), office_203(), lift_lobby(), upper_corridor()):
        room.build(yard, folder)
