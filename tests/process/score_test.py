#!/usr/bin/python3
"""The report of a mission by the real programs, live and from what the recorder wrote down."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from programs import BIN, ROOT, Chain

BUS = "udp:239.74.163.2:43113"
SCENARIO = ROOT / "tests/process/score.toml"
SCRIPT = ROOT / "tests/process/score.boxscript"


def score(log, scenario, out):
    return subprocess.run([BIN / "eod-sim", "score", log, "--scenario", scenario, "--out", out],
                          capture_output=True, text=True, timeout=60, check=False)


class Score(unittest.TestCase):
    def test_recorded_mission_has_the_score_of_the_live_one(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            # The recorder starts last but one: what was said before it came is not in its log.
            with Chain(BUS, programs=("eod-sim", "eod-canbridge", "eod-recorder", "eod-box"),
                       eod_sim=("--scenario", str(SCENARIO), "--report", str(folder / "live")),
                       eod_recorder=("--plain", "--out", str(folder / "run")),
                       eod_box=("--script", str(SCRIPT))) as chain:
                live = folder / "live/score.json"
                chain["eod-sim"].wait_until(live.exists, "the report written", 60)
                self.assertEqual(chain["eod-recorder"].end(), 0)
            ended = score(folder / "run/run.lcmlog", SCENARIO, folder / "log")
            self.assertEqual(ended.returncode, 0, ended)
            self.assertEqual((folder / "log/score.json").read_text(), live.read_text())
            self.assertEqual((folder / "log/report.html").read_bytes(),
                             (folder / "live/report.html").read_bytes())
            self.check(json.loads(live.read_text()))
            self.check_refusals(folder)

    def check(self, sheet):
        self.assertEqual((sheet["result"], sheet["steps_done"], sheet["lost_s"]), ("success", 2, 0))
        self.assertEqual({line["item"]: line["result"] for line in sheet["procedure"]},
                         {"lamp_test": "done", "estop_test": "missing"})
        items = {item["item"]: item for part in sheet["parts"] for item in part["items"]}
        self.assertEqual(items["collision"]["amount"], 0)  # the wall was asked for
        self.assertGreater(items["pushing"]["amount"], 0)
        self.assertEqual(items["procedure"]["amount"], 1)

    def check_refusals(self, folder):
        """Each in one line that names the log and what is wrong with it."""
        log = folder / "run/run.lcmlog"
        other = score(log, ROOT / "sim/scenarios/flat_first_drive.toml", folder / "no")
        missing = score(folder / "no.lcmlog", SCENARIO, folder / "no")
        (folder / "empty.lcmlog").touch()
        empty = score(folder / "empty.lcmlog", SCENARIO, folder / "no")
        for ended, what in ((other, "'score' was driven, not 'flat_first_drive'"),
                            (missing, "no such log"), (empty, "no mission in it")):
            self.assertEqual(ended.returncode, 1, ended)
            self.assertEqual(ended.stderr.count("\n"), 1, ended)
            self.assertIn(what, ended.stderr)
        self.assertFalse((folder / "no").exists())


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
