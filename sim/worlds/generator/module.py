"""A training area of the world file, and the links that its models are made of."""

from sdf_writer import Link, element, numbers, pose


class Module:
    """One training area: collects its models, and its lights if it has any."""

    def __init__(self, number, name, origin, size):
        self.number, self.name, self.origin, self.size = number, name, origin, size
        self.models, self.lights = [], []

    def model(self, name, link, xyz=(0, 0, 0), heading_deg=0):
        lines = ["<static>true</static>", *pose(xyz, (0, 0, heading_deg), self.name), *link.lines()]
        self.models += element(f'model name="{name}"', lines)

    def vessel(self, name, link, xyz, description):
        """A containment vessel; `description`: attributes of <eod:vessel>."""
        lines = ["<static>true</static>", *pose(xyz, relative_to=self.name),
                 f"<eod:vessel {description}/>", *link.lines()]
        self.models += element(f'model name="{name}"', lines)

    def movable(self, name, link, xyz, friction, explosive=False):
        """A thing that moves by itself; its link has an inertial."""
        lines = [*pose(xyz, relative_to=self.name), f'<eod:movable friction="{numbers([friction])}"/>',
                 *(["<eod:explosive/>"] if explosive else []), *link.lines()]
        self.models += element(f'model name="{name}"', lines)

    def lines(self):
        x, y = self.size
        return [f'<frame name="{self.name}"><pose>{numbers([*self.origin, 0, 0, 0])}</pose></frame>',
                f'<eod:module id="{self.number}" name="{self.name}" frame="{self.name}" '
                f'size_x_m="{numbers([x])}" size_y_m="{numbers([y])}" start_heading_deg="0"/>',
                *self.lights, *self.models]


def part():
    return Link("link")
