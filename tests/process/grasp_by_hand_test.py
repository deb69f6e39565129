#!/usr/bin/python3
"""A person takes charge M with the keyboard, by the real programs in real time: power-up, choice of the
module, pose, opening, approach, closing, lifting. Nothing but keys goes in, nothing but the box's
screen comes out.

The charge stands nearer to the start pad than in the shipped world, so that the way is short.
"""

import pathlib
import re
import sys
import tempfile
import unittest

from programs import ROOT, Chain
from trainee import Trainee

BUS = "udp:239.74.163.2:43113"
WORLDS = ROOT / "sim/worlds"
SCENARIO = ROOT / "tests/process/grasp_by_hand.toml"
HAND_M = 1.20  # the hand's middle in the pose ground_pick, ahead of the robot's
CHARGE_M = 1.48  # beyond the arc that the fingers come down on
RADIUS_MM = 60
# A key that repeats lets go 0.15 s after its last repeat; the creep speed meanwhile.
CREEP_MPS, LET_GO_S = 0.10, 0.15


def world_with_near_charge(folder):
    text = (WORLDS / "training_ground.sdf").read_text()
    text, moved = re.subn(r'(<model name="charge_m">\s*<pose relative_to="bomb">)0 6 ',
                          rf"\g<1>0 {CHARGE_M} ", text)
    assert moved == 1, "charge_m stands at (0, 6) in the shipped world"
    (folder / "meshes").symlink_to(WORLDS / "meshes")
    world = folder / "near.sdf"
    world.write_text(text)
    return world


class GraspByHand(unittest.TestCase):
    def test_charge_is_taken_and_lifted_by_keys_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            world = world_with_near_charge(pathlib.Path(folder))
            with Chain(BUS, programs=("eod-sim", "eod-canbridge"),
                       eod_sim=("--world", str(world), "--scenario", str(SCENARIO))), \
                    Trainee("--bus", BUS) as trainee:
                self.power_up(trainee)
                self.choose_module(trainee)
                self.take(trainee)
                trainee.hold("q", r"done 2/2")
                self.assertRegex(trainee.screen, r"Bomb (grasped|carried)")
                self.assertRegex(trainee.screen, r"Mission success")
                self.assertRegex(trainee.screen, r"failure none")

    def power_up(self, trainee):
        trainee.wait(r"box standby .*link up")
        trainee.press("m")
        trainee.wait(r"Key standby")
        trainee.press("m")
        trainee.wait(r"Key operate")
        trainee.press("x")
        trainee.wait(r"Deadman enabled")
        trainee.press("n")
        trainee.wait(r"robot (ready|operate)")
        trainee.press("\r")
        trainee.wait(r"robot operate")

    def choose_module(self, trainee):
        for module in ("flat", "slope", "bomb"):
            trainee.press("8")
            trainee.wait(rf"Module {module}")
        trainee.press("9")
        trainee.wait(r"Mission run.* done 0/2")
        trainee.wait(r"Bomb placed")

    def take(self, trainee):
        trainee.hold("G", r"Arm big +14\.70 .*small +108\.70 +wrist +36\.50")
        trainee.until(lambda: trainee.number(r"opening +([\d.]+) mm") >= RADIUS_MM + 20,
                      "wide enough", 10, "t")
        trainee.press("1")
        trainee.wait(r"Speed creep")
        start = trainee.metres
        way = CHARGE_M - HAND_M
        trainee.drive(way - 0.05 - CREEP_MPS * LET_GO_S)
        for share in (90, 80, 70, 60, 50, 40, 30):
            trainee.press(",")
            trainee.wait(rf"Speed creep +{share} %")
        slow = 0.3 * CREEP_MPS
        trainee.drive(start + way - trainee.metres - slow * LET_GO_S)
        trainee.hold("g", r"Grasp grasped", 10)
        self.assertNotRegex(trainee.screen, r"Alarm \d+ (bomb_unstable|detonation)")


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
