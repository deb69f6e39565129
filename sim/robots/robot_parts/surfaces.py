"""What the robot is made of, as its cameras see it."""

from sdf_writer import Surface

OLIVE = Surface((0.19, 0.22, 0.12), "metal", 0.8, 0.15)
OLIVE_DARK = Surface((0.12, 0.14, 0.08), "metal", 0.8, 0.15)
GREY = Surface((0.16, 0.17, 0.18), "metal", 0.5, 0.3)
STEEL = Surface((0.55, 0.56, 0.58), "metal", 0.3, 0.6)
RUBBER = Surface((0.045, 0.045, 0.05), "rubber", 0.08, 0.05)
PAD = Surface((0.10, 0.10, 0.10), "rubber", 0.03, 0.05)
HAZARD = Surface((1.0, 1.0, 1.0), "hazard", 0.16, 0.2)
ORANGE = Surface((0.85, 0.32, 0.03), "plain", 1.0, 0.2)
LENS = Surface((0.02, 0.02, 0.03), "plain", 1.0, 0.9)
LAMP = Surface((1.0, 0.96, 0.80), "plain", 1.0, 0.9)
TAIL_LAMP = Surface((0.75, 0.05, 0.03), "plain", 1.0, 0.6)
