"""The plots of docs/paper_claims.md: each function draws one from the raw numbers of paper_claims.

The same numbers give the same files with the same matplotlib.
"""

import statistics

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

# Okabe and Ito's colours: to be told apart by everyone, and in grey.
BLUE, ORANGE, GREEN, GREY, BLACK = "#0072B2", "#D55E00", "#009E73", "#9A9A9A", "#222222"
TOP_SPEED = 0.67  # [m/s] of the robot
MOTIONS = ("forward", "reverse", "turn left", "turn right", "front flipper up", "front flipper down",
           "rear flipper up", "rear flipper down", "big arm up", "big arm down", "small arm up",
           "small arm down", "wrist up", "wrist down", "gripper ccw", "gripper cw", "gripper open",
           "gripper close", "camera left", "camera right", "camera up", "camera down")

plt.rcParams.update({
    "svg.hashsalt": "paper_claims", "svg.fonttype": "path", "font.family": "DejaVu Sans",
    "font.size": 10, "axes.titlesize": 11, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "axes.edgecolor": BLACK, "figure.facecolor": "white", "savefig.facecolor": "white"})


def save(figure, file):
    figure.savefig(file, metadata={"Date": None, "Creator": None})
    plt.close(figure)


def module_masks(claims, file):
    """Share of candidates that masks leave, by layout and traversal."""
    rows = {("one_place", "every_polygon"): "five modules in one place,\nevery polygon tried",
            ("one_place", "block_tree"): "five modules in one place,\ntree of blocks",
            ("side_by_side", "every_polygon"): "five modules side by side,\nevery polygon tried",
            ("side_by_side", "block_tree"): "five modules side by side,\ntree of blocks"}
    counts = {(c["layout"], c["traversal"]): c for c in claims["module_masks"]["counts"]}
    segments = claims["module_masks"]["counts"][0]["masked"]["segments"]
    figure, axes = plt.subplots(figsize=(8.4, 3.7), layout="constrained")
    for place, (key, label) in enumerate(rows.items()):
        masked, unmasked = (counts[key][k]["candidates"] for k in ("masked", "unmasked"))
        share = 100 * masked / unmasked
        axes.barh(place, share, color=BLUE if share < 50 else ORANGE, height=0.6)
        digits = 0 if masked > 100 * segments else 1
        axes.text(share + 1.5, place, f"{share:.0f} %   ({unmasked / segments:,.{digits}f} → "
                  f"{masked / segments:,.{digits}f} a segment)", va="center")
    axes.axvline(20, color=BLACK, linestyle="--", linewidth=1)
    axes.text(20.8, -0.62, "a fifth", va="center")
    axes.set_yticks(range(len(rows)), list(rows.values()))
    axes.set_ylim(len(rows) - 0.5, -0.9)
    axes.set_xlim(0, 156)
    axes.set_xticks(range(0, 101, 20))
    axes.set_xlabel("candidates with module masks, % of those without")
    axes.set_title("Masks leave a fifth, unless a tree has culled the other modules before")
    save(figure, file)


