#!/usr/bin/python3
"""A stranger on the bus: Debian's python3-can, with no code of ours, is the control box.

It powers up, drives the robot one metre over udp_multicast and reads the lamps. Distances come from
the speed that the robot reports (ROB_POSE); bit places from the data base's documentation.
"""

import sys
import threading
import time
import unittest

import can

from programs import Chain

CHANNEL = "239.74.163.2"
PORT = 43113


def crc8(data_id, payload):
    """AUTOSAR E2E profile 1: polynomial 0x1D, start and final XOR 0."""
    crc = 0
    for byte in [data_id & 0xFF, data_id >> 8, *payload[1:]]:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x1D if crc & 0x80 else crc << 1) & 0xFF
    return crc


def protected(arbitration_id, payload, counter):
    payload = bytearray(payload)
    payload[1] = payload[1] & 0xF0 | counter
    payload[0] = crc8(arbitration_id, payload)
    return can.Message(arbitration_id=arbitration_id, data=payload, is_extended_id=False)


class StrangeBox(threading.Thread):
    """Sends the five frames a robot wants to see, every 20 ms, and keeps what comes back."""

    def __init__(self, bus):
        super().__init__(daemon=True)
        self.bus = bus
        self.key, self.deadman, self.reset, self.start_button = 1, 0, 0, 0
        self.speed_range = 1
        self.forward = False
        self.menu = 0
        self.lamps = None
        self.speed = 0.0
        self.metres = 0.0
        self.state = None
        self.ended = threading.Event()

    def run(self):
        ticks, due, last_pose = 0, time.monotonic(), None
        while not self.ended.is_set():
            self.send(ticks)
            ticks, due = ticks + 1, due + 0.02
            while (left := due - time.monotonic()) > 0:
                message = self.bus.recv(left)
                if message is not None:
                    last_pose = self.take(message, last_pose)

    def send(self, ticks):
        counter = ticks % 15
        safety = [0, self.key << 4, 0x01 | self.deadman << 2 | self.reset << 4
                  | self.start_button << 6, 0x01 | self.speed_range << 4, 200, 0, 120, 0x10]
        motion = [0, 0, 1 if self.forward else 0, 0, 0, 0, 200, 0]
        self.bus.send(protected(0x190, safety, counter))
        self.bus.send(protected(0x290, motion, counter))
        self.bus.send(protected(0x390, [0] * 8, counter))
        if ticks % 2 == 0:
            panel = [0, 0x10, 0, 0, 0x01 | self.menu << 4, 200, 0, 0]
            self.bus.send(protected(0x490, panel, ticks // 2 % 15))
        if ticks % 10 == 0:
            self.bus.send(can.Message(arbitration_id=0x710, data=[5], is_extended_id=False))

    def take(self, message, last_pose):
        if message.arbitration_id == 0x4A0:
            self.speed = int.from_bytes(message.data[2:4], "little", signed=True) / 1000
            if last_pose is not None:
                self.metres += self.speed * (message.timestamp - last_pose)
            return message.timestamp
        if message.arbitration_id == 0x2A0:
            bits = int.from_bytes(message.data, "little")
            names = ("power", "link", "estop", "deadman", "collision")
            self.lamps = {name: bits >> 16 + 2 * i & 3 for i, name in enumerate(names)}
        if message.arbitration_id == 0x1A0:
            self.state = message.data[1] >> 4
        return last_pose

    def until(self, condition, seconds, what):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise AssertionError(f"{what}: not within {seconds} s (state {self.state}, "
                                     f"lamps {self.lamps}, {self.metres:.2f} m)")
            self.ended.wait(0.005)


class PythonCanDrives(unittest.TestCase):
    def test_one_metre_forward_with_lamps_read(self):
        with Chain(f"udp:{CHANNEL}:{PORT}", programs=("eod-sim", "eod-canbridge")), \
                can.Bus(interface="udp_multicast", channel=CHANNEL, port=PORT, hop_limit=0) as bus:
            box = StrangeBox(bus)
            box.start()
            try:
                box.until(lambda: box.lamps is not None, 10, "the robot answers")
                self.assertEqual(box.lamps["deadman"], 0)
                box.key, box.deadman = 2, 1
                for button in ("reset", "start_button"):
                    setattr(box, button, 1)
                    box.ended.wait(0.2)
                    setattr(box, button, 0)
                    box.ended.wait(0.2)
                box.until(lambda: box.state == 3, 5, "SysState Operate")
                box.until(lambda: box.lamps["power"] == 1 and box.lamps["link"] == 1
                          and box.lamps["deadman"] == 1, 2, "power, link and deadman lamps on")
                self.assertEqual(box.lamps["estop"], 0)
                self.assertEqual(box.lamps["collision"], 0)
                start = box.metres
                box.forward = True
                box.until(lambda: box.metres - start >= 1.0, 10, "one metre")
                box.forward = False
                box.until(lambda: box.speed == 0, 1, "the robot stands")
                # 0.30 m/s for at most one more pose cycle (50 ms) and two command cycles (40 ms), and
                # the run-out at 1 m/s^2.
                self.assertLess(box.metres - start, 1.0 + 0.30 * 0.12 + 0.30**2 / 2)
            finally:
                box.ended.set()
                box.join()


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
