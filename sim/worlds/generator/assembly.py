"""What a room is furnished with: boxes and meshes gathered by surface, to be seen, and all that is run
into as one mesh. So a whole room costs the file a dozen elements."""

import math

from . import surfaces
from .module import part
from .scenery import write_mesh
from .solid import Solid

_NAMES = {id(value): name.lower() for name, value in vars(surfaces).items() if name.isupper()}


def turned(xyz, heading_deg):
    """The motion that sets a thing down at `xyz`, turned counter-clockwise."""
    turn = math.radians(heading_deg)
    c, s = round(math.cos(turn), 12), round(math.sin(turn), 12)
    return lambda p: (xyz[0] + c * p[0] - s * p[1], xyz[1] + s * p[0] + c * p[1], xyz[2] + p[2])


def _points(corners):
    """The middle of a face, and its corners drawn in a little; all moved out of it by a hair."""
    a, b, c = corners[:3]
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(b, c)]
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(sum(n * n for n in normal)) or 1.0
    middle = [sum(axis) / len(corners) for axis in zip(*corners)]
    hair = [1e-4 * n / length for n in normal]
    return [tuple(m + 0.98 * (p - m) + h for p, m, h in zip(corner, middle, hair)) for corner in (*corners, middle)]


class Assembly:
    """In a frame of its own; what is `met` by isectors is what the BUMP proxy is made of."""

    def __init__(self):
        self.seen, self.met, self.boxes = {}, Solid(), []

    def _is_hidden(self, corners):
        """On the floor, or each of its points in some box."""
        points = _points(corners)
        return all(p[2] < 0 for p in points) or all(
            any(x[0] <= p[0] <= x[1] and y[0] <= p[1] <= y[1] and z[0] <= p[2] <= z[1] for x, y, z in self.boxes)
            for p in points)

    def trim(self):
        """Leaves out the faces that nobody sees."""
        for _, solid in self.seen.values():
            solid.faces = [face for face in solid.faces
                           if len(face) != 4 or not self._is_hidden([solid.corners[i] for i in face])]
        return self

    def of(self, surface):
        return self.seen.setdefault(_NAMES[id(surface)], (surface, Solid()))[1]

    def box(self, surface, x, y, z, met=True, without=()):
        x, y, z = sorted(x), sorted(y), sorted(z)
        self.of(surface).box(x, y, z, without)
        self.boxes.append((x, y, z))
        if met:
            self.met.box(x, y, z)
        return self

    def show(self, surface, x, y, z, without=()):
        """Too small, too thin or too high to be run into."""
        return self.box(surface, x, y, z, met=False, without=without)

    def panel(self, surface, x, y, z, side=-1):
        """A flat thing on a face at `y` that looks towards -Y, or +Y."""
        corners = [(x[0], y, z[0]), (x[1], y, z[0]), (x[1], y, z[1]), (x[0], y, z[1])]
        self.of(surface).face(*(corners if side < 0 else reversed(corners)))
        return self

    def pave(self, surface, x, y, z):
        self.of(surface).floor(x, y, z)
        return self

    def round(self, surface, at, radius, z, sides=12, met=False, top_radius=None):
        """An upright cylinder or cone about `at` (x, y)."""
        upper = radius if top_radius is None else top_radius
        ring = Solid().ring([(0, z[0]), (radius, z[0]), (upper, z[1]), (0, z[1])], sides)
        self.of(surface).add(ring, turned((*at, 0), 0))
        if met:
            wide = max(radius, upper)
            self.met.box((at[0] - wide, at[0] + wide), (at[1] - wide, at[1] + wide), z)
        return self

    def put(self, other, xyz=(0, 0, 0), heading_deg=0):
        """Another assembly, set down in this one."""
        place = turned(xyz, heading_deg)
        for surface, solid in other.trim().seen.values():
            self.of(surface).add(solid, place)
        self.met.add(other.met, place)
        return self

    def seen_by(self, link, name, folder, shadow=True):
        self.trim()
        for surface_name, (surface, solid) in self.seen.items():
            link.visual(write_mesh(solid.compact(), f"{name}_{surface_name}", folder), surface, shadow=shadow)
        return link

    def link(self, name, folder, shadow=True):
        """`shadow`: False for what the sun does not reach."""
        link = self.seen_by(part(), name, folder, shadow)
        if self.met.faces:
            link.collision(write_mesh(self.met.compact(), f"{name}_bump", folder), proxy="bump")
        return link
