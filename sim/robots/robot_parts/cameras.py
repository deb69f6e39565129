"""The robot's cameras: lens, place and what carries them."""

import math

from sdf_writer import Link, box, cylinder, element, numbers, pose

from .dimensions import ALONG_Y
from .lights import mast_lights
from .surfaces import GREY, LAMP, LENS, OLIVE_DARK


def camera(name, fov_deg, xyz, down_deg=0, near=0.06, width=640, height=480, zoom=()):
    """Camera that looks along +Y of the link, or somewhat below; zoom: elements of the lens."""
    return element(f'sensor name="{name}" type="camera"', [
        *pose(xyz, (0, down_deg, 90)),
        "<camera>",
        f"  <horizontal_fov>{numbers([math.radians(fov_deg)])}</horizontal_fov>",
        f"  <image><width>{width}</width><height>{height}</height></image>",
        f"  <clip><near>{numbers([near])}</near><far>3000</far></clip>",
        "</camera>", *zoom])


def mast_camera():
    # Mast and camera together: 4 kg.
    pan = Link("camera_pan").mass(2, (0, 0, -0.40))
    pan.visual(cylinder(0.035, 0.04), GREY, (0, 0, -0.07))
    pan.visual(box(0.02, 0.05, 0.12), GREY, (-0.065, 0, -0.01))
    pan.visual(box(0.13, 0.05, 0.015), GREY, (-0.01, 0, -0.055))
    pan.collision(box(0.15, 0.06, 0.14), (-0.01, 0, -0.02))
    tilt = Link("camera_tilt").mass(2)
    tilt.visual(box(0.10, 0.13, 0.085), OLIVE_DARK, (0, -0.005, 0))
    tilt.visual(cylinder(0.030, 0.02), LENS, (0, 0.062, 0), ALONG_Y)
    tilt.visual(box(0.11, 0.15, 0.008), GREY, (0, 0.01, 0.05))
    tilt.visual(cylinder(0.018, 0.02), LAMP, (0.07, 0.05, 0), ALONG_Y)
    tilt.collision(box(0.11, 0.15, 0.10), (0, 0.005, 0.004))
    # [E] ten times optical, as camera blocks of this size have it; four seconds from end to end.
    tilt.parts += camera("mast", 60, (0, 0.08, 0),
                         zoom=['<eod:zoom narrowest_deg="6" factor_per_s="1.8"/>'])
    tilt.parts += mast_lights()
    return [pan, tilt]
