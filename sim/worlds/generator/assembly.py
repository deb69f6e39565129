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


class Assembly:
    """In a frame of its own; what is `met` by isectors is what the BUMP proxy is made of."""

    def __init__(self):
        self.seen, self.met = {}, Solid()

    def of(self, surface):
        return self.seen.setdefault(_NAMES[id(surface)], (surface, Solid()))[1]

    def box(self, surface, x, y, z, met=True, without=()):
        x, y, z = sorted(x), sorted(y), sorted(z)
        self.of(surface).box(x, y, z, without)
        if met:
            self.met.box(x, y, z)
        return self

    def show(self, surface, x, y, z, without=()):
        """Too small, too thin or too high to be run into."""
        return self.box(surface, x, y, z, met=False, without=without)

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
        for surface, solid in other.seen.values():
            self.of(surface).add(solid, place)
        self.met.add(other.met, place)
        return self

    def seen_by(self, link, name, folder):
        for surface_name, (surface, solid) in self.seen.items():
            link.visual(write_mesh(solid, f"{name}_{surface_name}", folder), surface)
        return link

    def link(self, name, folder):
        link = self.seen_by(part(), name, folder)
        if self.met.faces:
            link.collision(write_mesh(self.met, f"{name}_bump", folder), proxy="bump")
        return link
