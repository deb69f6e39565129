#!/usr/bin/python3
"""What the source paper claims holds: paper_claims in small sizes, judged by its raw numbers.

Usage: paper_claims_test.py PROGRAM. Expectations follow from the inputs; times are not looked at.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

MODULES = 5
MOTIONS = 22
STARTS = 50
TOUCH_MM = 1e-6  # rounding of positions some metres from the origin


def measured(program):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "claims.json"
        subprocess.run([program, "--json", file, "--rounds", "0", "--frames", "300", "--triangles",
                        "10000,100000", "--starts", str(STARTS), "--mask-frames", "5"], check=True)
        return json.loads(file.read_text(encoding="utf-8"))


class PaperClaims(unittest.TestCase):
    claims = {}

    def test_masks_leave_a_fifth_of_five_equal_modules(self):
        counts = self.claims["module_masks"]["counts"]
        self.assertEqual(len(counts), 4)
        for count in counts:
            # A tree has culled modules that stand elsewhere before any mask is asked.
            culled = (count["layout"], count["traversal"]) == ("side_by_side", "block_tree")
            share = count["masked"]["candidates"] / count["unmasked"]["candidates"]
            self.assertAlmostEqual(share, 1 if culled else 1 / MODULES, delta=0.02, msg=str(count))

    def test_a_traversal_without_masks_offers_every_polygon_of_every_module(self):
        masks = self.claims["module_masks"]
        for count in masks["counts"]:
            work = count["unmasked"]
            every = work["segments"] * masks["triangles_each"] * MODULES
            if count["traversal"] == "every_polygon":
                # But for the few that only the other kind of segment looks for: a bar is stood on by
                # another proxy than it is run into.
                self.assertLessEqual(work["candidates"], every)
                self.assertGreater(work["candidates"], 0.99 * every)
            else:
                self.assertLess(work["candidates"], every / 100)

    def test_neither_masks_nor_the_tree_change_an_answer(self):
        self.assertTrue(all(c["same_answers"] for c in self.claims["module_masks"]["counts"]))

    def test_dynamic_loading_casts_about_a_third(self):
        loading = self.claims["dynamic_loading"]
        for coverage in ("paper", "extended"):
            count = loading[coverage]
            cast = [motion["always"] + motion["loaded"] for motion in count["motions"]]
            self.assertEqual(len(cast), MOTIONS)
            self.assertLess(max(cast), count["all"])
            self.assertAlmostEqual(sum(cast) / MOTIONS / count["all"], 1 / 3, delta=0.05)

    def test_whole_isectors_count_as_the_design_says(self):
        wheels, hands, tripod = 4 * 6, 3 * 3, 3
        whole = self.claims["dynamic_loading"]["whole_isectors"]
        expected = [wheels // 2 + hands + tripod, wheels // 2 + tripod]  # forward, reverse
        expected += [wheels + hands + tripod] * 2                        # turns
        expected += [wheels // 2 + tripod] * 4                           # flippers
        expected += [hands] * 10 + [0] * 4                               # arm, gripper; camera
        self.assertEqual(whole["all"], wheels + hands + tripod)
        self.assertEqual(whole["motions"], expected)

    def test_a_fixed_distance_penetrates_by_what_a_step_is_longer(self):
        for series in self.claims["stop_gap"]:
            for gap in series["fixed"]:
                step = gap["speed_mps"] * series["dt_ms"]
                self.assert_gaps(gap, series["d0_mm"] - step, series["d0_mm"])
        slow_frames = self.claims["stop_gap"][0]
        top_speed = slow_frames["fixed"][66]
        self.assertEqual((slow_frames["dt_ms"], top_speed["speed_mps"]), (40, 0.67))
        # 26.8 mm a step less 20 mm, to half a place of the starts.
        self.assertAlmostEqual(top_speed["worst_mm"], -6.8, delta=26.8 / STARTS)

    def test_eq_2_never_penetrates(self):
        for series in self.claims["stop_gap"]:
            for gap in series["eq2"]:
                self.assertGreaterEqual(gap["worst_mm"], -TOUCH_MM)

    def test_eq_2_keeps_the_gap_on_both_sides_of_its_jump(self):
        for series in self.claims["stop_gap"]:
            d0, v0 = series["d0_mm"], series["v0_mps"]
            self.assertAlmostEqual(v0, d0 / series["dt_ms"])
            self.assertLess(series["below_v0"]["speed_mps"], v0)
            self.assertGreater(series["above_v0"]["speed_mps"], v0)
            for gap in [*series["eq2"], series["below_v0"], series["above_v0"]]:
                speed = gap["speed_mps"]
                if abs(speed - v0) < 1e-9 * v0:
                    continue  # either side is right
                step = speed * series["dt_ms"]
                least = d0 - step if speed < v0 else d0
                self.assert_gaps(gap, least, least + step)

    def assert_gaps(self, gap, least, most):
        """All stops of one speed lie in [least, most], and reach both ends to a place of the starts."""
        place = (most - least) / STARTS
        self.assertGreaterEqual(gap["worst_mm"], least - TOUCH_MM)
        self.assertLess(gap["worst_mm"], least + place)
        self.assertLessEqual(gap["largest_mm"], most + TOUCH_MM)
        self.assertGreater(gap["largest_mm"], most - place)
        self.assertAlmostEqual(gap["mean_mm"], (least + most) / 2, delta=place)

    def test_work_does_not_grow_with_the_scene(self):
        small, large = self.claims["scene_cost"]
        self.assertEqual(large["triangles"], 10 * small["triangles"])
        # The larger scene is also denser where the robot drives, and may cost that much more.
        denser = large["path_triangles_per_m2"] / small["path_triangles_per_m2"]
        for what in ("blocks", "candidates", "exact"):
            self.assertLess(large["drive"][what], denser * small["drive"][what], what)


if __name__ == "__main__":
    PaperClaims.claims = measured(sys.argv.pop(1))
    unittest.main()
