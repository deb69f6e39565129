#!/usr/bin/env python3
"""Writes training_ground.sdf and its meshes: the training ground, 3000 x 3000 m, module by module.

Each module has a frame of its own (origin: its start pad; X east, Y north, Z up; metres) and all of its
models are posed in it. Run in any folder: python3 make_training_ground.py
"""

import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "robots"))

from sdf_writer import HEADER, element, indent  # noqa: E402

from generator.bomb import bomb  # noqa: E402
from generator.flat import flat  # noqa: E402
from generator.indoor import indoor  # noqa: E402
from generator.land import write_forest, write_hills  # noqa: E402
from generator.outdoor import outdoor  # noqa: E402
from generator.slope import slope  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, default=HERE, help="folder to write to")
    folder = parser.parse_args().output
    meshes = folder / "meshes"
    meshes.mkdir(parents=True, exist_ok=True)
    write_hills(meshes / "hills.obj")
    write_forest(meshes / "forest.obj")
    lines = [
        "<scene>", "  <ambient>0.42 0.46 0.52 1</ambient>", "  <background>0.45 0.62 0.85 1</background>",
        "  <fog><color>0.74 0.79 0.84 1</color><density>0.005</density></fog>", "</scene>",
        '<light name="sun" type="directional">', "  <direction>-0.45 0.52 -0.72</direction>",
        "  <diffuse>1 0.95 0.86 1</diffuse>", "  <cast_shadows>true</cast_shadows>", "</light>",
        *flat(meshes).lines(), *slope(meshes).lines(), *bomb(meshes).lines(),
        *outdoor(meshes).lines(), *indoor(meshes).lines()]
    world = element('world name="training_ground"', lines)
    text = HEADER.format(script="sim/worlds/make_training_ground.py") + "\n".join(indent(world))
    (folder / "training_ground.sdf").write_text(text + "\n</sdf>\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
