#!/usr/bin/python3
"""eod-sim batch as a user starts it: how it ends, how it is interrupted, how it goes on."""

import json
import pathlib
import signal
import subprocess
import tempfile
import unittest

from programs import BIN, Program

POWER_UP = """wait state standby within 3s
key operate
deadman enabled
wait link up within 5s
reset
start
wait robot operate within 3s
menu module flat
menu start
wait mission run within 5s
"""
SCENARIO = """name = "short"
module = 1
[[step]]
kind = "reach"
x_m = 0
y_m = 1
tolerance_m = 0.1
text = "Go"
"""


class Batch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name in ("scenarios", "scripts"):
            (self.folder / name).mkdir()
        (self.folder / "scenarios/short.toml").write_text(SCENARIO)
        self.put_script("short", POWER_UP + "drive to 0 1 within 30s\nwait 3s\n")

    def put_script(self, name, text):
        (self.folder / f"scripts/{name}.boxscript").write_text(text)

    def arguments(self, out, *more):
        return ("batch", "--scenarios", str(self.folder / "scenarios"), "--scripts",
                str(self.folder / "scripts"), "--out", str(self.folder / out), *more)

    def batch(self, out, *more):
        return subprocess.run([BIN / "eod-sim", *self.arguments(out, *more)], timeout=100,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def results(self, out):
        return (self.folder / out / "results.csv").read_bytes()

    def test_ends_well_when_every_run_ended_as_expected(self):
        run = self.batch("out", "--repeat", "8", "--jobs", "2")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("8 of 8", run.stdout)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertTrue(summary["scenarios"][0]["allows_claim"])

    def test_status_1_says_how_many_runs_did_not(self):
        self.put_script("short.lost", "# expect: failure exploded\nfail \"lost\"\n")
        run = self.batch("out", "--repeat", "2")
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn("short.lost repetition 1: script, expected failure exploded: "
                      "short.lost.boxscript:2: fail \"lost\": lost", run.stdout)
        self.assertIn("eod-sim: 2 of 4 runs did not end as expected", run.stdout)
        self.assertEqual(len(self.results("out").splitlines()), 1 + 4)

    def test_usage_and_data_errors(self):
        self.assertEqual(self.batch("out", "--repeat", "0").returncode, 2)
        wrong = self.batch("out", "--shard", "3/3")
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("'3/3': I/N with I from 0", wrong.stdout)
        self.put_script("short.b", "# Nothing is said\n")
        wrong = self.batch("out")
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("short.b.boxscript:1: '# Nothing is said': allowed: # expect:", wrong.stdout)

    def end_and_go_on(self, how):
        """Ends a batch with a signal after its first runs; the same command does the rest."""
        more = ("--repeat", "300", "--jobs", "2")
        runs = self.folder / "ended/runs"
        batch = Program("eod-sim", *self.arguments("ended", *more), folder=self.folder)
        batch.wait_until(lambda: len(list(runs.glob("*.json"))) >= 5, "five runs are done")
        status = batch.end(how)
        done = len(list(runs.glob("*.json")))
        self.assertLess(done, 300)
        self.assertFalse((self.folder / "ended/results.csv").exists())
        again = self.batch("ended", *more)
        self.assertEqual(again.returncode, 0, again.stdout)
        self.assertIn(f"300 of 300 runs ({done} found done)", again.stdout)
        self.assertEqual(self.batch("whole", *more).returncode, 0)
        self.assertEqual(self.results("ended"), self.results("whole"))
        return status, done, batch.text()

    def test_ctrl_c_keeps_what_is_done_and_says_how_to_go_on(self):
        status, done, text = self.end_and_go_on(signal.SIGINT)
        self.assertEqual(status, 1)
        self.assertIn(f"eod-sim: interrupted: {done} of 300 runs are done and kept; the same "
                      "command goes on", text)

    def test_a_killed_batch_goes_on(self):
        status, _, _ = self.end_and_go_on(signal.SIGKILL)
        self.assertEqual(status, -signal.SIGKILL)


if __name__ == "__main__":
    unittest.main(verbosity=2)