def dynamic_loading(claims, file):
    """Segments cast by motion, for both coverages."""
    figure, panels = plt.subplots(2, 1, figsize=(9, 7.2), sharex=True, layout="constrained")
    places = range(len(MOTIONS))
    for axes, coverage in zip(panels, ("paper", "extended")):
        count = claims["dynamic_loading"][coverage]
        always = [motion["always"] for motion in count["motions"]]
        loaded = [motion["loaded"] for motion in count["motions"]]
        mean = (sum(always) + sum(loaded)) / len(MOTIONS)
        axes.bar(places, always, color=GREY, width=0.7, label="always cast: TRIPOD, LOS_FRONT")
        axes.bar(places, loaded, bottom=always, color=BLUE, width=0.7, label="loaded by the motion")
        for place, total in enumerate(a + b for a, b in zip(always, loaded)):
            axes.text(place, total + 0.035 * count["all"], str(total), ha="center", fontsize=9,
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6})
        axes.axhline(count["all"], color=BLACK, linewidth=1.2, label="without dynamic loading")
        axes.axhline(mean, color=ORANGE, linestyle="--", linewidth=1.4, zorder=0.5,
                     label="mean of 22 motions")
        axes.set_xlim(-0.7, len(MOTIONS) - 0.3)
        axes.set_ylim(0, 1.42 * count["all"])
        axes.set_ylabel("segments cast in a step")
        axes.set_title(f"Coverage {coverage}: on average {mean:.1f} of {count['all']} segments, "
                       f"{100 * mean / count['all']:.0f} %")
        axes.legend(ncols=4, loc="upper left", fontsize=8.5, columnspacing=1.2, handlelength=1.6)
    labels = [f"M{i + 1:02} {name}" for i, name in enumerate(MOTIONS)]
    panels[-1].set_xticks(places, labels, rotation=55, ha="right", rotation_mode="anchor", fontsize=9)
    panels[-1].set_xlabel("motion commanded, alone")
    save(figure, file)


def stop_gap(claims, file):
    """Worst and mean gap over speed, one panel a frame time."""
    names = {40: "25 Hz", 17: "60 Hz", 4: "250 Hz, as shipped"}
    figure, panels = plt.subplots(1, 3, figsize=(11, 4.9), sharey=True)
    figure.subplots_adjust(left=0.065, right=0.98, top=0.85, bottom=0.21, wspace=0.08)
    for axes, series in zip(panels, claims["stop_gap"]):
        v0 = series["v0_mps"]
        axes.axhspan(-60, 0, color=ORANGE, alpha=0.10, linewidth=0)
        axes.axhline(0, color=BLACK, linewidth=1)
        # Lines are broken at the jump of Eq. 2: nothing lies between its sides.
        for law, colour, label in (("fixed", ORANGE, "fixed D0"), ("eq2", BLUE, "Eq. 2")):
            parts = [series[law]]
            if law == "eq2":
                parts = [[g for g in series[law] if g["speed_mps"] < v0],
                         [g for g in series[law] if g["speed_mps"] > v0]]
            for part, gaps in enumerate(parts):
                speeds = [gap["speed_mps"] for gap in gaps]
                for key, style in (("worst_mm", "-"), ("mean_mm", ":")):
                    what = f"{label}, {'worst' if key == 'worst_mm' else 'mean'}"
                    axes.plot(speeds, [gap[key] for gap in gaps], style, color=colour,
                              linewidth=2 if law == "eq2" else 4, alpha=1 if law == "eq2" else 0.55,
                              label=what if part == 0 else None)
        if v0 < 1.5:
            axes.axvline(v0, color=BLACK, linestyle="--", linewidth=1)
            axes.text(v0 - 0.03, 63, f"V0 = {v0:.1f} m/s", ha="right")
        else:
            axes.text(0.75, 63, f"V0 = {v0:.0f} m/s, far beyond", ha="center")
        axes.set_title(f"{series['dt_ms']:.3g} ms a frame ({names[round(series['dt_ms'])]})")
        axes.set_xlim(0, 1.5)
        axes.set_xticks((0, 0.5, 1, 1.5), ("0", "0.5", "1", "1.5"))
        axes.set_ylim(-45, 69)
        axes.set_xlabel("speed v [m/s]")
    panels[0].set_ylabel("gap at which the robot stops [mm]")
    top = next(gap for gap in claims["stop_gap"][0]["fixed"] if gap["speed_mps"] == TOP_SPEED)
    panels[0].plot(TOP_SPEED, top["worst_mm"], "o", color=BLACK, markersize=5)
    panels[0].annotate(f"{top['worst_mm']:.1f} mm\nat {TOP_SPEED} m/s".replace("-", "\N{MINUS SIGN}"),
                       (TOP_SPEED, top["worst_mm"]), (0.44, -15), ha="right", va="top",
                       arrowprops={"arrowstyle": "-", "color": BLACK, "linewidth": 0.8})
    panels[2].text(0.75, -24, "inside the wall", ha="center", color=ORANGE)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=4)
    figure.suptitle("With Eq. 2 no robot stops inside the wall; with a fixed D0 of "
                    f"{claims['stop_gap'][0]['d0_mm']:.0f} mm it does beyond V0", x=0.01, ha="left",
                    fontsize=12, fontweight="bold")
    save(figure, file)


