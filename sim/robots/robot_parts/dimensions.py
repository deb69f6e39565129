"""Lengths of the robot [m], and the directions that its parts are turned to."""

AXLE_Y, AXLE_Z, TRACK_X = 0.375, 0.20, 0.30
MAIN_WHEEL = 0.15
FLIPPER, WHEEL = 0.40, 0.10
BIG_ARM, SMALL_ARM = 0.75, 0.65
BEAM_Y, FINGER, PAD_DEPTH = 0.15, 0.16, 0.005

AXES = {"+X": (1, 0, 0), "-X": (-1, 0, 0), "+Y": (0, 1, 0), "-Y": (0, -1, 0), "+Z": (0, 0, 1),
        "-Z": (0, 0, -1)}
ALONG_X = (0, 90, 0)  # turns a cylinder's axis from Z to X
ALONG_Y = (90, 0, 0)
