"""The office building's lengths [m], in the module's frame: what its walls, stairs and rooms share."""

STOREY, CLEAR = 2.97, 2.67  # floor to floor: 2 x 9 x 0.165; floor to ceiling, slab 0.30
PARTITION, OUTER = 0.15, 0.30
WEST, EAST, SOUTH, NORTH = -9.0, 9.0, 3.3, 18.64  # inner faces of the outer walls
PARAPET = 6.40

# What the robot drives on: x = 0 up to the landing, x = 1.08 from there. Each turn on the spot needs a
# circle of 0.63 m, so the way lies 0.06 m off the middle of what is 1.2 m wide.
LOBBY_X, ROOMS_Y = (-4.2, 4.2), (8.65, 12.85)
LOBBY_Y = (SOUTH, 8.5)
CORRIDOR_X, UPPER_CORRIDOR_X = (-0.66, 0.54), (0.54, 1.74)
HALL_Y = (13.0, 15.2)
STAIR_X = (-0.66, 1.74)
FLIGHT_WIDTH, WELL = 1.15, 0.10
STEPS, RISE, RUN = 9, 0.165, 0.28
FOOT_Y = HALL_Y[1]  # first riser
LANDING_Y = (FOOT_Y + (STEPS - 1) * RUN, NORTH)
# The upper flight begins a tread later: at its foot the robot's corners need that room to turn.
UPPER_FOOT_Y = LANDING_Y[0] - RUN
UPPER_TOP_Y = UPPER_FOOT_Y - (STEPS - 1) * RUN
SERVER_X, SERVER_Y = (0.69, 6.3), (9.05, 12.55)
SERVER_DOOR_Y, MEETING_DOOR_Y, OFFICE_101_DOOR_Y = 10.8, 11.2, 4.6
HALL_DOOR_Y = 14.0
OFFICE_201_DOOR_Y, OFFICE_202_DOOR_Y, OFFICE_203_DOOR_Y = 10.9, 6.0, 10.0
ENTRANCE = 1.80  # clear width

# Windows: middle along the wall, width, sill, head.
SOUTH_WINDOWS = ((-7.5, 1.8, 0.90, 2.30), (-5.6, 1.6, 0.90, 2.30), (-2.6, 2.4, 0.30, 2.40), (2.6, 2.4, 0.30, 2.40),
                 (-7.5, 1.8, 3.87, 5.27), (-4.5, 1.8, 3.87, 5.27), (-1.5, 1.8, 3.87, 5.27), (2.4, 2.4, 3.87, 5.27))
WEST_WINDOWS = ((5.9, 2.4, 0.90, 2.30), (10.75, 2.4, 0.90, 2.30), (5.9, 2.4, 3.87, 5.27), (10.75, 2.4, 3.87, 5.27))
EAST_WINDOWS = ((10.75, 2.4, 3.87, 5.27),)
NORTH_WINDOWS = ((0.54, 1.2, 3.10, 4.50),)
# Before rooms that nobody enters: dark panes.
BLIND_SOUTH = ((5.6, 1.6, 0.90, 2.30), (7.7, 1.6, 0.90, 2.30), (5.6, 1.6, 3.87, 5.27), (7.7, 1.6, 3.87, 5.27))
BLIND_SIDE = ((15.8, 2.4, 0.90, 2.30), (15.8, 2.4, 3.87, 5.27))
BLIND_EAST = ((5.9, 2.4, 0.90, 2.30), (10.75, 2.4, 0.90, 2.30), (5.9, 2.4, 3.87, 5.27))
BLIND_NORTH = tuple((x, 1.8, sill, sill + 1.4) for sill in (0.90, 3.87) for x in (-6.8, -3.2, 4.2, 7.2))
