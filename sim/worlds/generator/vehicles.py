"""Vehicles at the kerb: bodies of cross-sections one behind the other. They look north (+Y); origin on the
ground below the middle."""

from sdf_writer import Surface

from .gathered import Gathered
from .lettering import word
from .solid import Solid
from .surfaces import AMBER, CAR_GLASS, LAMP, RED, TRIM

CLEARANCE, BOOT_SILL = 0.18, 0.70
CAR_LENGTH, CAR_WIDTH = 4.30, 1.78
BOOT_FLOOR, BOOT_WIDTH, BOOT_DEPTH = 0.60, 1.10, 0.85
REAR = -CAR_LENGTH / 2
VAN_LENGTH, VAN_WIDTH, VAN_HEIGHT = 5.20, 2.00, 2.45
WHEEL = 0.31
LINING = Surface((0.16, 0.16, 0.17), "render", 0.6, 0.02)


def loft(solid, sections, ends=True, sides=("left", "right", "top", "bottom")):
    """`sections`: (y, half width below, z below, half width above, z above), from the rear to the front."""
    for (y0, w0, b0, v0, t0), (y1, w1, b1, v1, t1) in zip(sections, sections[1:]):
        if "right" in sides:
            solid.face((w0, y0, b0), (w1, y1, b1), (v1, y1, t1), (v0, y0, t0))
        if "left" in sides:
            solid.face((-w1, y1, b1), (-w0, y0, b0), (-v0, y0, t0), (-v1, y1, t1))
        if "top" in sides:
            solid.face((-v0, y0, t0), (v0, y0, t0), (v1, y1, t1), (-v1, y1, t1))
        if "bottom" in sides:
            solid.face((w0, y0, b0), (-w0, y0, b0), (-w1, y1, b1), (w1, y1, b1))
    if ends:
        y, w, b, v, t = sections[0]
        solid.face((-w, y, b), (w, y, b), (v, y, t), (-v, y, t))
        y, w, b, v, t = sections[-1]
        solid.face((w, y, b), (-w, y, b), (-v, y, t), (v, y, t))
    return solid


def wheels(whole, half_track, axles, radius):
    """Tyres, rims, and the dark arches they stand in."""
    dark, light = whole.of("dark", TRIM), whole.of("light", LAMP)
    for x in (-half_track, half_track):
        out = 1 if x > 0 else -1
        for y in axles:
            def lay(c, x=x, y=y, out=out):
                return (x + out * c[2], y + out * c[0], radius + c[1])

            dark.add(Solid().ring([(radius, -0.20), (radius, 0.0), (radius * 0.66, 0.0)], sides=12), lay)
            dark.add(Solid().ring([(radius + 0.07, -0.012), (radius * 0.8, -0.012)], sides=12), lay)
            light.add(Solid().ring([(radius * 0.66, 0.0), (0.0, 0.012)], sides=10), lay)
            whole.body.box(sorted((x - out * 0.20, x)), (y - 0.25, y + 0.25), (0, CLEARANCE))


def number_plate(whole, text, y, z, facing):
    """Facing -1 south, 1 north."""
    plate, letters = Solid().box((-0.26, 0.26), (-0.012, 0), (-0.055, 0.055), without=("+y",)), Solid()
    word(text, (0, -0.016, 0), 0.07, 0.013, letters, 0.75)

    def place(c):
        return (-facing * c[0], y - facing * c[1], z + c[2])

    whole.of("light", LAMP).add(plate, place)
    whole.of("dark", TRIM).add(letters, place)


