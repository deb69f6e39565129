#!/usr/bin/python3
"""Whatever is wrong at start-up, a program says it in one line with the remedy and writes nothing.

Exit status 2 for a wrong command line, 1 for everything else.
"""

import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest

from programs import BIN, ROOT

DBC = ROOT / "dbc" / "control_box.dbc"
MAP = ROOT / "dbc" / "control_box.map.toml"
ROBOT = ROOT / "sim" / "robots" / "eod_robot.sdf"
WORLD = ROOT / "sim" / "worlds" / "training_ground.sdf"
SCENARIO = ROOT / "sim" / "scenarios" / "flat_first_drive.toml"
BUS = "udp:239.74.163.2:43113"


class BadInput(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refuse(self, status, pattern, program, *arguments, **environment):
        """The program must end with `status` and one line on stderr that matches `pattern`."""
        ended = subprocess.run([BIN / program, *arguments], capture_output=True, text=True,
                               timeout=20, stdin=subprocess.DEVNULL,
                               env={**os.environ, **environment}, check=False)
        self.assertEqual(ended.returncode, status, ended.stderr)
        lines = [line for line in ended.stderr.splitlines() if line]
        if status == 1:
            self.assertEqual(len(lines), 1, ended.stderr)
        self.assertRegex(lines[0], pattern)
        self.assertTrue(lines[0].startswith(program + ": "), lines[0])

    def broken(self, original, old, new):
        """A copy of a file with one thing wrong; gives its path and the line that is wrong."""
        text = original.read_text()
        self.assertIn(old, text)
        path = self.folder / original.name
        path.write_text(text.replace(old, new, 1))
        return path, text[:text.index(old)].count("\n") + 1

    def test_unknown_option_prints_the_usage(self):
        for program in ("eod-box", "eod-canbridge", "eod-sim", "eod-recorder", "eod-console"):
            with self.subTest(program=program):
                self.refuse(2, "--warp", program, "--warp", "9")

    def test_missing_files_are_named(self):
        for program, option in (("eod-box", "--dbc"), ("eod-box", "--map"), ("eod-box", "--script"),
                                ("eod-canbridge", "--dbc"), ("eod-canbridge", "--map"),
                                ("eod-sim", "--world"), ("eod-sim", "--robot"),
                                ("eod-sim", "--scenario")):
            with self.subTest(program=program, option=option):
                bus = () if program == "eod-sim" else ("--bus", BUS)
                self.refuse(1, "nowhere/at.all", program, *bus, option,
                            str(self.folder / "nowhere/at.all"))

    def test_broken_dbc_names_file_line_and_column(self):
        path, line = self.broken(DBC, "16|1@1+ (1,0) [0|1] \"\" ROBOT", "16|1@7+ (1,0) [0|1] \"\" ROBOT")
        self.refuse(1, f"{path}:{line}:[0-9]+: ", "eod-canbridge", "--bus", BUS, "--dbc", str(path))

    def test_map_that_names_an_unknown_signal_gives_the_line(self):
        path, line = self.broken(MAP, "M01_DriveFwd", "M01_DriveFwdd")
        self.refuse(1, f"{path}:{line}.*M01_DriveFwdd", "eod-canbridge", "--bus", BUS, "--dbc",
                    str(DBC), "--map", str(path))

    def test_map_that_is_not_toml_gives_the_line(self):
        path = self.folder / "bad.map.toml"
        path.write_text("a = 1\nb = = 2\n")
        self.refuse(1, f"{path}:2", "eod-canbridge", "--bus", BUS, "--map", str(path))

    def test_broken_world_and_robot_give_the_line(self):
        for option, original in (("--world", WORLD), ("--robot", ROBOT)):
            with self.subTest(option=option):
                path = self.folder / original.name
                path.write_text("<?xml version='1.0'?>\n<sdf version='1.9'>\n<model name='a'>\n")
                self.refuse(1, f"{path}:[0-9]+", "eod-sim", "--no-cameras", option, str(path))

    def test_scenario_with_an_unknown_key_names_the_nearest(self):
        path, line = self.broken(SCENARIO, "par_time_s", "par_tme_s")
        self.refuse(1, f"{path}:{line}.*par_tme_s.*par_time_s", "eod-sim", "--no-cameras",
                    "--scenario", str(path))

    def test_scenario_name_that_is_unknown_names_the_nearest(self):
        self.refuse(1, "'slope_frist'.*'slope_first'", "eod-sim", "--no-cameras", "--scenario",
                    "slope_frist")

    def test_broken_scenarios_of_a_folder_give_the_line(self):
        path, line = self.broken(SCENARIO, "distance_m = 0.5", "distance_m = -5")
        self.refuse(1, f"{path}:{line}.*distance_m = -5", "eod-sim", "--list", "--scenarios",
                    str(self.folder))

    def test_operator_script_with_an_unknown_action_gives_the_line(self):
        path = self.folder / "bad.boxscript"
        path.write_text("key operate\nlevitate 3s\n")
        self.refuse(1, f"{path}:2.*levitate", "eod-box", "--bus", BUS, "--script", str(path))

    def test_bus_urls(self):
        for url, pattern in (("smoke:signal", "smoke"), ("udp:239.74.163.2", "udp:"),
                             ("udp:10.0.0.1:43113", "multicast"), ("udp:239.74.163.2:99999", "99999"),
                             ("socketcan:nosuchcan0", "nosuchcan0|AF_CAN")):
            with self.subTest(url=url):
                self.refuse(1, pattern, "eod-canbridge", "--bus", url)

    def test_occupied_port_is_named(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            other.bind(("239.74.163.2", 43113))
            self.refuse(1, "43113.*(in use|used)", "eod-canbridge", "--bus", BUS)

    def test_no_multicast_route_names_the_command(self):
        hide = ["unshare", "-rn", "sh", "-c", "ip link set lo up; exec \"$0\" \"$@\""]
        for program in ("eod-sim", "eod-canbridge", "eod-box"):
            with self.subTest(program=program):
                arguments = ["--no-cameras"] if program == "eod-sim" else ["--bus", BUS]
                ended = subprocess.run([*hide, BIN / program, *arguments], capture_output=True,
                                       text=True, timeout=20, check=False)
                self.assertEqual(ended.returncode, 1, ended.stderr)
                self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
                self.assertIn("ip route add 224.0.0.0/4 dev lo", ended.stderr)

    def test_broken_lcm_url(self):
        self.refuse(1, "carrier-pigeon", "eod-sim", "--no-cameras", "--lcm-url", "carrier-pigeon://x")

    def test_numbers_outside_their_range(self):
        self.refuse(2, "period|rate", "eod-sim", "--no-cameras", "--rate", "5000")

    def test_output_folder_that_cannot_be_written(self):
        blocked = self.folder / "file"
        blocked.write_text("in the way")
        self.refuse(1, str(blocked), "eod-recorder", "--bus", BUS, "--out", str(blocked / "out"))
        self.assertEqual(blocked.read_text(), "in the way")

    def test_lockstep_replay_of_a_broken_log_gives_the_line_and_leaves_nothing(self):
        log = self.folder / "in.log"
        log.write_text("(0.000000) vcan0 190#98200511C8007810\n(0.02) vcan0 nonsense\n")
        out = self.folder / "out"
        self.refuse(1, f"{log}:2", "eod-sim", "--lockstep", "--scenario", str(SCENARIO), "--can-log",
                    str(log), "--out", str(out))
        self.assertFalse(out.exists())


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
