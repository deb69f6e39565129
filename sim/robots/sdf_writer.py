"""Writes SDFormat: the few words that the robot and the world files share. Python 3, no packages."""

import math

HEADER = """<?xml version="1.0"?>
<!-- Written by {script}; edit that and run it again. Elements eod:… are ours, others pass them over. -->
<sdf version="1.9" xmlns:eod="https://eod-simulator.invalid/sdf">
"""


def numbers(values):
    """Numbers as short as they can be without losing a bit."""
    return " ".join(repr(round(v, 12) + 0.0).removesuffix(".0") for v in values)


class Surface:
    """Colour (linear 0..1), texture by name, size of one tile [m], gloss 0..1."""

    def __init__(self, colour, texture="plain", tile=1.0, gloss=0.05):
        self.colour, self.texture, self.tile, self.gloss = colour, texture, tile, gloss

    def lines(self):
        return [
            "<material>",
            f"  <diffuse>{numbers(self.colour)} 1</diffuse>",
            f"  <specular>{numbers([self.gloss] * 3)} 1</specular>",
            "</material>",
            f'<eod:surface texture="{self.texture}" tile="{numbers([self.tile])}"/>',
        ]


def indent(lines, by=2):
    return [" " * by + line for line in lines]


def element(tag, lines):
    """<tag …> around lines."""
    return [f"<{tag}>", *indent(lines), f"</{tag.split()[0]}>"]


def pose(xyz=(0, 0, 0), rpy_deg=(0, 0, 0), relative_to=None):
    """Pose element; angles about the fixed axes X, Y, Z in degrees."""
    if not any(xyz) and not any(rpy_deg) and relative_to is None:
        return []
    frame = f' relative_to="{relative_to}"' if relative_to else ""
    return [f"<pose{frame}>{numbers([*xyz, *(math.radians(a) for a in rpy_deg)])}</pose>"]


def box(x, y, z):
    return [f"<geometry><box><size>{numbers([x, y, z])}</size></box></geometry>"]


def cylinder(radius, length):
    return [f"<geometry><cylinder><radius>{numbers([radius])}</radius>"
            f"<length>{numbers([length])}</length></cylinder></geometry>"]


def cone(radius, length):
    """A cylinder for other tools, a cone with its tip up for ours."""
    return [*cylinder(radius, length), "<eod:cone/>"]


def sphere(radius):
    return [f"<geometry><sphere><radius>{numbers([radius])}</radius></sphere></geometry>"]


def plane(x, y, cell):
    return [f"<geometry><plane><normal>0 0 1</normal><size>{numbers([x, y])}</size></plane></geometry>",
            f'<eod:grid cell="{numbers([cell])}"/>']


def mesh(uri, scale=None):
    size = f"<scale>{numbers(scale)}</scale>" if scale else ""
    return [f"<geometry><mesh><uri>{uri}</uri>{size}</mesh></geometry>"]


class Link:
    """Collects the parts of a link; names of visuals and collisions count up."""

    def __init__(self, name):
        self.name, self.parts, self.count = name, [], 0

    def mass(self, kilograms, xyz=(0, 0, 0)):
        """What the link weighs, and where its centre of mass is."""
        self.parts += element("inertial", [*pose(xyz), f"<mass>{numbers([kilograms])}</mass>"])
        return self

    def visual(self, shape, surface, xyz=(0, 0, 0), rpy_deg=(0, 0, 0), shadow=True):
        self.count += 1
        dark = [] if shadow else ["<cast_shadows>false</cast_shadows>"]
        self.parts += element(f'visual name="v{self.count}"',
                              [*pose(xyz, rpy_deg), *dark, *shape, *surface.lines()])
        return self

    def collision(self, shape, xyz=(0, 0, 0), rpy_deg=(0, 0, 0), proxy="both"):
        self.count += 1
        kind = [] if proxy == "both" else [f'<eod:proxy kind="{proxy}"/>']
        self.parts += element(f'collision name="c{self.count}"', [*pose(xyz, rpy_deg), *shape, *kind])
        return self

    def solid(self, shape, surface, xyz=(0, 0, 0), rpy_deg=(0, 0, 0)):
        """Seen, and met by isectors."""
        return self.visual(shape, surface, xyz, rpy_deg).collision(shape, xyz, rpy_deg)

    def inertial(self, mass, moments, xyz=(0, 0, 0)):
        """Mass [kg], principal moments about the centre of mass at `xyz` [kg m^2]."""
        ixx, iyy, izz = (f"<{name}>{numbers([value])}</{name}>"
                         for name, value in zip(("ixx", "iyy", "izz"), moments))
        self.parts += element("inertial", [*pose(xyz), f"<mass>{numbers([mass])}</mass>",
                                           f"<inertia>{ixx}{iyy}{izz}</inertia>"])
        return self

    def lines(self, *, xyz=(0, 0, 0), rpy_deg=(0, 0, 0), relative_to=None):
        return element(f'link name="{self.name}"', [*pose(xyz, rpy_deg, relative_to), *self.parts])


def write_obj(path, corners, faces):
    """Wavefront OBJ; faces count corners from 0, counter-clockwise seen from outside."""
    with open(path, "w", encoding="ascii", newline="\n") as out:
        for corner in corners:
            out.write("v " + " ".join(f"{c:.4f}" for c in corner) + "\n")
        for face in faces:
            out.write("f " + " ".join(str(i + 1) for i in face) + "\n")


def write_extrusion(path, profile_yz, width):
    """OBJ of a convex profile in the YZ plane (counter-clockwise seen from +X), `width` along X."""
    n = len(profile_yz)
    corners = [(s * width / 2, y, z) for s in (1, -1) for y, z in profile_yz]
    faces = [list(range(n)), [n + i for i in reversed(range(n))]]
    faces += [[i, n + i, n + (i + 1) % n, (i + 1) % n] for i in range(n)]
    write_obj(path, corners, faces)