def lower_body(open_boot):
    """Without the hole of the boot."""
    solid, half = Solid(), CAR_WIDTH / 2
    inner = REAR + BOOT_DEPTH
    middle = [(inner, half, CLEARANCE, half - 0.04, 0.92), (0.55, half, CLEARANCE, half - 0.04, 0.90),
              (1.55, half, CLEARANCE, half - 0.10, 0.82), (2.0, half - 0.06, 0.22, half - 0.16, 0.72),
              (CAR_LENGTH / 2, half - 0.20, 0.26, half - 0.28, 0.56)]
    tail = [(REAR, half - 0.08, 0.30, half - 0.14, 0.86), (REAR + 0.25, half, CLEARANCE, half - 0.06, 0.90), middle[0]]
    if not open_boot:
        return loft(solid, tail + middle[1:])
    loft(solid, middle)
    loft(solid, tail, ends=False, sides=("left", "right", "bottom"))
    boot, rear_half = BOOT_WIDTH / 2, half - 0.08
    # The rear: below the sill, and the pillars of the lamps beside the opening.
    low, sill, top = 0.30, BOOT_SILL, 0.86
    solid.face((-rear_half, REAR, low), (rear_half, REAR, low), (rear_half - 0.043, REAR, sill),
               (-rear_half + 0.043, REAR, sill))
    for side in (-1, 1):
        corners = [(side * boot, REAR, sill), (side * (rear_half - 0.043), REAR, sill),
                   (side * (rear_half - 0.06), REAR, top),
                   (side * boot, REAR, top)]
        solid.face(*(corners if side > 0 else reversed(corners)))
        ledge = [(side * boot, REAR, top), (side * (half - 0.14), REAR, top), (side * (half - 0.06), REAR + 0.25, 0.90),
                 (side * (half - 0.04), inner, 0.92), (side * boot, inner, 0.92)]
        solid.face(*(ledge if side > 0 else reversed(ledge)))
    # The sill is 8 cm thick.
    return solid.floor((-boot, boot), (REAR, REAR + 0.08), sill)


def boot_lining():
    """Inside of the boot: floor, walls, back of the seats."""
    solid, half, inner = Solid(), BOOT_WIDTH / 2, REAR + BOOT_DEPTH - 0.01
    solid.floor((-half, half), (REAR + 0.08, inner), BOOT_FLOOR)
    solid.face((half, REAR + 0.08, BOOT_FLOOR), (-half, REAR + 0.08, BOOT_FLOOR), (-half, REAR + 0.08, BOOT_SILL),
               (half, REAR + 0.08, BOOT_SILL))
    for side in (-1, 1):
        wall = [(side * half, REAR, BOOT_FLOOR), (side * half, REAR, 0.88), (side * half, inner, 0.92),
                (side * half, inner, BOOT_FLOOR)]
        solid.face(*(wall if side > 0 else reversed(wall)))
        lining = [(side * half, REAR + 0.55, 0.88), (side * half, REAR + 0.55, 1.43), (side * half, inner, 1.43),
                  (side * half, inner, 0.88)]
        solid.face(*(lining if side > 0 else reversed(lining)))
    solid.face((-half, REAR + 0.55, 1.43), (-half, inner, 1.43), (half, inner, 1.43), (half, REAR + 0.55, 1.43))
    return solid.face((-half, inner, BOOT_FLOOR), (half, inner, BOOT_FLOOR), (half, inner, 1.43), (-half, inner, 1.43))


def cabin(open_boot):
    """Roof and pillars in the car's colour, and the glass between them."""
    body, glass = Solid(), Solid()
    low, high, w, v = 0.90, 1.44, 0.83, 0.64
    rear_low, rear_high, front_high, front_low = (REAR + 0.10, REAR + 0.55, 0.25, 0.95)
    if open_boot:
        rear_low = REAR + BOOT_DEPTH
    body.face((-v, rear_high, high), (v, rear_high, high), (v, front_high, high), (-v, front_high, high))
    if open_boot:
        rear_low = rear_high
    for side in (-1, 1):
        sheet = [(side * w, rear_low, low), (side * w, front_low, low), (side * v, front_high, high),
                 (side * v, rear_high, high)]
        body.face(*(sheet if side > 0 else reversed(sheet)))
        if open_boot:
            pillar = [(side * w, rear_low, low), (side * v, rear_high, high), (side * (v - 0.12), rear_high, high),
                      (side * BOOT_WIDTH / 2, rear_low, low)]
            body.face(*(pillar if side > 0 else reversed(pillar)))
        for a, b in ((0.06, 0.47), (0.52, 0.95)):
            # Side windows between the shares a and b of the way from rear to front, a little proud.
            def at(share, up, side=side):
                below = rear_low + (front_low - rear_low) * share
                y = below + (rear_high + (front_high - rear_high) * share - below) * up
                return (side * (w + (v - w) * up + 0.012), y, low + (high - low) * up)

            pane = [at(a, 0.10), at(b, 0.10), at(b, 0.86), at(a, 0.86)]
            glass.face(*(pane if side > 0 else reversed(pane)))
    body.face((w, front_low, low), (-w, front_low, low), (-v, front_high, high), (v, front_high, high))

    def screen(y_low, y_high, facing):
        pane = [(-0.92 * w, y_low, low), (0.92 * w, y_low, low), (0.90 * v, y_high, high), (-0.90 * v, y_high, high)]
        normal = (0, facing * 0.010, 0.008)
        moved = []
        for up, p in zip((0.06, 0.06, 0.90, 0.90), pane):
            y, z = y_low + (y_high - y_low) * up, low + (high - low) * up
            moved.append((p[0], y + normal[1], z + normal[2]))
        glass.face(*(moved if facing < 0 else reversed(moved)))

    screen(front_low, front_high, 1)
    if not open_boot:
        body.face((-w, rear_low, low), (w, rear_low, low), (v, rear_high, high), (-v, rear_high, high))
        screen(rear_low, rear_high, -1)
    return body, glass


