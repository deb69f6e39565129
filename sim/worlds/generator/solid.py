"""A mesh put together of simple bodies, and written as one OBJ file: one element of the world's file
instead of hundreds."""

import math

from sdf_writer import write_obj


class Solid:
    """Collects faces, counter-clockwise seen from outside; metres."""

    def __init__(self):
        self.corners, self.faces = [], []

    def face(self, *corners):
        first = len(self.corners)
        self.corners += corners
        self.faces.append(list(range(first, first + len(corners))))
        return self

    def box(self, x, y, z, without=()):
        """x, y, z: from and to; `without`: names of faces that lie hidden, such as "-z"."""
        (a, b), (c, d), (e, f) = x, y, z
        sides = {
            "-x": ((a, c, e), (a, c, f), (a, d, f), (a, d, e)),
            "+x": ((b, c, e), (b, d, e), (b, d, f), (b, c, f)),
            "-y": ((a, c, e), (b, c, e), (b, c, f), (a, c, f)),
            "+y": ((a, d, e), (a, d, f), (b, d, f), (b, d, e)),
            "-z": ((a, c, e), (a, d, e), (b, d, e), (b, c, e)),
            "+z": ((a, c, f), (b, c, f), (b, d, f), (a, d, f)),
        }
        for name, corners in sides.items():
            if name not in without:
                self.face(*corners)
        return self

    def wedge(self, x, y, height, z=0.0):
        """Rises along +Y from z to z + height, or along -Y if height is negative; no bottom."""
        (a, b), (c, d) = x, y
        low, high = (c, d) if height > 0 else (d, c)
        top = z + abs(height)
        slope = ((a, low, z), (b, low, z), (b, high, top), (a, high, top))
        back = ((a, high, z), (a, high, top), (b, high, top), (b, high, z))
        left = ((a, low, z), (a, high, top), (a, high, z))
        right = ((b, low, z), (b, high, z), (b, high, top))
        for corners in (slope, back, left, right):
            self.face(*(corners if height > 0 else reversed(corners)))
        return self

    def floor(self, x, y, z):
        (a, b), (c, d) = x, y
        return self.face((a, c, z), (b, c, z), (b, d, z), (a, d, z))

    def beam(self, start, end, thickness):
        """Square bar between two points."""
        along = [e - s for s, e in zip(start, end)]
        length = math.sqrt(sum(v * v for v in along))
        along = [v / length for v in along]
        up = (0, 0, 1) if abs(along[2]) < 0.9 else (0, 1, 0)
        side = _unit(_cross(along, up))
        up = _cross(side, along)

        def corner(point, i):
            s, u = ((-1, -1), (1, -1), (1, 1), (-1, 1))[i % 4]
            return tuple(p + thickness / 2 * (s * a + u * b) for p, a, b in zip(point, side, up))

        for i in range(4):
            self.face(corner(start, i), corner(end, i), corner(end, i + 1), corner(start, i + 1))
        self.face(*(corner(start, i) for i in range(4)))
        return self.face(*(corner(end, i) for i in (3, 2, 1, 0)))

    def ring(self, rings, sides=24, closed=False):
        """Surface of revolution about Z: `rings` are (radius, z) of regular polygons whose flat sides
        touch the radius from outside; going along them, outside lies to the right."""
        scale = 1 / math.cos(math.pi / sides)
        rows = [[(r * scale * math.cos(2 * math.pi * i / sides), r * scale * math.sin(2 * math.pi * i / sides), z)
                 for i in range(sides)] for r, z in rings]
        for below, above in zip(rows, rows[1:] + (rows[:1] if closed else [])):
            for i in range(sides):
                j = (i + 1) % sides
                quad = [below[i], below[j], above[j], above[i]]
                corners = [c for k, c in enumerate(quad) if c not in quad[:k]]
                if len(corners) > 2:
                    self.face(*corners)
        return self

    def add(self, other, place=lambda corner: corner):
        """Another mesh, each of its corners moved by `place` (a motion, no mirror)."""
        first = len(self.corners)
        self.corners += [place(corner) for corner in other.corners]
        self.faces += [[first + i for i in face] for face in other.faces]
        return self

    def compact(self):
        """Each corner once."""
        number = {}
        self.faces = [[number.setdefault(self.corners[i], len(number)) for i in face] for face in self.faces]
        self.corners = list(number)
        return self

    def write(self, path):
        write_obj(path, self.corners, self.faces)


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


# Strokes of a sign on a field 1 wide and 2 high, as on a seven-segment display; one more for the M.
_STROKES = {"a": ((0, 2), (1, 2)), "b": ((1, 1), (1, 2)), "c": ((1, 0), (1, 1)), "d": ((0, 0), (1, 0)),
            "e": ((0, 0), (0, 1)), "f": ((0, 1), (0, 2)), "g": ((0, 1), (1, 1)),
            "m": ((0.5, 1), (0.5, 2))}
_DIGITS = {"0": "abcdef", "1": "bc", "2": "abged", "3": "abgcd", "4": "fgbc", "5": "afgcd", "6": "afgedc",
           "7": "abc", "8": "abcdefg", "9": "abcdfg", "S": "afgcd", "M": "efabcm", "L": "fed", "H": "fegbc"}


def write_text(text, centre, height, stroke, solid):
    """Digits that are read by looking along +Y at `centre`."""
    unit = height / 2
    pitch = 1.7 * unit
    left = centre[0] - (len(text) * pitch - 0.7 * unit) / 2
    for i, letter in enumerate(text):
        for name in _DIGITS[letter]:
            (x0, z0), (x1, z1) = _STROKES[name]
            xs = sorted((left + i * pitch + x0 * unit, left + i * pitch + x1 * unit))
            zs = sorted((centre[2] + (z0 - 1) * unit, centre[2] + (z1 - 1) * unit))
            solid.box((xs[0] - stroke / 2, xs[1] + stroke / 2), (centre[1] - 0.004, centre[1]),
                      (zs[0] - stroke / 2, zs[1] + stroke / 2), without=("+y",))
    return solid
