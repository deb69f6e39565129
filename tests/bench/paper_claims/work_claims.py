"""The claims that are counts of work: module masks, dynamic loading, size of the scene.

Each class takes the raw numbers of paper_claims and gives a section of the page and a row of its summary.
"""

from wording import number, percent, verdict


class Masks:
    def __init__(self, claims):
        self.all = claims["module_masks"]
        self.by = {(c["layout"], c["traversal"]): c for c in self.all["counts"]}
        self.same = all(c["same_answers"] for c in self.all["counts"])

    def share(self, layout, traversal):
        count = self.by[layout, traversal]
        return count["masked"]["candidates"] / count["unmasked"]["candidates"]

    def row(self, layout, traversal, label):
        count = self.by[layout, traversal]
        segments = count["masked"]["segments"]
        digits = 0 if traversal == "every_polygon" else 2
        cells = [number(count[k]["candidates"] / segments, digits) for k in ("unmasked", "masked")]
        blocks = [number(count[k]["blocks"] / segments, 2) for k in ("unmasked", "masked")]
        if traversal == "every_polygon":
            blocks = ["-", "-"]
        cells += [percent(self.share(layout, traversal), 1), *blocks]
        return f"| {label} | " + " | ".join(cells) + " |"

    def text(self):
        return f"""
## Masks by module (分块设置掩码)

Claim: with five equal modules, masks leave a fifth of the work.

![Candidates with module masks](paper_claims/module_masks.svg)

Five copies of the shipped flat module ({number(self.all['triangles_each'])} polygons each), every copy with a module
bit of its own. The robot drives forward to the wall, and its isectors are cast from {self.all['frames']} places of that
drive. A *candidate* is a polygon that is offered to a segment; the numbers are means a segment.

| five equal modules | candidates without masks | with masks | share | blocks opened without | with |
|---|---|---|---|---|---|
{self.row("one_place", "every_polygon", "in one place, every polygon tried")}
{self.row("one_place", "block_tree", "in one place, the product's tree")}
{self.row("side_by_side", "every_polygon", "side by side, every polygon tried")}
{self.row("side_by_side", "block_tree", "side by side, the product's tree")}

**What it means.** The claim is one of arithmetic: a traversal that tries every polygon of every module is left with
one module of five, wherever the modules stand. The product tries no such thing. Its tree keeps each class in branches
of its own, so a mask still leaves a fifth where modules lie in one place. But side by side in a world of 3000 x 3000 m
({number(self.all['spacing_m'])} m from one to the next), the tree alone has culled the other modules before any mask is
asked: there masks save {percent(1 - self.share("side_by_side", "block_tree"))} of the candidates. **In a real world
masks no longer matter for speed, only for meaning**: which module a segment may hit, and which kind of thing in it.
What
saves work is the tree: it leaves 1 candidate in {number(self.tree_gain())}. (With masks in force the simulator does
not even load the other modules into the world that its robot drives in.)

{'All of these casts gave the same range for every segment.' if self.same else
 '**Some of these casts gave other ranges.**'}
"""

    def tree_gain(self):
        slow, quick = (self.by["side_by_side", t]["masked"]["candidates"]
                       for t in ("every_polygon", "block_tree"))
        return slow / quick

    def summary(self):
        places = [self.share("one_place", t) for t in ("every_polygon", "block_tree")]
        return (f"| masks by module (分块设置掩码) | 20 % of the candidates, five equal modules | "
                f"{percent(places[0], 1)} in one place; {percent(self.share('side_by_side', 'block_tree'))}"
                f" side by side below our tree | "
                f"{verdict(all(abs(share - 0.2) <= 0.02 for share in places))}, in one place |")


