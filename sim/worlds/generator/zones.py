"""Level ground in zones: each rectangle has its surface, and what no zone claims is grass."""

from .gathered import Gathered


def rectangles(area, claimed):
    """What of `area` ((x from, to), (y from, to)) no rectangle of `claimed` covers, in rectangles: bands
    along X, those that lie on each other as one."""
    ys = sorted({*area[1], *(y for _, ys in claimed for y in ys if area[1][0] < y < area[1][1])})
    open_bands = {}
    for low, high in zip(ys, ys[1:]):
        cover = sorted(x for x, y in claimed if y[0] < high and y[1] > low and x[0] < area[0][1] and x[1] > area[0][0])
        free, at = [], area[0][0]
        for x in cover:
            if x[0] > at:
                free.append((at, x[0]))
            at = max(at, x[1])
        if at < area[0][1]:
            free.append((at, area[0][1]))
        for x in [x for x in open_bands if x not in free]:
            yield x, (open_bands.pop(x), low)
        for x in free:
            open_bands.setdefault(x, low)
    for x, low in open_bands.items():
        yield x, (low, ys[-1])


def cut(low, high, most):
    count = max(1, -(-round(high - low) // most))
    return [low + (high - low) * i / count for i in range(count + 1)]


def tiles(x, y, most):
    """Rectangle in rectangles of at most `most` m."""
    for a, b in zip(cut(*x, most)[:-1], cut(*x, most)[1:]):
        for c, d in zip(cut(*y, most)[:-1], cut(*y, most)[1:]):
            yield (a, b), (c, d)


def level_ground(area, zones, holes, grass, seen):
    """Stood on everywhere but in the holes, in cells of at most 10 m. `zones`: (surface name, Surface or
    None if others paint it, x, y). Grass is seen out to `seen` m."""
    whole = Gathered()
    lawn = list(rectangles(area, [(x, y) for *_, x, y in zones] + holes))
    round_about = rectangles(((-seen, seen), (-seen, seen)), [area])
    for x, y in [*lawn, *round_about]:
        for piece in tiles(x, y, 60):
            whole.of("grass", grass).floor(*piece, 0)
    for x, y in lawn:
        for piece in tiles(x, y, 10):
            whole.body.floor(*piece, 0)
    for surface_name, surface, x, y in zones:
        for open_x, open_y in rectangles((x, y), holes):
            if surface:
                whole.of(surface_name, surface).floor(open_x, open_y, 0)
            for piece in tiles(open_x, open_y, 10):
                whole.body.floor(*piece, 0)
    return whole