def lid(solid, glass):
    """Tailgate, open: from the roof's rear edge out over the boot."""
    y0, y1, z0, z1 = REAR + 0.55, REAR - 0.45, 1.44, 1.78
    outside = [(-0.64, y0, z0 + 0.03), (-0.70, y1, z1 + 0.03), (0.70, y1, z1 + 0.03), (0.64, y0, z0 + 0.03)]
    inside = [(x, y, z - 0.06) for x, y, z in outside]
    solid.face(*outside).face(*reversed(inside))
    for i in range(4):
        j = (i + 1) % 4
        solid.face(inside[i], inside[j], outside[j], outside[i])
    pane = [(x * 0.85, y0 + (y - y0) * s, z0 + (z - z0) * s - 0.005)
            for (x, y, z), s in zip(outside, (0.15, 0.75, 0.75, 0.15))]
    pane = [(p[0], p[1], z0 + (z1 - z0) * s + 0.045) for p, s in zip(pane, (0.15, 0.75, 0.75, 0.15))]
    glass.face(*pane)
    for side in (-1, 1):
        solid.beam((side * 0.60, REAR + 0.35, 1.05), (side * 0.66, REAR - 0.05, 1.60), 0.03)


def trim(dark, half_width, doors):
    """What is dark: bumpers, gaps of the doors, mirrors."""
    half = CAR_LENGTH / 2
    dark.box((-0.74, 0.74), (REAR - 0.03, REAR + 0.02), (0.30, 0.48))
    dark.box((-0.68, 0.68), (half - 0.02, half + 0.03), (0.26, 0.40))
    dark.box((-0.45, 0.45), (half - 0.06, half + 0.012), (0.42, 0.52), without=("-y",))
    for side in (-1, 1):
        for y in doors:
            dark.box(sorted((side * (half_width - 0.05), side * (half_width + 0.006))), (y - 0.008, y + 0.008),
                     (0.30, 0.86))
        dark.box(sorted((side * (half_width - 0.02), side * (half_width + 0.16))), (0.70, 0.84), (0.92, 1.06))
        for y in (doors[0] + 0.15, doors[1] + 0.15):
            dark.box(sorted((side * (half_width - 0.03), side * (half_width + 0.012))), (y - 0.08, y + 0.08),
                     (0.74, 0.77))


def lights(whole):
    half = CAR_LENGTH / 2
    for side in (-1, 1):
        whole.of("light", LAMP).box(sorted((side * 0.40, side * 0.63)), (half - 0.08, half + 0.012), (0.50, 0.60))
        whole.of("red", RED).box(sorted((side * 0.60, side * 0.78)), (REAR - 0.012, REAR + 0.05), (0.62, 0.84))


def car_body(body, open_boot):
    """What isectors meet."""
    floor, half = BOOT_FLOOR if open_boot else 0.90, CAR_WIDTH / 2
    inner, front = REAR + BOOT_DEPTH, CAR_LENGTH / 2
    body.box((-half, half), (inner, 1.6), (CLEARANCE, 0.90)).box((-half, half), (1.6, front), (0.24, 0.70))
    body.box((-half, half), (REAR + 0.25, inner), (CLEARANCE, floor))
    body.box((-half + 0.08, half - 0.08), (REAR, REAR + 0.25), (0.30, floor))
    body.box((-0.74, 0.74), (inner if open_boot else REAR + 0.3, 0.7), (0.90, 1.40))
    if not open_boot:
        return
    body.box((-half + 0.08, half - 0.08), (REAR, REAR + 0.08), (floor, BOOT_SILL))
    for side in (-1, 1):
        body.box(sorted((side * BOOT_WIDTH / 2, side * (half - 0.06))), (REAR, inner), (floor, 0.90))
    body.box((-0.66, 0.66), (REAR + 0.05, REAR + 0.55), (1.44, 1.62)).box((-0.70, 0.70), (REAR - 0.45, REAR + 0.05),
                                                                          (1.58, 1.80))


