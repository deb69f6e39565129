#!/usr/bin/env python3
"""Writes eod_robot.sdf and its meshes: the nine-joint EOD robot.

Frame: X right, Y forward, Z up; origin on the ground under the chassis centre. Metres, kilograms.
Run in any folder: python3 make_robot.py
"""

import math
import pathlib

from sdf_writer import (HEADER, Link, Surface, box, cylinder, element, indent, mesh, numbers, pose,
                        sphere, write_extrusion)

HERE = pathlib.Path(__file__).resolve().parent

OLIVE = Surface((0.19, 0.22, 0.12), "metal", 0.8, 0.15)
OLIVE_DARK = Surface((0.12, 0.14, 0.08), "metal", 0.8, 0.15)
GREY = Surface((0.16, 0.17, 0.18), "metal", 0.5, 0.3)
STEEL = Surface((0.55, 0.56, 0.58), "metal", 0.3, 0.6)
RUBBER = Surface((0.045, 0.045, 0.05), "rubber", 0.08, 0.05)
PAD = Surface((0.10, 0.10, 0.10), "rubber", 0.03, 0.05)
HAZARD = Surface((1.0, 1.0, 1.0), "hazard", 0.16, 0.2)
ORANGE = Surface((0.85, 0.32, 0.03), "plain", 1.0, 0.2)
LENS = Surface((0.02, 0.02, 0.03), "plain", 1.0, 0.9)
LAMP = Surface((1.0, 0.96, 0.80), "plain", 1.0, 0.9)
TAIL_LAMP = Surface((0.75, 0.05, 0.03), "plain", 1.0, 0.6)

AXLE_Y, AXLE_Z, TRACK_X = 0.375, 0.20, 0.30
MAIN_WHEEL = 0.15
FLIPPER, WHEEL = 0.40, 0.10
BIG_ARM, SMALL_ARM = 0.75, 0.65
BEAM_Y, FINGER, PAD_DEPTH = 0.15, 0.16, 0.005

AXES = {"+X": (1, 0, 0), "-X": (-1, 0, 0), "+Y": (0, 1, 0), "-Y": (0, -1, 0), "+Z": (0, 0, 1),
        "-Z": (0, 0, -1)}
ALONG_X = (0, 90, 0)  # turns a cylinder's axis from Z to X
ALONG_Y = (90, 0, 0)


def segment(name, axis, d0, skin, length=None, start=None, motions=None, blocks=None):
    text = f'<eod:segment name="{name}"'
    if start is not None:
        text += f' start="{numbers(start)}"'
    text += f' direction="{numbers(AXES[axis])}" length="{numbers([length or d0 + 0.20])}"'
    text += f' d0="{numbers([d0])}" skin="{numbers([skin])}"'
    text += f' motions="{motions}"' if motions else ""
    return text + (f' blocks="{blocks}"/>' if blocks else "/>")


def isector(name, method, part, motions, segments, at=(0, 0, 0), extended=False):
    tag = f'eod:isector name="{name}" method="{method}" part="{part}" motions="{motions}"'
    if any(at):
        tag += f' pose="{numbers(at)} 0 0 0"'
    if extended:
        tag += ' coverage="extended"'
    return element(tag, segments)


def wheel_isector(name, part, x, drive, flipper_down, motions):
    """Small wheel: six lines; -Z rests on the ground, so it lives only while the flipper is lowered."""
    lines = [segment(axis, axis, WHEEL + 0.02, 0.02) for axis in ("+X", "-X", "+Y", "-Y")]
    lines.append(segment("+Z", "+Z", WHEEL + 0.005, 0.005))
    lines.append(segment("-Z", "-Z", WHEEL + 0.005, 0.005, motions=flipper_down))
    return isector(name, "bump", part, f"{drive} M03 M04 {motions}", lines, (x, FLIPPER, 0))