def scene_counts(claims, file):
    """Work a frame over the size of the scene."""
    scenes = claims["scene_cost"]
    sizes = [scene["triangles"] for scene in scenes]
    lines = scenes[0]["lines_per_frame"]
    figure, axes = plt.subplots(figsize=(8.4, 4.6), layout="constrained")
    axes.loglog(sizes, [lines * size for size in sizes], "--", color=GREY)
    axes.text(sizes[0] * 1.25, lines * sizes[0] * 5.5, "every polygon tried", color="#6A6A6A")
    for key, colour, label, above in (
            ("candidates", BLUE, "candidates: triangles offered to a segment", 9),
            ("blocks", GREEN, "blocks of 16 triangles opened by an isector", 9),
            ("exact", ORANGE, "exact tests", -9)):
        work = [scene["drive"][key] / scene["frames"] for scene in scenes]
        axes.loglog(sizes, work, "o-", color=colour)
        axes.annotate(label, ((sizes[0] * sizes[-1]) ** 0.5, work[0]), (0, above), color=colour,
                      textcoords="offset points", ha="center", va="bottom" if above > 0 else "top")
        for end, value, side in ((0, work[0], "right"), (-1, work[-1], "left")):
            axes.annotate(f"{value:.0f}", (sizes[end], value), (-9 if end == 0 else 9, 0),
                          textcoords="offset points", ha=side, va="center", color=colour)
    axes.set_xlim(sizes[0] * 0.6, sizes[-1] * 1.7)
    axes.set_ylim(2, 3 * lines * sizes[-1])
    axes.set_xlabel("triangles in the scene")
    axes.set_ylabel(f"in a frame of {lines} segments")
    axes.set_title("The work of a frame hardly knows how large the scene is")
    save(figure, file)


def scene_time(claims, file):
    """Time a segment over the size of the scene."""
    scenes = claims["scene_cost"]
    sizes = [scene["triangles"] for scene in scenes]
    best = [min(scene["round_ns_per_segment"]) for scene in scenes]
    median = [statistics.median(scene["round_ns_per_segment"]) for scene in scenes]
    rounds = len(scenes[0]["round_ns_per_segment"])
    figure, axes = plt.subplots(figsize=(8.4, 4), layout="constrained")
    axes.semilogx(sizes, median, "s:", color=GREY, label=f"median of {rounds} rounds")
    axes.semilogx(sizes, best, "o-", color=BLUE, label=f"best of {rounds} rounds")
    for size, value in zip(sizes, best):
        axes.annotate(f"{value:.0f}", (size, value), (0, -8), textcoords="offset points",
                      ha="center", va="top", color=BLUE)
    axes.set_xlim(sizes[0] * 0.7, sizes[-1] * 1.5)
    axes.set_ylim(0, 1.45 * max(median))
    axes.set_xlabel("triangles in the scene")
    axes.set_ylabel("ns a segment")
    axes.legend(loc="upper left", ncols=2)
    axes.set_title(f"{sizes[-1] // sizes[0]} times the triangles, "
                   f"{max(best) / min(best):.1f} times the time at most (one machine, one thread)")
    save(figure, file)


ALL = {"module_masks": module_masks, "dynamic_loading": dynamic_loading, "stop_gap": stop_gap,
       "scene_counts": scene_counts, "scene_time": scene_time}
