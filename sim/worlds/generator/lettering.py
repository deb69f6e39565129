"""Words on signs and on the road: letters of straight strokes."""

import math

from .solid import Solid

# Strokes on a field 2 wide and 4 high: x0 z0 x1 z1.
_LETTERS = {
    "A": "0014 1420 0.5,1.4,1.5,1.4", "B": "0004 0,4,1.7,4 1.7,4,1.7,2 0222 2220 0020",
    "C": "2404 0400 0020", "D": "0004 0,4,1.3,4 1.3,4,2,3.2 2,3.2,2,0.8 2,0.8,1.3,0 1.3,0,0,0",
    "E": "2404 0400 0020 0,2,1.6,2",
    "F": "2404 0400 0,2,1.6,2", "G": "2404 0400 0020 2022 1222", "H": "0004 2024 0222", "I": "1014",
    "J": "2420 2000 0001", "K": "0004 0224 0220", "L": "0400 0020", "M": "0004 0412 1224 2420",
    "N": "0004 0420 2024", "O": "0004 0424 2420 2000", "P": "0004 0424 2422 2202",
    "Q": "0004 0424 2420 2000 1220", "R": "0004 0424 2422 2202 0.8,2,2,0", "S": "2404 0402 0222 2220 2000",
    "T": "0424 1410", "U": "0400 0020 2024", "V": "0410 1024", "W": "0400 0012 1220 2024", "X": "0024 0420",
    "Y": "0412 2412 1210", "Z": "0424 2400 0020",
    "0": "0004 0424 2420 2000", "1": "1014", "2": "0424 2422 2202 0200 0020", "3": "0424 2420 2000 0222",
    "4": "0402 0222 2420", "5": "2404 0402 0222 2220 2000", "6": "2404 0400 0020 2022 2202", "7": "0424 2410",
    "8": "0004 0424 2420 2000 0222", "9": "2000 2024 2404 0402 0222", " ": ""}
_WIDTH, _PITCH = 2, 3.1


def _strokes(letter):
    for word in _LETTERS[letter].split():
        yield [float(v) for v in (word.split(",") if "," in word else word)]


def word_width(text, height):
    return ((len(text) - 1) * _PITCH + _WIDTH) * height / 4


def word(text, centre, height, thickness, solid, condensed=1.0):
    """Flat letters that face -Y, read by looking along +Y; `centre`: middle of the word [m]."""
    unit = height / 4
    left = centre[0] - word_width(text, height) * condensed / 2
    for i, letter in enumerate(text):
        for x0, z0, x1, z1 in _strokes(letter):
            start = (left + (i * _PITCH + x0) * unit * condensed, centre[2] + (z0 - 2) * unit)
            end = (left + (i * _PITCH + x1) * unit * condensed, centre[2] + (z1 - 2) * unit)
            length = math.dist(start, end)
            along = [(e - s) / length for s, e in zip(start, end)]
            side = [-along[1] * thickness / 2, along[0] * thickness / 2]
            reach = [a * thickness / 2 for a in along]
            corners = ((start, -1, -1), (end, 1, -1), (end, 1, 1), (start, -1, 1))
            solid.face(*((p[0] + s * reach[0] + t * side[0], centre[1], p[1] + s * reach[1] + t * side[1])
                         for p, s, t in corners))
    return solid


def word_on_road(text, centre, height, thickness, solid):
    """Letters on level ground, read by looking along +Y; `height` runs along Y, three times as long as
    they would be on a wall."""
    flat = word(text, (0, 0, 0), height, thickness, Solid(), 0.45)
    return solid.add(flat, lambda c: (c[0] + centre[0], c[2] + centre[1], centre[2]))
