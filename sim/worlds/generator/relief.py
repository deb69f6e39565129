"""Rolling land to drive on: a height field that meets level ground all round."""

import math

from .module import part
from .scenery import write_mesh
from .solid import Solid
from .surfaces import GRASS

WIDTH, DEPTH, CELL = 100.0, 120.0, 2.5
PIECES = (2, 2)
# Height, lengths along x and y [m], phase.
_WAVES = ((0.90, 46, 60, 0.6), (0.60, -30, 38, 2.1), (0.30, 24, -19, 4.0), (0.06, 9, 8, 1.0))


def relief_height(x, y):
    """x, y from the south-west corner [m]; 0 along the border, level to it, -1.0 to 2.9 within."""
    if not (0 <= x <= WIDTH and 0 <= y <= DEPTH):
        return 0.0

    def rise(distance):
        t = min(1.0, distance / 18)
        return t * t * (3 - 2 * t)

    inside = rise(min(x, WIDTH - x)) * rise(min(y, DEPTH - y))
    waves = sum(h * math.sin(2 * math.pi * (x / lx + y / ly) + phase) for h, lx, ly, phase in _WAVES)
    return inside * (0.9 + waves)


def relief_piece(cells_x, cells_y, middle):
    """About `middle`."""
    solid = Solid()

    def corner(i, j):
        x, y = i * CELL, j * CELL
        return (x - middle[0], y - middle[1], relief_height(x, y))

    for i in cells_x:
        for j in cells_y:
            a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            # The shorter diagonal, so that crests stay smooth.
            if abs(a[2] - c[2]) < abs(b[2] - d[2]):
                solid.face(a, b, c).face(a, c, d)
            else:
                solid.face(a, b, d).face(b, c, d)
    return solid


def relief(folder):
    """The origin is the south-west corner."""
    link = part()
    columns, rows = (round(length / CELL / count) for length, count in zip((WIDTH, DEPTH), PIECES))
    for i in range(PIECES[0]):
        for j in range(PIECES[1]):
            middle = ((i + 0.5) * columns * CELL, (j + 0.5) * rows * CELL)
            piece = relief_piece(range(i * columns, (i + 1) * columns), range(j * rows, (j + 1) * rows), middle)
            link.solid(write_mesh(piece.compact(), f"relief_{i}_{j}", folder), GRASS, (*middle, 0))
    return link
