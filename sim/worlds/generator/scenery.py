"""What is only seen, or stands round a whole yard: gathered by surface, one mesh each."""

import random

from sdf_writer import box, mesh, plane

from .furniture import broadleaf, conifer
from .module import part
from .solid import Solid
from .surfaces import CONCRETE, FOREST, GRASS, LINE, MEADOW, WOOD, WOOD_DARK, YELLOW_LINE


class Scenery:
    """Meshes to be seen, one for each surface, in the module's own frame."""

    def __init__(self, name, folder):
        self.name, self.folder, self.parts = name, folder, {}

    def of(self, surface_name, surface):
        return self.parts.setdefault(surface_name, (surface, Solid()))[1]

    def pave(self, surface_name, surface, x, y, layer):
        """Paint on level ground; higher layers lie 4 mm above lower ones, so that no two fight for a
        pixel."""
        self.of(surface_name, surface).floor(x, y, 0.004 * layer)

    def link(self):
        link = part()
        for surface_name, (surface, solid) in self.parts.items():
            link.visual(write_mesh(solid, f"{self.name}_{surface_name}", self.folder), surface)
        return link


def write_mesh(solid, name, folder, scale=None):
    solid.write(folder / f"{name}.obj")
    return mesh(f"meshes/{name}.obj", scale)


def start_pad(scenery):
    scenery.pave("concrete", CONCRETE, (-1.5, 1.5), (-1.5, 1.5), 2)
    start_frame(scenery)


def start_frame(scenery):
    """What is painted of a start pad, on whatever there is."""
    for side in (-1, 1):
        edge = sorted((side * 1.37, side * 1.47))
        scenery.pave("yellow", YELLOW_LINE, edge, (-1.47, 1.47), 3)
        scenery.pave("yellow", YELLOW_LINE, (-1.37, 1.37), edge, 3)
    # Arrow: forward is north.
    scenery.pave("line", LINE, (-0.04, 0.04), (0.65, 1.0), 3)
    scenery.of("line", LINE).face((-0.18, 1.0, 0.012), (0.18, 1.0, 0.012), (0, 1.25, 0.012))


def fence(half, name, folder):
    """Posts every 5 m, three rails; isectors meet one slab a side."""
    posts, rails = Solid(), Solid()
    link = part()
    turns = (lambda x, y: (x, y), lambda x, y: (-y, x), lambda x, y: (-x, -y), lambda x, y: (y, -x))
    for angle, turn in zip((0, 90, 180, 270), turns):
        def place(corner, turn=turn):
            return (*turn(corner[0], corner[1]), corner[2])

        row = Solid()
        for i in range(int(2 * half / 5)):
            x = -half + 5 * i
            row.box((x - 0.045, x + 0.045), (half - 0.045, half + 0.045), (0, 1.9), without=("-z",))
        posts.add(row, place)
        row = Solid()
        for z in (0.55, 1.05, 1.55):
            row.box((-half, half), (half - 0.02, half + 0.02), (z - 0.07, z + 0.07), without=("-x", "+x"))
        rails.add(row, place)
        link.collision(box(2 * half, 0.10, 1.9), place((0, half, 0.95)), (0, 0, angle))
    link.visual(write_mesh(posts, f"{name}_posts", folder), WOOD_DARK)
    return link.visual(write_mesh(rails, f"{name}_rails", folder), WOOD)


def ground(patches, half, seen):
    """Level ground: `patches` ((x from, to), (y from, to)) inside the fence to stand on and to see, and
    grass round them, from `half` to `seen` metres from the middle, to be seen only."""
    link = part()

    def lay(add, x, y, cell):
        size = (x[1] - x[0], y[1] - y[0])
        middle = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, 0)
        add(plane(*size, cell), middle)

    def see(shape, at):
        link.visual(shape, GRASS, at)

    for x, y in patches:
        lay(see, x, y, 5)
        lay(link.collision, x, y, 4)
    lay(see, (-seen, seen), (half, seen), 10)
    lay(see, (-seen, seen), (-seen, -half), 10)
    lay(see, (-seen, -half), (-half, half), 10)
    lay(see, (half, seen), (-half, half), 10)
    return link


def land(yard):
    """Hills and forest, pushed out a fifth further than round the flat module, since the yard is larger;
    5 cm lower, so that they meet the grass at no pixel."""
    link = part().visual(mesh("meshes/hills.obj", (1.2, 1.2, 1)), MEADOW, (0, 0, -0.05))
    yard.model(f"{yard.name}_land", link.visual(mesh("meshes/forest.obj", (1.2, 1.2, 1)), FOREST))


def trees(yard, spots, seed):
    rng = random.Random(seed)
    for i, (x, y) in enumerate(spots):
        scale = rng.uniform(0.9, 1.5)
        tree = conifer(scale) if i % 3 == 1 else broadleaf(scale, rng)
        yard.model(f"{yard.name}_tree_{i + 1}", tree, (x, y, 0), rng.uniform(0, 360))