def camera(name, fov_deg, xyz, down_deg=0, width=640, height=480):
    """Camera that looks along +Y of the link, or somewhat below."""
    return element(f'sensor name="{name}" type="camera"', [
        *pose(xyz, (0, down_deg, 90)),
        "<camera>",
        f"  <horizontal_fov>{numbers([math.radians(fov_deg)])}</horizontal_fov>",
        f"  <image><width>{width}</width><height>{height}</height></image>",
        "  <clip><near>0.05</near><far>600</far></clip>",
        "</camera>"])


# Name, and J1 .. J9 in degrees (J7 in metres; None: stays). Hand poses solved for the hand's centre
# (y, z) and pitch: ground pick (1.20, 0.12) -20; carry (0.85, 0.80) 0; can drop (1.05, 1.15) -60 [C].
PRESETS = (
    ("stow", (90, 90, 120, 30, 30, 0, None, 0, -10)),
    ("travel", (45, 45, 120, 30, 30, 0, None, 0, -10)),
    ("ground_pick", (None, None, 14.7, 108.7, 36.5, 0, None, None, None)),
    ("carry", (None, None, 70.1, 65.5, 44.4, None, None, None, None)),
    ("can_drop", (None, None, 57.1, 138.0, -75.1, None, None, None, None)),
    ("stair_up", (50, 0, 60, 35, 80, None, None, None, None)),
    ("stair_down", (0, 45, 60, 35, 80, None, None, None, None)),
)
# To full rate in a quarter of a second [E]; the drives in two thirds at the highest speed.
START_UP = 0.25


def presets():
    lines = []
    for index, (name, pose_deg) in enumerate(PRESETS, 1):
        joints = "".join(f' J{j}_{"m" if j == 7 else "deg"}="{numbers([value])}"'
                         for j, value in enumerate(pose_deg, 1) if value is not None)
        lines.append(f'<eod:preset index="{index}" name="{name}"{joints}/>')
    return lines


def joint(name, kind, parent, child, axis=(1, 0, 0), limits=None, rate=None, custom=()):
    body = [f"<parent>{parent}</parent>", f"<child>{child}</child>"]
    if kind != "fixed":
        lower, upper = limits
        body += element("axis", [
            f"<xyz>{numbers(axis)}</xyz>",
            f"<limit><lower>{numbers([lower])}</lower><upper>{numbers([upper])}</upper>"
            f"<velocity>{numbers([rate])}</velocity></limit>"])
    return element(f'joint name="{name}" type="{kind}"', [*body, *custom])


def hinge(index, name, parent, child, limits_deg, rate_deg, home_deg, motions, axis=(1, 0, 0)):
    limits = [math.radians(a) for a in limits_deg]
    custom = [f'<eod:motion index="{index}" positive="{motions[0]}" negative="{motions[1]}" '
              f'home_deg="{numbers([home_deg])}" accel_deg_per_s2="{numbers([rate_deg / START_UP])}"/>']
    return joint(name, "revolute", parent, child, axis, limits, math.radians(rate_deg), custom)


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


def chassis_isectors():
    legs = (("front_left", (-TRACK_X, AXLE_Y, 0)), ("front_right", (TRACK_X, AXLE_Y, 0)),
            ("rear", (0, -AXLE_Y, 0)))
    tripod = [f'<eod:segment name="{name}" start="{numbers(at)}"/>' for name, at in legs]
    lines = isector("TRIPOD", "tripod", "chassis", "always", tripod)
    lines += isector("LOS_FRONT", "los", "chassis", "always",
                     [segment("+Y", "+Y", 0.05, 0.05, 10)], (0, 0.475, 0.30))
    lines += isector("LOS_REAR", "los", "chassis", "M02", [segment("-Y", "-Y", 0.05, 0.05, 10)],
                     (0, -0.475, 0.30))
    # Beyond the paper's set: the corners and sides that its lines leave open.
    # The lower ones pass over a kerb of 0.15 m, which the tracks climb.
    for name, axis, drive, end in (("GUARD_FRONT", "+Y", "M01", 1), ("GUARD_REAR", "-Y", "M02", -1)):
        feelers = [segment(f"{side}{height}", axis, 0.05, 0.05, 0.5, (x, end * 0.475, z))
                   for side, x in (("left", -0.34), ("right", 0.34))
                   for height, z in (("_low", 0.18), ("_high", 0.40))]
        lines += isector(name, "volume", "chassis", f"{drive} M03 M04", feelers, extended=True)
    for name, axis, x in (("GUARD_LEFT", "-X", -0.35), ("GUARD_RIGHT", "+X", 0.35)):
        feelers = [segment(place, axis, 0.05, 0.05, 0.4, (x, y, 0.25))
                   for place, y in (("front", 0.45), ("middle", 0.0), ("rear", -0.45))]
        lines += isector(name, "volume", "chassis", "M03 M04", feelers, extended=True)
    return lines


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