def car(colour, number, open_boot=False):
    """4.30 x 1.78 x 1.44 m, clearance 0.18. With its boot open: sill 0.70, floor 0.60, 1.10 wide, 0.85 deep."""
    whole = Gathered()
    paint, glass = whole.of("paint", colour), whole.of("glass", CAR_GLASS)
    for solid, part_of_cabin in zip((paint, glass), cabin(open_boot)):
        solid.add(part_of_cabin)
    paint.add(lower_body(open_boot))
    dark = whole.of("dark", TRIM)
    if open_boot:
        lid(paint, glass)
        whole.of("lining", LINING).add(boot_lining())
    trim(dark, CAR_WIDTH / 2 - 0.02, (-0.75, 0.20))
    lights(whole)
    wheels(whole, CAR_WIDTH / 2 + 0.005, (-1.32, 1.32), WHEEL)
    number_plate(whole, number, REAR - 0.035, 0.40, -1)
    number_plate(whole, number, CAR_LENGTH / 2 + 0.035, 0.34, 1)
    car_body(whole.body, open_boot)
    return whole


def van(colour, number):
    """5.20 x 2.00 x 2.45 m, clearance 0.20."""
    whole, half, end, high = Gathered(), VAN_WIDTH / 2, VAN_LENGTH / 2, VAN_HEIGHT
    loft(whole.of("paint", colour), [(-end, half - 0.03, 0.35, half - 0.08, high - 0.06), (-end + 0.3, half, 0.20,
                                                                                           half - 0.07, high),
                                     (1.05, half, 0.20, half - 0.07, high), (1.85, half, 0.20, half - 0.16, 1.35),
                                     (2.4, half - 0.06, 0.24, half - 0.20, 1.08), (end, half - 0.20, 0.30, half - 0.30,
                                                                                   0.75)])
    van_glass(whole.of("glass", CAR_GLASS), half, end)
    dark, light, red, amber = (whole.of(*pair) for pair in (("dark", TRIM), ("light", LAMP), ("red", RED),
                                                            ("amber", AMBER)))
    for side in (-1, 1):
        for y in (-0.95, 0.25):
            dark.box(sorted((side * (half - 0.06), side * (half + 0.004))), (y - 0.012, y + 0.012), (0.35, 1.35))
        dark.box(sorted((side * (half - 0.02), side * (half + 0.20))), (1.35, 1.50), (1.35, 1.70))
        light.box(sorted((side * 0.45, side * 0.72)), (end - 0.10, end + 0.012), (0.62, 0.74))
        red.box(sorted((side * 0.84, side * 0.95)), (-end - 0.012, -end + 0.02), (0.75, 1.15))
        amber.box(sorted((side * (half - 0.05), side * (half + 0.008))), (-end + 0.3, 0.2), (0.95, 1.02))
        text = word("PARCELS", (0, 0, 0), 0.42, 0.07, Solid(), 0.85)
        amber.add(text, lambda c, side=side: (side * (half - 0.03), -1.15 + side * c[0], 1.65 + c[2]))
    dark.box((-0.012, 0.012), (-end - 0.008, -end), (0.45, 2.25)).box((-0.9, 0.9), (-end - 0.06, -end + 0.02),
                                                                      (0.34, 0.54))
    dark.box((-0.72, 0.72), (end - 0.03, end + 0.04), (0.30, 0.52))
    wheels(whole, half + 0.005, (-1.55, 1.70), 0.34)
    number_plate(whole, number, -end - 0.065, 0.44, -1)
    number_plate(whole, number, end + 0.045, 0.41, 1)
    whole.body.box((-half, half), (-end, end - 0.6), (0.20, high)).box((-half + 0.1, half - 0.1), (end - 0.6, end),
                                                                       (0.22, 1.08))
    return whole


def van_glass(glass, half, end):
    glass.face((half - 0.22, 1.83, 1.42), (-half + 0.22, 1.83, 1.42), (-half + 0.17, 1.15, 2.36),
               (half - 0.17, 1.15, 2.36))
    for side in (-1, 1):
        pane = [(side * (half - 0.025), 0.35, 1.40), (side * (half - 0.04), 1.62, 1.40),
                (side * (half - 0.02), 1.05, 2.15),
                (side * (half - 0.02), 0.35, 2.15)]
        glass.face(*(pane if side > 0 else reversed(pane)))
        low, high = sorted((side * 0.12, side * 0.80))
        glass.face((low, -end - 0.012, 1.45), (high, -end - 0.012, 1.45), (high, -end - 0.012, 2.10),
                   (low, -end - 0.012, 2.10))
