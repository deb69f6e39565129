"""Fields of a standard course: continuous pitch/roll ramps, and posts of many heights."""

from sdf_writer import box

from .module import part
from .scenery import write_mesh
from .solid import Solid
from .surfaces import HAZARD, WOOD

TILE_RUN, TILE_WIDTH, TILE_RISE = 0.59, 1.18, 0.17


def crossing_ramps(rows=6):
    """Two columns of half ramps, up and down in turn; the right one begins a tile later, so that one
    track climbs while the other one descends."""
    solid = Solid()
    for x, first in (((-TILE_WIDTH, 0), 0.0), ((0, TILE_WIDTH), TILE_RUN)):
        for i in range(rows):
            y = first + i * TILE_RUN
            solid.wedge(x, (y, y + TILE_RUN), TILE_RISE if i % 2 == 0 else -TILE_RISE)
    return solid


def skin_over(columns, rows, side, height):
    """What a track stands on: a skin over the posts' upper edges, with a lead-in all round. The field is
    centred in x and begins at y = 0."""
    skin, left = Solid(), round(-columns * side / 2, 9)

    def corner(i, j):
        near = [height(a, b) for a in (i - 1, i) for b in (j - 1, j) if 0 <= a < columns and 0 <= b < rows]
        border = i in (-1, columns + 1) or j in (-1, rows + 1)
        return (left + i * side, j * side, 0.0 if border else max(near))

    for i in range(-1, columns + 1):
        for j in range(-1, rows + 1):
            a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            skin.face(a, b, c).face(a, c, d)
    return skin


def whole_posts(columns, rows, side, height):
    """All of every post."""
    posts = Solid()
    for i in range(columns):
        for j in range(rows):
            x, y = round(-columns * side / 2, 9) + i * side, j * side
            if height(i, j) > 0:
                posts.box((x, x + side), (y, y + side), (0, height(i, j)), without=("-z",))
    return posts


def posts_as_seen(columns, rows, side, height):
    """Of every post what sticks out of its neighbours."""
    posts = Solid()

    def reach(i, j):
        return height(i, j) if 0 <= i < columns and 0 <= j < rows else 0.0

    for i in range(columns):
        for j in range(rows):
            x, y, top = round(-columns * side / 2, 9) + i * side, j * side, height(i, j)
            if top > 0:
                posts.floor((x, x + side), (y, y + side), top)
            for name, foot in (("-x", reach(i - 1, j)), ("+x", reach(i + 1, j)), ("-y", reach(i, j - 1)),
                               ("+y", reach(i, j + 1))):
                if foot < top:
                    others = {"-x", "+x", "-y", "+y", "-z", "+z"} - {name}
                    posts.box((x, x + side), (y, y + side), (foot, top), without=others)
    return posts


def stepfield(name, posts, skin, length, width, folder):
    """CLAMP is the skin, BUMP are the posts."""
    body = write_mesh(posts, name, folder)
    link = part().visual(body, WOOD).collision(body, proxy="bump")
    link.collision(write_mesh(skin, f"{name}_clamp", folder), proxy="clamp")
    for x in (-width / 2 - 0.03, width / 2 + 0.03):
        link.visual(box(0.05, length, 0.08), HAZARD, (x, length / 2, 0.04))
    return link
