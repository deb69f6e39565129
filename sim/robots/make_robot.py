#!/usr/bin/env python3
"""Writes eod_robot.sdf and its meshes: the nine-joint EOD robot.

Frame: X right, Y forward, Z up; origin on the ground under the chassis centre. Metres, kilograms.
Run in any folder: python3 make_robot.py
"""

import pathlib

from sdf_writer import HEADER, element, indent

from robot_parts.cameras import mast_camera
from robot_parts.dimensions import AXLE_Y, AXLE_Z, BEAM_Y, BIG_ARM, SMALL_ARM, TRACK_X
from robot_parts.isectors import wheel_isector
from robot_parts.manipulator import arms, gripper
from robot_parts.motions import joints, presets
from robot_parts.outlines import write_meshes
from robot_parts.stance import stance
from robot_parts.undercarriage import chassis, flipper

HERE = pathlib.Path(__file__).resolve().parent


def battery():
    """Eight cells of lithium iron phosphate; ten hours of waiting, or an hour and a half of driving."""
    return ['<!-- [E] all of it, as packs of this class have it -->',
            '<eod:battery full_v="25.6" empty_v="22.4" capacity_ah="40" resistance_ohm="0.03" idle_a="4" '
            'drive_a="25" joint_a="5" low_v="22.5"/>']


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
             'accel_mps2="1" turn_accel_deg_per_s2="90" step_up_m="0.45" fall_search_m="3" '
             f'track_m="{2 * TRACK_X:g}"/>',
             *battery(),
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


def main():
    write_meshes(HERE / "meshes")
    text = HEADER.format(script="sim/robots/make_robot.py") + "\n".join(indent(model())) + "\n</sdf>\n"
    (HERE / "eod_robot.sdf").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
