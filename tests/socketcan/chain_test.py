#!/usr/bin/python3
"""Box, bridge and simulator on a kernel's CAN, watched and disturbed by can-utils.

Needs the right to change interfaces; EOD_BIN_DIR names the programs, EOD_RESULTS a folder that
keeps what they printed and recorded, EOD_CONTROLLERS=yes says that can0 and can1 are one bus.
"""

import os
import pathlib
import subprocess
import sys
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/process"))

from programs import Program  # noqa: E402
from recording import can_frames, link_states, raised_alarms, robot_states  # noqa: E402

WALL_STOP = ROOT / "firmware_emu/scripts/wall_stop.boxscript"
OUTAGES = HERE / "outages.boxscript"
LINK_ALARM, COLLISION_ALARM = 0x60, 0x10
# [s] Far more than any part takes: in an emulated machine, waiting for files may look long.
PATIENCE = 600
BUS_DOWN, BUS_OFF = 1, 2


def ip_link(*arguments):
    subprocess.run(["ip", "link", *arguments], check=True)


def make_vcan():
    ip_link("add", "vcan0", "type", "vcan")
    ip_link("set", "vcan0", "up")


class Run:
    """The whole system with one operator script, its recorder, and candump as a stranger."""

    def __init__(self, name, box_interface, robot_interface, script):
        self.folder = pathlib.Path(os.environ["EOD_RESULTS"]) / name
        self.folder.mkdir(parents=True)
        self.can_log = self.folder / "candump.log"
        self.lcm_log = self.folder / "recording/run.lcmlog"
        self.box_bus, self.robot_bus = f"socketcan:{box_interface}", f"socketcan:{robot_interface}"
        self.script = script
        self.programs, self.strangers = [], []

    def start(self, name, *arguments):
        program = Program(name, *arguments, folder=self.folder)
        self.programs.append(program)
        program.wait_for("ready", PATIENCE)
        return program

    def stranger(self, *command, output=subprocess.DEVNULL):
        self.strangers.append(subprocess.Popen(command, stdout=output, stdin=subprocess.DEVNULL))

    def __enter__(self):
        try:
            with self.can_log.open("w") as log:
                self.stranger("candump", "-L", "any", output=log)
            self.start("eod-recorder", "--bus", self.robot_bus, "--plain", "--out",
                       str(self.folder / "recording"))
            self.start("eod-sim", "--no-cameras")
            self.start("eod-canbridge", "--bus", self.robot_bus)
            self.box = self.start("eod-box", "--bus", self.box_bus, "--script", str(self.script))
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        try:
            self.statuses = {each.name: each.end() for each in reversed(self.programs)}
        finally:
            for each in self.strangers + [program.process for program in self.programs]:
                if each.poll() is None:
                    each.kill()
                each.wait()

    def wait_for_note(self, text, count=1):
        self.box.wait_until(lambda: self.box.text().count(text) >= count, f"'{text}'", PATIENCE)

    def wait_for_script(self):
        """Until the box has played its script to the good end."""
        if not self.box.ended_within(PATIENCE) or self.box.process.returncode != 0:
            raise AssertionError(f"the script failed:\n{self.box.text()}")


