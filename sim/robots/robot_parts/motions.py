"""The nine joints, their 22 motions, and the presets that move several of them."""

import math

from sdf_writer import element, numbers

# Name, and J1 .. J9 in degrees (J7 in metres; None: stays). Hand poses solved for the hand's centre
# (y, z) and pitch: ground pick (1.20, 0.12) -20; carry (0.85, 0.80) 0; can drop (1.05, 1.15) -60 [C].
PRESETS = (
    ("stow", (90, 90, 120, 30, 30, 0, None, 0, -10)),
    ("travel", (45, 45, 120, 30, 30, 0, None, 0, -10)),
    ("ground_pick", (None, None, 14.7, 108.7, 36.5, 0, None, None, None)),
    ("carry", (None, None, 70.1, 65.5, 44.4, None, None, None, None)),
    ("can_drop", (None, None, 57.1, 138.0, -75.1, None, None, None, None)),
    ("stair_up", (50, 0, 60, 35, 80, None, None, None, None)),
    ("stair_down", (0, 0, 60, 35, 80, None, None, None, None)),
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
