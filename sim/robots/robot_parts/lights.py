"""The robot's lamps: place, cone, reach and the switch that turns them on."""

import math

from sdf_writer import element, numbers, pose

WHITE = (1.0, 0.97, 0.90)
INFRARED = (1.0, 1.0, 1.0)


def spot(name, switch, xyz, colour, intensity, reach_m, quadratic, inner_deg, outer_deg,
         down_deg=0, left_deg=0, backwards=False):
    """Spot light along +Y of the link (-Y: backwards), turned down and left.

    Intensity 1 makes a white surface at no distance as white as a picture can be. All [E]: sized
    to the work lights of such robots, some 1000 lm each, as their cameras expose by night.
    """
    down, left = math.radians(down_deg), math.radians(left_deg)
    forward = -1 if backwards else 1
    direction = (-forward * math.sin(left) * math.cos(down), forward * math.cos(left) * math.cos(down),
                 -math.sin(down))
    return element(f'light name="{name}" type="spot"', [
        *pose(xyz),
        f"<diffuse>{numbers(colour)} 1</diffuse>",
        f"<intensity>{numbers([intensity])}</intensity>",
        "<attenuation>",
        f"  <range>{numbers([reach_m])}</range>",
        f"  <constant>1</constant><linear>0</linear><quadratic>{numbers([quadratic])}</quadratic>",
        "</attenuation>",
        f"<direction>{numbers(direction)}</direction>",
        "<spot>",
        f"  <inner_angle>{numbers([math.radians(inner_deg)])}</inner_angle>",
        f"  <outer_angle>{numbers([math.radians(outer_deg)])}</outer_angle>",
        "  <falloff>1</falloff>",
        "</spot>",
        f'<eod:lamp switch="{switch}"/>'])


def chassis_lights():
    lines = []
    for name, side in (("left", -1), ("right", 1)):
        lines += spot(f"headlight_{name}", "drive", (side * 0.17, 0.455, 0.355), WHITE, 7, 40, 0.12,
                      28, 76, down_deg=5, left_deg=-7 * side)
    lines += spot("infrared_front", "infrared", (0, 0.45, 0.43), INFRARED, 8, 25, 0.25, 40, 100)
    return lines + spot("infrared_rear", "infrared", (0, -0.45, 0.43), INFRARED, 8, 25, 0.25, 40, 100,
                        backwards=True)


def wrist_lights():
    return (spot("gripper_light", "gripper", (0.02, 0.06, 0.085), WHITE, 2.5, 12, 0.9, 40, 96, down_deg=12)
            + spot("infrared_gripper", "infrared", (-0.02, 0.06, 0.085), INFRARED, 2.2, 10, 0.9, 40, 110,
                   down_deg=12))


def mast_lights():
    return spot("infrared_mast", "infrared", (0.07, 0.065, 0), INFRARED, 9, 35, 0.12, 30, 76)