def arms():
    big = Link("big_arm").mass(14, (0, BIG_ARM / 2, 0))
    big.visual(box(0.09, 0.66, 0.11), OLIVE, (0, 0.36, 0))
    big.visual(box(0.094, 0.14, 0.112), HAZARD, (0, 0.58, 0))
    big.visual(cylinder(0.065, 0.13), GREY, (0, BIG_ARM, 0), ALONG_X)
    big.visual(cylinder(0.022, 0.34), GREY, (0, 0.22, -0.085), ALONG_Y)
    big.visual(cylinder(0.012, 0.30), STEEL, (0, 0.50, -0.085), ALONG_Y)
    big.collision(box(0.09, 0.66, 0.165), (0, 0.36, -0.0275))
    big.collision(cylinder(0.065, 0.13), (0, BIG_ARM, 0), ALONG_X)
    small = Link("small_arm").mass(9, (0, SMALL_ARM / 2, 0))
    small.visual(box(0.07, 0.56, 0.08), OLIVE, (0, 0.32, 0))
    small.visual(box(0.074, 0.10, 0.082), HAZARD, (0, 0.54, 0))
    small.visual(cylinder(0.016, 0.40), GREY, (0.048, 0.30, 0.02), ALONG_Y)
    small.visual(cylinder(0.045, 0.10), GREY, (0, SMALL_ARM, 0), ALONG_X)
    small.collision(box(0.10, 0.56, 0.08), (0.014, 0.32, 0))
    small.collision(cylinder(0.045, 0.10), (0, SMALL_ARM, 0), ALONG_X)
    wrist = Link("wrist").mass(3, (0, 0.075, 0))
    wrist.visual(box(0.06, 0.07, 0.06), OLIVE_DARK, (0, 0.035, 0))
    wrist.visual(box(0.045, 0.05, 0.04), GREY, (0, 0.02, 0.062))
    wrist.visual(cylinder(0.014, 0.022), LENS, (0, 0.055, 0.065), ALONG_Y)
    wrist.collision(box(0.06, 0.07, 0.06), (0, 0.035, 0))
    wrist.collision(box(0.045, 0.07, 0.04), (0, 0.03, 0.062))
    # It sees the fingers in whole length, and the foot of what stands between them.
    wrist.parts += camera("gripper", 60, (0, 0.067, 0.065), down_deg=12)
    return [big, small, wrist]