class Chain(unittest.TestCase):
    def expect_wall_stop(self, run, interface):
        """The run as a stranger's candump tells it, with the bit places of the data base."""
        forward = [t for t, data in can_frames(run.can_log, interface, 0x290) if data[2] & 1]
        self.assertTrue(forward, "no frame with M01 pressed")
        lamps = list(can_frames(run.can_log, interface, 0x2A0))
        # LampCollision is the fifth lamp of two bits from bit 16 on: 0 off, 2 and 3 blink.
        collision = [t for t, data in lamps if data[3] & 3 >= 2]
        self.assertTrue(collision, "the collision lamp never blinked")
        self.assertGreater(collision[0], forward[0])
        self.assertEqual(lamps[-1][1][3] & 3, 0, "the lamp is still on after the retreat")
        speeds = [int.from_bytes(data[2:4], "little", signed=True)
                  for t, data in can_frames(run.can_log, interface, 0x4A0)]
        self.assertGreater(max(speeds), 600)  # [mm/s], of 670 at high speed
        self.assertLess(min(speeds), -600)
        self.assertIn(COLLISION_ALARM, [code for _, code in raised_alarms(run.lcm_log)])

    def test_wall_stop_over_vcan_among_strangers(self):
        with Run("vcan", "vcan0", "vcan0", WALL_STOP) as run:
            run.stranger("cangen", "vcan0", "-g", "5", "-I", "7E5", "-L", "8")
            run.stranger("cangen", "vcan0", "-g", "7", "-e", "-L", "i")
            run.box.wait_until(lambda: "operate" in run.box.text(), "operate", PATIENCE)
            # A safety frame that is too short and one with a wrong CRC: dropped, counted, survived.
            for frame in ("190#00", "190#0001020304050607"):
                subprocess.run(["cansend", "vcan0", frame], check=True)
            run.wait_for_script()
        self.expect_wall_stop(run, "vcan0")
        _, link = list(link_states(run.lcm_log))[-1]
        self.assertEqual(link["crc_errors"], 1)
        self.assertEqual(link["length_errors"], 1)
        self.assertEqual(link["lost"], 0)
        self.assertEqual(run.statuses, {name: 0 for name in run.statuses})

    @unittest.skipUnless(os.environ.get("EOD_CONTROLLERS") == "yes", "no controllers here")
    def test_wall_stop_over_two_controllers(self):
        with Run("controllers", "can0", "can1", WALL_STOP) as run:
            run.wait_for_script()
        # candump hears each controller's own frames and the other's: both sides saw it all.
        for interface in ("can0", "can1"):
            self.expect_wall_stop(run, interface)
        _, link = list(link_states(run.lcm_log))[-1]
        self.assertEqual((link["crc_errors"], link["lost"], link["tx_dropped"]), (0, 0, 0))

    def test_outages_in_mid_drive_stop_the_robot_and_it_recovers(self):
        outages = [
            ("interface down", BUS_DOWN, lambda: ip_link("set", "vcan0", "down"),
             lambda: ip_link("set", "vcan0", "up")),
            ("interface deleted", BUS_DOWN, lambda: ip_link("del", "vcan0"), make_vcan),
            # What a controller's driver reports, put onto the bus by hand: bus-off, restarted.
            ("bus-off", BUS_OFF,
             lambda: subprocess.run(["cansend", "vcan0", "20000040#0000000000000000"], check=True),
             lambda: subprocess.run(["cansend", "vcan0", "20000100#0000000000000000"], check=True)),
        ]
        times = []
        with Run("outages", "vcan0", "vcan0", OUTAGES) as run:
            for count, (name, _, break_bus, mend_bus) in enumerate(outages, 1):
                run.wait_for_note(f"driving: {name}")
                broken = time.time()
                break_bus()
                run.wait_for_note("stood still", count)
                mended = time.time()
                mend_bus()
                run.wait_for_note("obeys again", count)
                times.append((broken, mended))
            run.wait_for_script()

        for (name, bus_state, _, _), (broken, mended) in zip(outages, times):
            with self.subTest(name):
                self.expect_stop(run, broken, mended)
                self.expect_reason(run, bus_state, broken, mended)
        self.assertEqual(run.statuses, {name: 0 for name in run.statuses})

    def expect_stop(self, run, broken, mended):
        states = list(robot_states(run.lcm_log))
        before = [speed for t, _, speed in states if broken - 0.2 < t < broken]
        self.assertGreater(max(before), 0.25, "it did not drive")  # of 0.30 m/s
        # The bridge notices at once, and ramps down in 200 ms; the rest is for a slow machine.
        standing = [(p, speed) for t, p, speed in states if broken + 0.5 < t < mended]
        self.assertGreater(len(standing), 50)
        self.assertEqual({speed for _, speed in standing}, {0.0})
        self.assertEqual(len({p for p, _ in standing}), 1, "it crept")

    def expect_reason(self, run, bus_state, broken, mended):
        links = [link for t, link in link_states(run.lcm_log) if broken < t < mended]
        told = {link["fault"] for link in links if link["bus_state"] == bus_state}
        self.assertEqual(told, {"CAN controller is bus-off" if bus_state == BUS_OFF
                                else "CAN bus is down"})
        alarms = [code for t, code in raised_alarms(run.lcm_log) if broken < t < mended]
        self.assertEqual(alarms, [LINK_ALARM])


if __name__ == "__main__":
    unittest.main(verbosity=2)