class Loading:
    def __init__(self, claims):
        self.counts = claims["dynamic_loading"]

    def cast(self, coverage):
        count = self.counts[coverage]
        if coverage == "whole_isectors":
            return count["motions"]
        return [motion["always"] + motion["loaded"] for motion in count["motions"]]

    def mean(self, coverage):
        return sum(self.cast(coverage)) / len(self.cast(coverage))

    def share(self, coverage):
        return self.mean(coverage) / self.counts[coverage]["all"]

    def row(self, coverage, label):
        cast, count = self.cast(coverage), self.counts[coverage]
        return (f"| {label} | {count['all']} | {self.mean(coverage):.1f} | "
                f"{percent(self.share(coverage))} | {min(cast)} to {max(cast)} |")

    def loaded_row(self, coverage):
        count = self.counts[coverage]
        loaded = [motion["loaded"] for motion in count["motions"]]
        every, mean = count["all"] - count["all_always"], sum(loaded) / len(loaded)
        return (f"| the same without TRIPOD and LOS_FRONT | {every} | {mean:.1f} | "
                f"{percent(mean / every)} | {min(loaded)} to {max(loaded)} |")

    def text(self):
        always = self.counts["paper"]["all_always"]
        return f"""
## Dynamic loading (动态加载)

Claim: an isector is cast only while a motion is commanded that needs it, which leaves about a third of the segments.

![Segments cast by motion](paper_claims/dynamic_loading.svg)

| counted | segments in all | mean of 22 motions | share | least to most |
|---|---|---|---|---|
{self.row("whole_isectors", "by whole isectors: TRIPOD and seven BUMPs")}
{self.row("paper", "shipped robot, coverage *paper*")}
{self.loaded_row("paper")}
{self.row("extended", "shipped robot, coverage *extended*")}
{self.loaded_row("extended")}

*By whole isectors* means the paper's set, each with all its lines or not at all, TRIPOD only while the chassis or a
flipper moves, and no line of sight: {percent(1 - self.share('whole_isectors'))} less. The shipped robot differs in three things:

- TRIPOD and LOS_FRONT are cast in every step, {always} segments: the robot stands on the one, and the other gives the
  clearance ahead. A camera motion therefore costs {self.cast('paper')[18]}, not {self.cast('whole_isectors')[18]}.
- LOS_FRONT and LOS_REAR are there at all; LOS_REAR is loaded by *reverse*.
- The downward lines of the wheels are loaded line by line, only while their flipper goes down: they touch the ground
  all the time. So *forward* casts {self.counts['paper']['motions'][0]['loaded']} lines beside the {always}, where
  whole isectors make {self.cast('whole_isectors')[0]}, TRIPOD included.

The mean hides one thing: turning needs nearly all lines ({self.cast('paper')[2]} of {self.counts['paper']['all']};
{self.cast('extended')[2]} of {self.counts['extended']['all']}), so the worst step is hardly cheaper.
"""

    def summary(self):
        shares = [self.share(c) for c in ("whole_isectors", "paper", "extended")]
        return (f"| dynamic loading (动态加载) | about a third of the segments | "
                f"{percent(shares[0])} by whole isectors; {percent(shares[1])} (coverage paper), "
                f"{percent(shares[2])} (extended) | "
                f"{verdict(all(abs(share - 1 / 3) < 0.05 for share in shares))} |")


class Scenes:
    def __init__(self, claims):
        self.scenes, self.machine = claims["scene_cost"], claims["machine"]
        self.timed = all(scene["round_ns_per_segment"] for scene in self.scenes)

    def work(self, scene, what):
        return scene["drive"][what] / scene["frames"]

    def row(self, scene):
        cells = [number(scene["triangles"]), number(scene["path_triangles_per_m2"])]
        cells += [number(self.work(scene, what), 1) for what in ("blocks", "candidates", "exact")]
        cells.append(number(min(scene["round_ns_per_segment"]), 1) if self.timed else "-")
        return "| " + " | ".join(cells) + " |"

    def growth(self):
        """(how many times larger, denser, more candidates) the last scene is than the first."""
        first, last = self.scenes[0], self.scenes[-1]
        return (last["triangles"] / first["triangles"],
                last["path_triangles_per_m2"] / first["path_triangles_per_m2"],
                self.work(last, "candidates") / self.work(first, "candidates"))

    def text(self):
        rows = "\n".join(self.row(scene) for scene in self.scenes)
        larger, denser, more = self.growth()
        text = f"""
## Cost against scene size

Not a claim of the paper, but the reason why masks are no longer needed for speed.

![Work of a frame over scene size](paper_claims/scene_counts.svg)

The scenes and the drive of `isector_bench`: {self.scenes[0]['lines_per_frame']} short segments a frame (TRIPOD and ten
BUMPs), {number(self.scenes[0]['frames'])} frames past walls, stairs and clutter.

| triangles | near the path, a m² | blocks a frame | candidates a frame | exact tests a frame | best ns a segment |
|---|---|---|---|---|---|
{rows}

{number(larger)} times the triangles, which are also {denser:.1f} times as dense where the robot drives, make
{more:.2f} times the candidates.
"""
        if not self.timed:
            return text
        return text + f"""
![Time a segment over scene size](paper_claims/scene_time.svg)

Times are of the machine at hand, one thread of {self.machine['processor']} that others share, {self.machine['compiler']};
they are for comparing sizes with each other. `scripts/bench` compares them with other engines, and
`scripts/claims -- --triangles 10000,100000,1000000,10000000` goes to ten million triangles.
"""

    def summary(self):
        larger, denser, more = self.growth()
        return (f"| (ours) cost against scene size | flat | {more:.2f} times the candidates for "
                f"{number(larger)} times the triangles | {verdict(more < denser)} |")
