"""Many things as one model: what they look like gathered by surface, one mesh each, and what robots meet of
them in one mesh. An element of the world's file costs more time to read than a hundred triangles."""

import math

from .module import part
from .scenery import write_mesh
from .solid import Solid


def at(x, y, z=0.0, heading_deg=0.0):
    """Motion of a thing's frame to its place; exact for quarter turns."""
    quarter = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}
    angle = math.radians(heading_deg)
    c, s = quarter.get(heading_deg % 360, (math.cos(angle), math.sin(angle)))
    return lambda p: (x + c * p[0] - s * p[1], y + s * p[0] + c * p[1], z + p[2])


class Gathered:
    """Meshes by surface; `body` is stood on and run into, `clamp` only stood on, `bump` only run into."""

    def __init__(self):
        self.parts, self.body, self.clamp, self.bump = {}, Solid(), Solid(), Solid()

    def of(self, name, surface):
        return self.parts.setdefault(name, (surface, Solid()))[1]

    def block(self, name, surface, x, y, z, without=()):
        """A box that is seen and met."""
        self.of(name, surface).box(x, y, z, without)
        self.body.box(x, y, z)
        return self

    def add(self, other, place):
        for name, (surface, solid) in other.parts.items():
            self.of(name, surface).add(solid, place)
        for mine, theirs in ((self.body, other.body), (self.clamp, other.clamp), (self.bump, other.bump)):
            mine.add(theirs, place)
        return self

    def link(self, name, folder):
        link = part()
        for surface_name, (surface, solid) in self.parts.items():
            link.visual(write_mesh(solid.compact(), f"{name}_{surface_name}", folder), surface)
        for proxy, solid in (("both", self.body), ("clamp", self.clamp), ("bump", self.bump)):
            if solid.faces:
                link.collision(write_mesh(solid.compact(), f"{name}_{proxy}", folder), proxy=proxy)
        return link

    def stand(self, yard, name, folder, xyz=(0, 0, 0), heading_deg=0):
        """As a model of its own."""
        yard.model(name, self.link(name, folder), xyz, heading_deg)

    def stand_about(self, yard, name, folder, middle):
        """As a model whose frame is moved to its `middle` (x, y): pictures leave out what lies elsewhere by
        the frames of the meshes."""
        here = Gathered().add(self, at(-middle[0], -middle[1]))
        yard.model(name, here.link(name, folder), (*middle, 0))
