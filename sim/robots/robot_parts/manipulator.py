"""Arms, wrist and gripper."""

from sdf_writer import Link, box, cylinder

from .cameras import camera
from .dimensions import ALONG_X, ALONG_Y, BIG_ARM, FINGER, PAD_DEPTH, SMALL_ARM
from .isectors import isector, segment
from .lights import wrist_lights
from .surfaces import GREY, HAZARD, LENS, OLIVE, OLIVE_DARK, ORANGE, PAD, STEEL


def arms():
    big = Link("big_arm").mass(14, (0, BIG_ARM / 2, 0))
    big.visual(box(0.09, 0.66, 0.11), OLIVE, (0, 0.36, 0))
    big.visual(box(0.094, 0.14, 0.112), HAZARD, (0, 0.58, 0))
    big.visual(cylinder(0.065, 0.13), GREY, (0, BIG_ARM, 0), ALONG_X)
    big.visual(cylinder(0.022, 0.34), GREY, (0, 0.22, -0.085), ALONG_Y)
    big.visual(cylinder(0.012, 0.30), STEEL, (0, 0.50, -0.085), ALONG_Y)
    big.collision(box(0.09, 0.66, 0.165), (0, 0.36, -0.0275))
    big.collision(cylinder(0.065, 0.13), (0, BIG_ARM, 0), ALONG_X)
    small = Link("small_arm").mass(9, (0, SMALL_ARM / 2, 0))
    small.visual(box(0.07, 0.56, 0.08), OLIVE, (0, 0.32, 0))
    small.visual(box(0.074, 0.10, 0.082), HAZARD, (0, 0.54, 0))
    small.visual(cylinder(0.016, 0.40), GREY, (0.048, 0.30, 0.02), ALONG_Y)
    small.visual(cylinder(0.045, 0.10), GREY, (0, SMALL_ARM, 0), ALONG_X)
    small.collision(box(0.10, 0.56, 0.08), (0.014, 0.32, 0))
    small.collision(cylinder(0.045, 0.10), (0, SMALL_ARM, 0), ALONG_X)
    wrist = Link("wrist").mass(3, (0, 0.075, 0))
    wrist.visual(box(0.06, 0.07, 0.06), OLIVE_DARK, (0, 0.035, 0))
    wrist.visual(box(0.045, 0.05, 0.04), GREY, (0, 0.02, 0.062))
    wrist.visual(cylinder(0.014, 0.022), LENS, (0, 0.055, 0.065), ALONG_Y)
    wrist.collision(box(0.06, 0.07, 0.06), (0, 0.035, 0))
    wrist.collision(box(0.045, 0.07, 0.04), (0, 0.03, 0.062))
    # It sees the fingers in whole length even when they are open, and the foot of what stands between
    # them. A charge between them comes as near as 0.03 m.
    wrist.parts += camera("gripper", 72, (0, 0.067, 0.065), down_deg=12, near=0.02)
    wrist.parts += wrist_lights()
    return [big, small, wrist]


def gripper():
    """Frame at the wrist's pivot, +Y along the fingers: crossbeam at 0.15, finger tips at 0.31."""
    arm = "M01 M03 M04 M09 M10 M11 M12 M13 M14 M15 M16 M17 M18"
    # l3, l6 and l9 look at what is between the hands: while these open or close, that is nearness,
    # not contact.
    but_grip = arm.removesuffix(" M17 M18")
    roll = Link("gripper").mass(2, (0, 0.15, 0))
    roll.visual(cylinder(0.035, 0.05), STEEL, (0, 0.085, 0), ALONG_Y)
    roll.visual(box(0.06, 0.05, 0.045), GREY, (0, 0.10, 0))
    roll.collision(box(0.06, 0.07, 0.06), (0, 0.09, 0))
    beam = Link("crossbeam").mass(1)
    beam.visual(box(0.30, 0.022, 0.035), GREY, (0, -0.012, 0))
    beam.visual(box(0.30, 0.006, 0.037), HAZARD, (0, -0.024, 0))
    beam.collision(box(0.30, 0.027, 0.037), (0, -0.0145, 0))
    beam.parts += isector("B7", "bump", "crossbeam", arm,
                          [segment("l7", "-X", 0.14, 0.02), segment("l8", "+X", 0.14, 0.02),
                           segment("l9", "+Y", 0.14, 0.02, blocks=but_grip)])
    hands = []
    for name, side in (("left_hand", -1), ("right_hand", 1)):
        hand = Link(name).mass(0.5, (0, FINGER / 2, 0))
        hand.visual(box(0.014, FINGER + 0.04, 0.045), STEEL, (side * 0.013, FINGER / 2 - 0.02, 0))
        hand.visual(box(0.006, FINGER - 0.02, 0.040), PAD, (side * 0.003, FINGER / 2 + 0.01, 0))
        hand.visual(box(0.03, 0.05, 0.03), GREY, (side * 0.02, -0.02, 0))
        # Where the middle of a charge belongs, for the gripper's camera: lines l1 and l2 meet there.
        hand.visual(box(0.0205, 0.008, 0.046), ORANGE, (side * 0.01, FINGER / 2, 0))
        # The pads are soft: what presses them in by less than their thickness is not shoved.
        hand.collision(box(0.02 - PAD_DEPTH, FINGER + 0.02, 0.045),
                       (side * (0.02 + PAD_DEPTH) / 2, FINGER / 2 - 0.01, 0))
        hand.collision(box(0.035 - PAD_DEPTH, 0.05, 0.03), (side * (0.035 + PAD_DEPTH) / 2, -0.02, 0))
        hands.append(hand)
    hands[0].parts += isector("B5", "bump", "left_hand", arm,
                              [segment("l1", "+Y", 0.085, 0.02), segment("l2", "-Y", 0.085, 0.02),
                               segment("l3", "+X", 0.30, 0.02, blocks=but_grip)], (0, FINGER / 2, 0))
    hands[1].parts += isector("B6", "bump", "right_hand", arm,
                              [segment("l4", "+Y", 0.02, 0.02), segment("l5", "-Y", 0.14, 0.02),
                               segment("l6", "-X", 0.30, 0.02, blocks=but_grip)], (0, FINGER, 0))
    # Beyond the paper's set: nothing of it looks down from the hand.
    for hand, name, part in ((hands[0], "B5_DOWN", "left_hand"), (hands[1], "B6_DOWN", "right_hand")):
        feelers = [segment("-Z", "-Z", 0.045, 0.02), segment("+Z", "+Z", 0.045, 0.02)]
        hand.parts += isector(name, "bump", part, "M09 M10 M11 M12 M13 M14 M15 M16", feelers,
                              (0, FINGER, 0), extended=True)
    return [roll, beam, *hands]
