#!/usr/bin/env python3
"""The checked-in training ground is what its generator writes."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

WORLDS = pathlib.Path(__file__).resolve().parents[3] / "sim" / "worlds"


def files(folder):
    found = [folder / "training_ground.sdf", *(folder / "meshes").iterdir()]
    return {str(path.relative_to(folder)): path.read_bytes() for path in found}


class Generator(unittest.TestCase):
    def test_output_is_the_checked_in_world_and_its_meshes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", WORLDS / "make_training_ground.py", "--output", folder],
                           check=True)
            wanted, found = files(pathlib.Path(folder)), files(WORLDS)
        self.assertEqual(sorted(wanted), sorted(found), "run sim/worlds/make_training_ground.py")
        different = [name for name in wanted if wanted[name] != found[name]]
        self.assertEqual(different, [], "run sim/worlds/make_training_ground.py")


if __name__ == "__main__":
    unittest.main()
