#!/usr/bin/python3
"""scripts/demo as a newcomer starts it: the whole chain, its files, and Ctrl-C at any moment."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from programs import BIN, ROOT

PRESET = BIN.parent.name
PROGRAMS = ("eod-box", "eod-canbridge", "eod-sim", "eod-recorder")
BUS = "udp:239.74.163.2:43113"


def running():
    """The product's processes in this network, those that are just ending included."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            name = (entry / "comm").read_text().strip()
            network = os.readlink(entry / "ns/net")
        except OSError:
            continue
        # The kernel cuts a name to 15 characters; ours are shorter.
        if name in PROGRAMS and network == os.readlink("/proc/self/ns/net"):
            found.append(f"{name} {entry.name}")
    return found


class Demo(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name) / "demo"

    def start(self, *arguments):
        demo = subprocess.Popen([ROOT / "scripts/demo", "--headless", "--no-install", "--preset",
                                 PRESET, "--bus", BUS, "--out", self.out, *arguments],
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, start_new_session=True)
        self.addCleanup(demo.stdout.close)
        return demo

    def assert_nothing_left(self):
        end = time.monotonic() + 5
        while running() and time.monotonic() < end:
            os.sched_yield()
        self.assertEqual(running(), [])

    def test_first_drive_ends_well_and_leaves_its_files(self):
        demo = self.start()
        text, _ = demo.communicate(timeout=200)
        self.assertEqual(demo.returncode, 0, text)
        self.assert_nothing_left()
        summary = json.loads((self.out / "summary.json").read_text())
        self.assertEqual(list(summary), ["bus", "module", "result", "sim_seconds", "alarms", "can",
                                         "camera", "latency_ms", "step"])
        self.assertEqual((summary["bus"], summary["module"], summary["result"]),
                         (BUS, "flat", "success"))
        collisions = [alarm for alarm in summary["alarms"] if alarm["code"] == 0x10]
        self.assertEqual(len(collisions), 1, summary["alarms"])
        self.assertEqual(collisions[0]["parts"], 0b11)  # both front wheels
        self.assertEqual(summary["can"]["lost"], 0)
        self.assertEqual(summary["can"]["crc_errors"], 0)
        self.assertEqual((summary["camera"]["width"], summary["camera"]["height"]), (640, 480))
        for latency in ("button_to_pose", "contact_to_lamp_frame"):
            self.assertGreater(summary["latency_ms"][latency]["n"], 0, latency)
        self.check_bus_log(self.out / "can.log")
        self.assertEqual((self.out / "run.lcmlog").read_bytes()[:4], b"\xed\xa1\xda\x01")
        pictures = list((self.out / "camera").glob("*.jpg"))
        self.assertGreater(len(pictures), 20)
        for picture in pictures:
            self.assertEqual(picture.read_bytes()[:3], b"\xff\xd8\xff", picture)
        self.assertEqual((self.out / "contact_sheet.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def check_bus_log(self, log):
        """Stock can-utils read the log, and the lamp, the stop and the retreat are in it."""
        asc = subprocess.run(["log2asc", "-I", log, "vcan0", "lockstep", "can0", "udp"],
                             capture_output=True, text=True, check=True).stdout
        frames = re.findall(r"^\((\d+\.\d+)\) \S+ ([0-9A-F]{3})#([0-9A-F]*)", log.read_text(), re.M)
        self.assertGreater(asc.count("\n"), len(frames) * 9 // 10)
        lamp_on = [float(t) for t, id_, data in frames
                   if id_ == "2A0" and int(data[6:8], 16) & 3]  # byte 3, bits 0-1: collision lamp
        self.assertGreater(len(lamp_on), 10)
        speed = [(float(t), int.from_bytes(bytes.fromhex(data[4:8]), "little", signed=True))
                 for t, id_, data in frames if id_ == "4A0"]
        pushing = [v for t, v in speed if lamp_on[0] + 0.1 < t < lamp_on[0] + 1.0]
        self.assertTrue(pushing and all(v == 0 for v in pushing), pushing)
        self.assertTrue(any(v < 0 for t, v in speed if lamp_on[0] < t < lamp_on[0] + 5))

    def test_interrupt_at_any_moment_leaves_nothing(self):
        # Fractions of a second after the start: set-up, start of the programs, and in mid-drive.
        for moment, how in ((0.05, signal.SIGINT), (0.6, signal.SIGINT), (1.5, signal.SIGTERM),
                            (6.0, signal.SIGINT), (7.0, signal.SIGHUP)):
            with self.subTest(moment=moment, how=how.name):
                demo = self.start()
                try:
                    demo.wait(moment)
                except subprocess.TimeoutExpired:
                    os.killpg(demo.pid, how)
                text, _ = demo.communicate(timeout=20)
                self.assertNotEqual(demo.returncode, 0, text)
                self.assert_nothing_left()
                shutil.rmtree(self.out, ignore_errors=True)

    def test_killed_script_takes_its_programs_with_it(self):
        demo = self.start()
        end = time.monotonic() + 60
        while len(running()) < len(PROGRAMS) and time.monotonic() < end:
            os.sched_yield()
        self.assertEqual(len(running()), len(PROGRAMS))
        demo.kill()
        demo.wait()
        self.assert_nothing_left()

    def test_seconds_bound_the_run(self):
        demo = self.start("--seconds", "6")
        text, _ = demo.communicate(timeout=60)
        self.assert_nothing_left()
        self.assertTrue((self.out / "summary.json").exists(), text)
        summary = json.loads((self.out / "summary.json").read_text())
        self.assertEqual(summary["result"], "incomplete", text)

    def test_wrong_arguments_print_the_usage(self):
        for arguments in (["--warp"], ["--seconds", "soon"], ["--bus"]):
            ended = subprocess.run([ROOT / "scripts/demo", *arguments], capture_output=True,
                                   text=True, timeout=20, check=False)
            self.assertEqual(ended.returncode, 2, ended)
            self.assertIn("usage", ended.stderr)
        ended = subprocess.run([ROOT / "scripts/demo", "--no-install", "--bus", "smoke:signal"],
                               capture_output=True, text=True, timeout=60, check=False)
        self.assertNotEqual(ended.returncode, 0)
        self.assertIn("smoke", ended.stdout + ended.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
