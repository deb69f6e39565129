"""What ground can carry: tracks, belly and the flippers' belts."""

import math

from sdf_writer import element, numbers

from .dimensions import AXLE_Y, FLIPPER, MAIN_WHEEL, TRACK_X, WHEEL


def arc(centre_y, centre_z, radius, from_deg, to_deg, steps):
    """Points y z on a circle; 0 deg is forward, counter-clockwise seen from +X."""
    angles = (math.radians(from_deg + (to_deg - from_deg) * i / steps) for i in range(steps + 1))
    return [(centre_y + radius * math.cos(a), centre_z + radius * math.sin(a)) for a in angles]


def support(link, x, outline):
    yz = numbers([round(c, 5) for point in outline for c in point])
    return f'<eod:support link="{link}" x="{numbers(x)}" outline="{yz}"/>'


def stance():
    """What ground can carry: tracks, belly and the flippers' belts, all round."""
    belt = [(0.075 * i, 0) for i in range(-4, 5)]
    track = [*arc(-AXLE_Y, MAIN_WHEEL, MAIN_WHEEL, 180, 270, 5), *belt,
             *arc(AXLE_Y, MAIN_WHEEL, MAIN_WHEEL, 270, 360, 5),
             (AXLE_Y + MAIN_WHEEL, 0.25), (-AXLE_Y - MAIN_WHEEL, 0.25)]
    belly = [*((y, 0.10) for y in (-0.36, -0.18, 0, 0.18, 0.30)), (0.455, 0.22), (0.30, 0.45),
             (-0.42, 0.45)]
    run = [(y, 0.085 + (WHEEL - 0.085) * y / FLIPPER) for y in (0.10, 0.20, 0.30)]
    swing = [*((y, -z) for y, z in run), *arc(FLIPPER, 0, WHEEL, 270, 450, 8), *reversed(run)]
    # Friction: tan 40 deg, the stated slope limit of the prototype [P]; the rest [E].
    tag = (f'eod:stance friction="{numbers([math.tan(math.radians(40))])}" pitch_limit_deg="38" '
           'roll_limit_deg="28" overturned_deg="80" press_on_s="0.5" lift_off_m="0.01" '
           'reach_up_m="0.2" reach_down_m="0.5" rise_mps="0.25" rise_per_metre="1.5"')
    return element(tag, [support("chassis", (-TRACK_X, TRACK_X), track), support("chassis", (0,), belly),
                         support("front_flipper", (-TRACK_X, TRACK_X), swing),
                         support("rear_flipper", (-TRACK_X, TRACK_X), swing)])
