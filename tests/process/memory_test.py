#!/usr/bin/python3
"""What the simulator takes of a computer's memory, while it loads and while it runs."""

import re
import sys
import unittest

from programs import Chain

LIMIT_MB = 200


class Memory(unittest.TestCase):
    def test_simulator_with_cameras_stays_below_the_limit_from_its_start_on(self):
        with Chain("no bus", programs=("eod-sim",), cameras=True) as chain:
            sim = chain["eod-sim"]
            sim.ended_within(3)  # some hundred pictures
            with open(f"/proc/{sim.process.pid}/status", encoding="utf-8") as status:
                most_kb = int(re.search(r"^VmHWM:\s+(\d+) kB$", status.read(), re.MULTILINE)[1])
            self.assertEqual(sim.end(), 0)
            pictures = int(re.search(r"(\d+) pictures", sim.text())[1])
        self.assertGreater(pictures, 20)
        self.assertLess(most_kb / 1024, LIMIT_MB)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
