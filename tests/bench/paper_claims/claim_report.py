#!/usr/bin/python3
"""Writes docs/paper_claims.md and its plots from the raw numbers of paper_claims.

Usage: claim_report.py JSON DOCS_FOLDER. Every number in the text comes from the JSON.
"""

import json
import pathlib
import sys

import claim_plots
import gap_claim
import work_claims
from wording import wrapped

INTRODUCTION = """\
# The paper's claims, measured

Ding Weili, Hao Yingming, Zhu Feng, Qin Lijuan, Liu Xiaomin, "Collision detection technique in the EOD robot training
simulation system", Journal of System Simulation (China), March 2006, gives three means against work and penetration:
masks by module (分块设置掩码), dynamic loading (动态加载) of isectors, and a distance that grows with the speed
(Eq. 2). Here they are measured on the shipped robot, with the product's own functions.

`scripts/claims` measures, draws and writes this page; no number in it was typed in. Counts and distances are the same
on every machine, times are not. The test `paper_claims_hold` checks the claims in small sizes."""


def main():
    source, docs = sys.argv[1:]
    claims = json.loads(pathlib.Path(source).read_text(encoding="utf-8"))
    docs = pathlib.Path(docs)
    parts = [part(claims) for part in (work_claims.Masks, work_claims.Loading,
                                     gap_claim.Gaps, work_claims.Scenes)]
    plots = docs / "paper_claims"
    plots.mkdir(parents=True, exist_ok=True)
    for name, draw in claim_plots.ALL.items():
        if name != "scene_time" or parts[-1].timed:
            draw(claims, plots / f"{name}.svg")
    summary = "\n".join(["| claim | expected | measured | |", "|---|---|---|---|",
                         *(part.summary() for part in parts)])
    page = "\n\n".join([INTRODUCTION, summary, *(part.text().strip() for part in parts)])
    (docs / "paper_claims.md").write_text(wrapped(page), encoding="utf-8")


if __name__ == "__main__":
    main()
