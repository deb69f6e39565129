"""The claim that is a distance: where the robot stops with D0 alone, and with Eq. 2."""

import claim_plots
from wording import number, verdict


class Gaps:
    def __init__(self, claims):
        self.series = claims["stop_gap"]
        self.slow = self.series[0]

    def top(self, series, law):
        return next(g for g in series[law] if g["speed_mps"] == claim_plots.TOP_SPEED)

    def worst(self, law):
        return min(gap["worst_mm"] for series in self.series for gap in series[law])

    def row(self, series):
        cells = [number(series["dt_ms"], 1), f"{series['v0_mps']:.1f}"]
        for law in ("fixed", "eq2"):
            gap = self.top(series, law)
            cells += [number(gap["worst_mm"], 1), number(gap["mean_mm"], 1)]
        for side in ("below_v0", "above_v0"):
            gap = series[side]
            cells.append(f"{number(gap['worst_mm'], 1)} to {number(gap['largest_mm'], 1)}")
        return "| " + " | ".join(cells) + " |"

    def text(self):
        rows = "\n".join(self.row(series) for series in self.series)
        d0, speed = self.slow["d0_mm"], claim_plots.TOP_SPEED
        fastest = self.slow["fixed"][-1]
        return f"""
## Stop gap and penetration: D0 against Eq. 2

Claim: a robot that is stopped at a fixed distance D0 gets into the wall when it is faster than V0; with
D = D0 for v ≤ V0 and D = D0 + v dt beyond (Eq. 2), where V0 = D0/dt, it never does.

![Stop gap over speed](paper_claims/stop_gap.svg)

The robot drives at a wall with its flippers level, small wheels first, at {len(self.slow['fixed'])} speeds from
{self.slow['fixed'][0]['speed_mps']} to {fastest['speed_mps']} m/s and from many starts within one step's length. The
gap is from the wheels to the wall [mm], D0 = {number(d0)} mm from their surface (their skin).

| frame [ms] | V0 [m/s] | fixed D0 at {speed} m/s: worst | mean | Eq. 2 at {speed} m/s: worst | mean | Eq. 2 just below V0 | just above |
|---|---|---|---|---|---|---|---|
{rows}

- Fixed D0 at 25 Hz: up to {number(-self.top(self.slow, 'fixed')['worst_mm'], 1)} mm deep at {speed} m/s, the robot's top
  speed, and {number(-fastest['worst_mm'], 1)} mm at {fastest['speed_mps']} m/s: a step's length less D0.
- Eq. 2: the smallest gap of all drives is {number(self.worst('eq2'), 2)} mm. Up to V0 it lies between D0 - v dt and D0, so
  it shrinks to nothing just below V0; beyond, between D0 and D0 + v dt.
- At V0 the law jumps by D0. Both sides of the jump are safe; the robot merely stops farther off when it is a little
  faster.
- At the simulator's own step of {number(self.series[-1]['dt_ms'])} ms V0 is {number(self.series[-1]['v0_mps'])} m/s, so
  Eq. 2 never acts on this robot's wheels: the short step alone keeps them out. It acts on slow frames.
"""

    def summary(self):
        fixed, eq2 = -self.top(self.slow, "fixed")["worst_mm"], self.worst("eq2")
        return (f"| distance factor (Eq. 2) | never penetrates; fixed D0 does beyond V0 | "
                f"Eq. 2: smallest gap {number(eq2, 2)} mm; fixed D0: {number(fixed, 1)} mm deep at "
                f"{claim_plots.TOP_SPEED} m/s, 25 Hz | {verdict(eq2 >= 0 < fixed)} |")