def gripper():
    """Frame at the wrist's pivot, +Y along the fingers: crossbeam at 0.15, finger tips at 0.31."""
    arm = "M01 M03 M04 M09 M10 M11 M12 M13 M14 M15 M16 M17 M18"
    # l3, l6 and l9 look at what is between the hands: while these open or close, that is nearness,
    # not contact.
    but_grip = arm.removesuffix(" M17 M18")
    roll = Link("gripper").mass(2, (0, 0.15, 0))
    roll.visual(cylinder(0.035, 0.05), STEEL, (0, 0.085, 0), ALONG_Y)
    roll.visual(box(0.06, 0.05, 0.045), GREY, (0, 0.10, 0))
    roll.collision(box(0.06, 0.07, 0.06), (0, 0.09, 0))
    beam = Link("crossbeam").mass(1)
    beam.visual(box(0.30, 0.022, 0.035), GREY, (0, -0.012, 0))
    beam.visual(box(0.30, 0.006, 0.037), HAZARD, (0, -0.024, 0))
    beam.collision(box(0.30, 0.027, 0.037), (0, -0.0145, 0))
    beam.parts += isector("B7", "bump", "crossbeam", arm,
                          [segment("l7", "-X", 0.14, 0.02), segment("l8", "+X", 0.14, 0.02),
                           segment("l9", "+Y", 0.14, 0.02, blocks=but_grip)])
    hands = []
    for name, side in (("left_hand", -1), ("right_hand", 1)):
        hand = Link(name).mass(0.5, (0, FINGER / 2, 0))
        hand.visual(box(0.014, FINGER + 0.04, 0.045), STEEL, (side * 0.013, FINGER / 2 - 0.02, 0))
        hand.visual(box(0.006, FINGER - 0.02, 0.040), PAD, (side * 0.003, FINGER / 2 + 0.01, 0))
        hand.visual(box(0.03, 0.05, 0.03), GREY, (side * 0.02, -0.02, 0))
        # The pads are soft: what presses them in by less than their thickness is not shoved.
        hand.collision(box(0.02 - PAD_DEPTH, FINGER + 0.02, 0.045),
                       (side * (0.02 + PAD_DEPTH) / 2, FINGER / 2 - 0.01, 0))
        hand.collision(box(0.035 - PAD_DEPTH, 0.05, 0.03), (side * (0.035 + PAD_DEPTH) / 2, -0.02, 0))
        hands.append(hand)
    hands[0].parts += isector("B5", "bump", "left_hand", arm,
                              [segment("l1", "+Y", 0.085, 0.02), segment("l2", "-Y", 0.085, 0.02),
                               segment("l3", "+X", 0.30, 0.02, blocks=but_grip)], (0, FINGER / 2, 0))
    hands[1].parts += isector("B6", "bump", "right_hand", arm,
                              [segment("l4", "+Y", 0.02, 0.02), segment("l5", "-Y", 0.14, 0.02),
                               segment("l6", "-X", 0.30, 0.02, blocks=but_grip)], (0, FINGER, 0))
    # Beyond the paper's set: nothing of it looks down from the hand.
    for hand, name, part in ((hands[0], "B5_DOWN", "left_hand"), (hands[1], "B6_DOWN", "right_hand")):
        feelers = [segment("-Z", "-Z", 0.045, 0.02), segment("+Z", "+Z", 0.045, 0.02)]
        hand.parts += isector(name, "bump", part, "M09 M10 M11 M12 M13 M14 M15 M16", feelers,
                              (0, FINGER, 0), extended=True)
    return [roll, beam, *hands]


def mast_camera():
    # Mast and camera together: 4 kg.
    pan = Link("camera_pan").mass(2, (0, 0, -0.40))
    pan.visual(cylinder(0.035, 0.04), GREY, (0, 0, -0.07))
    pan.visual(box(0.02, 0.05, 0.12), GREY, (-0.065, 0, -0.01))
    pan.visual(box(0.13, 0.05, 0.015), GREY, (-0.01, 0, -0.055))
    pan.collision(box(0.15, 0.06, 0.14), (-0.01, 0, -0.02))
    tilt = Link("camera_tilt").mass(2)
    tilt.visual(box(0.10, 0.13, 0.085), OLIVE_DARK, (0, -0.005, 0))
    tilt.visual(cylinder(0.030, 0.02), LENS, (0, 0.062, 0), ALONG_Y)
    tilt.visual(box(0.11, 0.15, 0.008), GREY, (0, 0.01, 0.05))
    tilt.visual(cylinder(0.018, 0.02), LAMP, (0.07, 0.05, 0), ALONG_Y)
    tilt.collision(box(0.11, 0.15, 0.10), (0, 0.005, 0.004))
    tilt.parts += camera("mast", 60, (0, 0.08, 0))
    return [pan, tilt]


