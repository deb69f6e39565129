"""The lines that the robot feels with."""

from sdf_writer import element, numbers

from .dimensions import AXES, AXLE_Y, FLIPPER, TRACK_X, WHEEL


def segment(name, axis, d0, skin, length=None, start=None, motions=None, blocks=None):
    text = f'<eod:segment name="{name}"'
    if start is not None:
        text += f' start="{numbers(start)}"'
    text += f' direction="{numbers(AXES[axis])}" length="{numbers([length or d0 + 0.20])}"'
    text += f' d0="{numbers([d0])}" skin="{numbers([skin])}"'
    text += f' motions="{motions}"' if motions else ""
    return text + (f' blocks="{blocks}"/>' if blocks else "/>")


def isector(name, method, part, motions, segments, at=(0, 0, 0), extended=False):
    tag = f'eod:isector name="{name}" method="{method}" part="{part}" motions="{motions}"'
    if any(at):
        tag += f' pose="{numbers(at)} 0 0 0"'
    if extended:
        tag += ' coverage="extended"'
    return element(tag, segments)


def wheel_isector(name, part, x, drive, flipper_down, motions):
    """Small wheel: six lines; -Z rests on the ground, so it lives only while the flipper is lowered."""
    lines = [segment(axis, axis, WHEEL + 0.02, 0.02) for axis in ("+X", "-X", "+Y", "-Y")]
    lines.append(segment("+Z", "+Z", WHEEL + 0.005, 0.005))
    lines.append(segment("-Z", "-Z", WHEEL + 0.005, 0.005, motions=flipper_down))
    return isector(name, "bump", part, f"{drive} M03 M04 {motions}", lines, (x, FLIPPER, 0))


def chassis_isectors():
    legs = (("front_left", (-TRACK_X, AXLE_Y, 0)), ("front_right", (TRACK_X, AXLE_Y, 0)),
            ("rear", (0, -AXLE_Y, 0)))
    tripod = [f'<eod:segment name="{name}" start="{numbers(at)}"/>' for name, at in legs]
    lines = isector("TRIPOD", "tripod", "chassis", "always", tripod)
    lines += isector("LOS_FRONT", "los", "chassis", "always",
                     [segment("+Y", "+Y", 0.05, 0.05, 10)], (0, 0.475, 0.30))
    lines += isector("LOS_REAR", "los", "chassis", "M02", [segment("-Y", "-Y", 0.05, 0.05, 10)],
                     (0, -0.475, 0.30))
    # Beyond the paper's set: the corners and sides that its lines leave open.
    # The lower ones pass over a kerb of 0.15 m, which the tracks climb.
    for name, axis, drive, end in (("GUARD_FRONT", "+Y", "M01", 1), ("GUARD_REAR", "-Y", "M02", -1)):
        feelers = [segment(f"{side}{height}", axis, 0.05, 0.05, 0.5, (x, end * 0.475, z))
                   for side, x in (("left", -0.34), ("right", 0.34))
                   for height, z in (("_low", 0.18), ("_high", 0.40))]
        lines += isector(name, "volume", "chassis", f"{drive} M03 M04", feelers, extended=True)
    for name, axis, x in (("GUARD_LEFT", "-X", -0.35), ("GUARD_RIGHT", "+X", 0.35)):
        feelers = [segment(place, axis, 0.05, 0.05, 0.4, (x, y, 0.25))
                   for place, y in (("front", 0.45), ("middle", 0.0), ("rear", -0.45))]
        lines += isector(name, "volume", "chassis", "M03 M04", feelers, extended=True)
    return lines
