#!/usr/bin/python3
"""One program of the running system is killed: nothing moves on, the others say why, and a restart
brings the system back."""

import signal
import sys
import time
import unittest

import can

from programs import ROOT, Chain

CHANNEL, PORT = "239.74.163.2", 43113
BUS = f"udp:{CHANNEL}:{PORT}"
HOLD_FORWARD = ROOT / "tests/process/hold_forward.boxscript"


class Listener:
    """What the bus says about the robot."""

    def __init__(self):
        self.bus = can.Bus(interface="udp_multicast", channel=CHANNEL, port=PORT, hop_limit=0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.bus.shutdown()

    def frames(self, arbitration_id, seconds):
        """Frames of one identifier that are sent from now on, for at most so long."""
        start = time.time()
        while (message := self.bus.recv(seconds)) is not None:
            if message.timestamp > start + seconds:
                return
            if message.timestamp >= start and message.arbitration_id == arbitration_id:
                yield message

    def until(self, arbitration_id, condition, seconds, what):
        for message in self.frames(arbitration_id, seconds):
            if condition(message.data):
                return message
        raise AssertionError(f"{what}: not within {seconds} s")


def speed_mmps(data):
    return int.from_bytes(data[2:4], "little", signed=True)


def state(data):
    return data[1] >> 4


class LinkLoss(unittest.TestCase):
    def test_box_killed_in_mid_drive_stops_the_robot_and_latches(self):
        with Chain(BUS, eod_box=("--script", str(HOLD_FORWARD))) as chain, Listener() as bus:
            bus.until(0x4A0, lambda d: speed_mmps(d) > 90, 30, "the robot drives")
            chain["eod-box"].end(signal.SIGKILL)
            killed = bus.until(0x1A0, lambda d: state(d) == 4, 2, "SafeStop")
            stopped = bus.until(0x4A0, lambda d: speed_mmps(d) == 0, 2, "the robot stands")
            # 100 ms to notice are over at SafeStop; the ramp takes 200 ms, a pose comes every 50.
            self.assertLess(stopped.timestamp - killed.timestamp, 0.2 + 0.05 + 0.05)
            bus.until(0x1A0, lambda d: state(d) not in (3, 4), 2, "latched after 500 ms")

    def test_bridge_killed_in_mid_drive_stops_the_robot_and_a_new_one_does_not_start_it(self):
        with Chain(BUS, eod_box=("--script", str(HOLD_FORWARD))) as chain, Listener() as bus:
            bus.until(0x4A0, lambda d: speed_mmps(d) > 90, 30, "the robot drives")
            chain["eod-canbridge"].end(signal.SIGKILL)
            chain["eod-box"].wait_for("link", 5)
            chain.start("eod-canbridge")
            pose = bus.until(0x4A0, lambda d: True, 5, "the new bridge speaks")
            self.assertEqual(speed_mmps(pose.data), 0)
            # The script still holds the button: rule 5, a button held at the start is ignored.
            for message in bus.frames(0x4A0, 1.0):
                self.assertEqual(speed_mmps(message.data), 0)

    def test_simulator_killed_is_told_to_the_box_and_a_new_one_works(self):
        with Chain(BUS, eod_box=("--script", str(HOLD_FORWARD))) as chain, Listener() as bus:
            bus.until(0x4A0, lambda d: speed_mmps(d) > 90, 30, "the robot drives")
            chain["eod-sim"].end(signal.SIGKILL)
            bus.until(0x1A0, lambda d: state(d) != 3, 3, "not in Operate without a simulator")
            chain.start("eod-sim")
            bus.until(0x1A0, lambda d: state(d) in (1, 2), 5, "Standby or Ready again")

    def test_end_signals_end_every_program_with_status_0(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(how=how.name), Chain(BUS) as chain:
                for name in ("eod-box", "eod-canbridge", "eod-sim"):
                    self.assertEqual(chain[name].end(how), 0, chain[name].text())


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