def joints():
    lines = hinge(1, "J1_front_flipper", "chassis", "front_flipper", (-45, 120), 20, 90, ("M05", "M06"))
    lines += hinge(2, "J2_rear_flipper", "chassis", "rear_flipper", (-45, 120), 20, 90, ("M07", "M08"))
    lines += hinge(3, "J3_big_arm", "chassis", "big_arm", (0, 150), 10, 120, ("M09", "M10"))
    lines += hinge(4, "J4_small_arm", "big_arm", "small_arm", (0, 180), 15, 30, ("M11", "M12"))
    lines += hinge(5, "J5_wrist", "small_arm", "wrist", (-100, 100), 20, 30, ("M13", "M14"))
    # Rotation about +Y lowers the right side: clockwise as the operator sees it; ccw is positive.
    lines += hinge(6, "J6_gripper_roll", "wrist", "gripper", (-180, 180), 30, 0, ("M15", "M16"),
                   (0, -1, 0))
    unit = 0.15  # metres a unit of Eq. 5
    opening = ['<eod:motion index="7" positive="M17" negative="M18" home_m="0" '
               f'accel_mps2="{numbers([0.27 * unit / START_UP])}"/>',
               '<eod:follows joint="J7_gripper_opening" scale="1" hand="right"/>']
    limits, rate = (0, 0.8 * unit), 0.27 * unit
    lines += joint("J7_gripper_opening", "prismatic", "gripper", "right_hand", (1, 0, 0), limits, rate,
                   opening)
    lines += joint("left_hand_slide", "prismatic", "gripper", "left_hand", (-1, 0, 0), limits, rate,
                   ['<eod:follows joint="J7_gripper_opening" scale="1" hand="left"/>'])
    lines += joint("crossbeam_slide", "prismatic", "gripper", "crossbeam", (0, -1, 0), (0, 0.08), rate,
                   ['<eod:follows joint="J7_gripper_opening" scale="0.666666666666667"/>'])
    lines += hinge(8, "J8_camera_pan", "chassis", "camera_pan", (-170, 170), 40, 0, ("M19", "M20"),
                   (0, 0, 1))
    lines += hinge(9, "J9_camera_tilt", "camera_pan", "camera_tilt", (-60, 90), 30, -10, ("M21", "M22"))
    return lines


def arc(centre_y, centre_z, radius, from_deg, to_deg, steps):
    """Points y z on a circle; 0 deg is forward, counter-clockwise seen from +X."""
    angles = (math.radians(from_deg + (to_deg - from_deg) * i / steps) for i in range(steps + 1))
    return [(centre_y + radius * math.cos(a), centre_z + radius * math.sin(a)) for a in angles]


def support(link, x, outline):
    yz = numbers([round(c, 5) for point in outline for c in point])
    return f'<eod:support link="{link}" x="{numbers(x)}" outline="{yz}"/>'


def stance():
    """What ground can carry: tracks, belly and the flippers' belts, all round."""
    belt = [(0.075 * i, 0) for i in range(-4, 5)]
    track = [*arc(-AXLE_Y, MAIN_WHEEL, MAIN_WHEEL, 180, 270, 5), *belt,
             *arc(AXLE_Y, MAIN_WHEEL, MAIN_WHEEL, 270, 360, 5),
             (AXLE_Y + MAIN_WHEEL, 0.25), (-AXLE_Y - MAIN_WHEEL, 0.25)]
    belly = [*((y, 0.10) for y in (-0.36, -0.18, 0, 0.18, 0.30)), (0.455, 0.22), (0.30, 0.45),
             (-0.42, 0.45)]
    run = [(y, 0.085 + (WHEEL - 0.085) * y / FLIPPER) for y in (0.10, 0.20, 0.30)]
    swing = [*((y, -z) for y, z in run), *arc(FLIPPER, 0, WHEEL, 270, 450, 8), *reversed(run)]
    # Friction: tan 40 deg, the stated slope limit of the prototype [P]; the rest [E].
    tag = (f'eod:stance friction="{numbers([math.tan(math.radians(40))])}" pitch_limit_deg="38" '
           'roll_limit_deg="28" overturned_deg="80" press_on_s="0.5" lift_off_m="0.01" '
           'reach_up_m="0.2" reach_down_m="0.5" rise_mps="0.25" rise_per_metre="1.5"')
    return element(tag, [support("chassis", (-TRACK_X, TRACK_X), track), support("chassis", (0,), belly),
                         support("front_flipper", (-TRACK_X, TRACK_X), swing),
                         support("rear_flipper", (-TRACK_X, TRACK_X), swing)])


