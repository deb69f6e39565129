#!/usr/bin/python3
"""A batch as a Slurm job array gives the same results as on one machine without it."""

import pathlib
import subprocess
import tempfile
import unittest

from programs import BIN, ROOT
from slurm import Cluster

ARGUMENTS = ("--only", "bomb_ground_m", "--repeat", "3")
SHARDS = 3


def batch(*arguments):
    return subprocess.run([BIN / "eod-sim", *arguments], stdin=subprocess.DEVNULL, timeout=200,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


class JobArray(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_array(self, cluster, array, **environment):
        cluster.environment.update(EOD_SIM=str(BIN / "eod-sim"), **environment)
        job = cluster.submit(f"--array={array}", "--output", f"{self.folder}/task-%a.log",
                             str(ROOT / "scripts/batch.sbatch"), str(self.folder / "cluster"),
                             *ARGUMENTS, cwd=ROOT)
        cluster.wait_for_job(job)
        return "\n".join(log.read_text() for log in sorted(self.folder.glob("task-*.log")))

    def merge(self):
        shards = sorted((self.folder / "cluster").glob("shard-*"))
        return batch("merge", *shards, "--out", self.folder / "cluster")

    def test_merged_shards_are_the_unsharded_batch(self):
        with Cluster() as cluster:
            text = self.run_array(cluster, f"0-{SHARDS - 1}")
            self.assertEqual(len(list((self.folder / "cluster").glob("shard-*"))), SHARDS, text)
            merged = self.merge()
            self.assertEqual(merged.returncode, 0, merged.stdout + text)

            # One task that is lost and submitted again alone goes on where it was.
            lost = self.folder / "cluster/shard-1/runs"
            kept = sorted(lost.iterdir())
            kept.pop().unlink()
            self.assertEqual(self.merge().returncode, 1)
            text = self.run_array(cluster, "1", SHARDS=str(SHARDS))
            self.assertIn(f"({len(kept)} found done)", text)
            merged = self.merge()
            self.assertEqual(merged.returncode, 0, merged.stdout + text)

        alone = batch("batch", *ARGUMENTS, "--out", self.folder / "alone")
        self.assertEqual(alone.returncode, 0, alone.stdout)
        for name in ("results.csv", "summary.json"):
            self.assertEqual((self.folder / "cluster" / name).read_bytes(),
                             (self.folder / "alone" / name).read_bytes(), name)
        self.assertEqual(len((self.folder / "alone/results.csv").read_text().splitlines()), 1 + 6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
