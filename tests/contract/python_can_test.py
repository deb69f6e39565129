"""python-can, as Debian packages it, and our udp bus exchange frames of every kind, both ways.

Usage: python_can_test.py CAN_BUS_PIPE
"""

import subprocess
import sys
import unittest

import can

GROUP, PORT = "239.74.163.2", 43211
PIPE = sys.argv.pop()


def message(arbitration_id, data=(), **fields):
    fields = {"is_extended_id": False, "check": True} | fields
    return can.Message(arbitration_id=arbitration_id, data=bytearray(data), **fields)


# Each frame as python-can says it and as candump -L prints it.
FRAMES = [
    (message(0x000), "000#"),
    (message(0x7FF, range(1, 9)), "7FF#0102030405060708"),
    (message(0x123, [0x11], is_extended_id=True), "00000123#11"),
    (message(0x1FFFFFFF, [0xFF, 0x00], is_extended_id=True), "1FFFFFFF#FF00"),
    (message(0x321, is_remote_frame=True, dlc=5), "321#R5"),
    (message(0x321, is_remote_frame=True, is_extended_id=True), "00000321#R"),
    (message(0x12, is_fd=True), "012##0"),
    (message(0x12, range(12), is_fd=True, bitrate_switch=True), "012##1000102030405060708090A0B"),
    (message(0x1ABCDEF0, [0xA5] * 64, is_extended_id=True, is_fd=True, bitrate_switch=True,
             error_state_indicator=True), "1ABCDEF0##3" + "A5" * 64),
]


class PythonCan(unittest.TestCase):
    def setUp(self):
        self.pipe = subprocess.Popen([PIPE, f"udp:{GROUP}:{PORT}"], stdin=subprocess.PIPE,
                                     stdout=subprocess.PIPE, text=True)
        self.assertEqual(self.pipe.stdout.readline(), "ready\n")
        self.bus = can.Bus(bustype="udp_multicast", channel=GROUP, port=PORT, fd=True, hop_limit=0)

    def tearDown(self):
        self.bus.shutdown()
        self.pipe.stdin.close()
        self.assertEqual(self.pipe.wait(10), 0)
        self.pipe.stdout.close()

    def test_our_bus_receives_what_python_can_sends(self):
        for sent, text in FRAMES:
            self.bus.send(sent)
            self.assertEqual(self.pipe.stdout.readline().split()[2], text)

    def test_python_can_receives_what_our_bus_sends(self):
        for expected, text in FRAMES:
            print(f"(0.000000) bus {text}", file=self.pipe.stdin, flush=True)
            received = self.bus.recv(timeout=10)
            self.assertIsNotNone(received, text)
            # Everything but the time stamp, which python-can takes from its own kernel.
            self.assertTrue(received.equals(expected, timestamp_delta=None), (received, expected))

    def test_an_error_frame_is_no_data(self):
        self.bus.send(can.Message(arbitration_id=0x40, is_error_frame=True, dlc=8, data=bytes(8)))
        self.bus.send(message(0x55))
        self.assertEqual(self.pipe.stdout.readline().split()[2], "055#")


if __name__ == "__main__":
    unittest.main()