def model():
    front = [*wheel_isector("B1", "front_left_wheel", -TRACK_X, "M01", "M06", "M05 M06"),
             *wheel_isector("B2", "front_right_wheel", TRACK_X, "M01", "M06", "M05 M06")]
    # The rear frame looks back: its -X is the robot's right.
    rear = [*wheel_isector("B3", "rear_left_wheel", TRACK_X, "M02", "M08", "M07 M08"),
            *wheel_isector("B4", "rear_right_wheel", -TRACK_X, "M02", "M08", "M07 M08")]
    big, small, wrist = arms()
    roll, beam, left, right = gripper()
    pan, tilt = mast_camera()
    lines = ['<eod:chassis creep_mps="0.1" low_mps="0.3" high_mps="0.67" turn_deg_per_s="30" '
             'accel_mps2="1" turn_accel_deg_per_s2="90" step_up_m="0.45" fall_search_m="3"/>',
             '<eod:payload folded_kg="15" stretched_kg="8"/>', *presets()]
    lines += stance()
    lines += chassis().lines()
    lines += flipper("front_flipper", front).lines(xyz=(0, AXLE_Y, AXLE_Z))
    lines += flipper("rear_flipper", rear).lines(xyz=(0, -AXLE_Y, AXLE_Z), rpy_deg=(0, 0, 180))
    lines += big.lines(xyz=(0, -0.10, 0.55))
    # Coordinate 0 of the elbow is folded on the big arm.
    lines += small.lines(xyz=(0, BIG_ARM, 0), rpy_deg=(-180, 0, 0), relative_to="big_arm")
    lines += wrist.lines(xyz=(0, SMALL_ARM, 0), relative_to="small_arm")
    lines += roll.lines(relative_to="wrist")
    lines += beam.lines(xyz=(0, BEAM_Y, 0), relative_to="gripper")
    lines += left.lines(xyz=(0, BEAM_Y, 0), relative_to="gripper")
    lines += right.lines(xyz=(0, BEAM_Y, 0), relative_to="gripper")
    lines += pan.lines(xyz=(-0.20, -0.25, 1.20))
    lines += tilt.lines(relative_to="camera_pan")
    lines += joints()
    return element('model name="eod_robot"', lines)


def hull_of_circles(circles, steps=16):
    """Convex hull, counter-clockwise, of points on circles (y, z, radius)."""
    points = sorted({(round(y + r * math.cos(a), 4), round(z + r * math.sin(a), 4))
                     for y, z, r in circles
                     for a in (2 * math.pi * i / steps for i in range(steps))})
    halves = []
    for ordered in (points, points[::-1]):
        half = []
        for p in ordered:
            while len(half) > 1 and ((half[-1][0] - half[-2][0]) * (p[1] - half[-2][1]) -
                                     (half[-1][1] - half[-2][1]) * (p[0] - half[-2][0])) <= 0:
                half.pop()
            half.append(p)
        halves += half[:-1]
    return halves


def main():
    meshes = HERE / "meshes"
    hull = [(-0.38, 0.10), (0.30, 0.10), (0.455, 0.22), (0.46, 0.30), (0.30, 0.45), (-0.42, 0.45),
            (-0.46, 0.40), (-0.46, 0.18)]
    write_extrusion(meshes / "hull.obj", hull, 0.47)
    track = hull_of_circles([(s * AXLE_Y, AXLE_Z, 0.10) for s in (-1, 1)] +
                            [(s * 0.22, 0.10, 0.10) for s in (-1, 1)])
    write_extrusion(meshes / "track.obj", track, 0.10)
    arm = hull_of_circles([(0, 0, 0.085), (FLIPPER, 0, WHEEL)])
    write_extrusion(meshes / "flipper.obj", arm, 0.07)
    text = HEADER.format(script="sim/robots/make_robot.py") + "\n".join(indent(model())) + "\n</sdf>\n"
    (HERE / "eod_robot.sdf").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
