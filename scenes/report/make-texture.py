#!/usr/bin/env python3
"""Draws globe.png, the texture of scene 1: an imagined planet, seamless from left to right.

Only whole numbers decide the colours, so that every machine writes the same pixels:
    python3 scenes/report/make-texture.py
"""
import os
import struct
import zlib

WIDTH, HEIGHT = 720, 360
ONE = 1 << 16

# Height of the land in 1/65536, and the colour there (sRGB).
LEVELS = [
    (0.00, (22, 62, 128)),
    (0.40, (36, 104, 176)),
    (0.495, (92, 176, 206)),
    (0.505, (214, 196, 146)),
    (0.53, (142, 178, 92)),
    (0.60, (86, 146, 78)),
    (0.68, (168, 134, 88)),
    (0.76, (206, 182, 150)),
    (1.00, (238, 236, 230)),
]
LEVELS = [(int(height * ONE), colour) for height, colour in LEVELS]
ICE, LINE = (240, 245, 248), (248, 216, 140)


def lattice(x, y, z):
    """A random number from 0 to 65535 for each point of the lattice."""
    h = (x * 0x9E3779B1 ^ y * 0x85EBCA77 ^ z * 0xC2B2AE3D) & 0xFFFFFFFF
    for shift, factor in ((15, 0x2C1B3C6D), (12, 0x297A2D39)):
        h = (h ^ h >> shift) * factor & 0xFFFFFFFF
    return (h ^ h >> 15) & 0xFFFF


def mix(a, b, t):
    return a + (b - a) * t // ONE


def smooth(t):
    return t * t // ONE * (3 * ONE - 2 * t) // ONE


def noise(p, seed):
    """Value noise (Perlin 1985 describes the family) at a point in 1/65536 of a lattice cell."""
    cell = [c >> 16 for c in p]
    tx, ty, tz = (smooth(c & 0xFFFF) for c in p)
    planes = []
    for z in (0, 1):
        rows = []
        for y in (0, 1):
            at = (cell[1] + y, cell[2] + z + 977 * seed)
            rows.append(mix(lattice(cell[0], *at), lattice(cell[0] + 1, *at), tx))
        planes.append(mix(*rows, ty))
    return mix(*planes, tz)


def fractal(p, octaves, seed):
    total, weight, sum_of_weights = 0, ONE, 0
    for octave in range(octaves):
        total += noise([c << octave for c in p], seed + octave) * weight
        sum_of_weights += weight
        weight //= 2
    return total // sum_of_weights


def sine(turn):
    """Sine of 1/65536 turns after Bhaskara I, good to 0.2 %, in 1/65536."""
    turn &= 0xFFFF
    half = turn & 0x7FFF
    product = half * (0x8000 - half)
    value = 16 * product * ONE // (5 * 0x8000 * 0x8000 - 4 * product)
    return -value if turn & 0x8000 else value


def colour_of(level):
    for (low, below), (high, above) in zip(LEVELS, LEVELS[1:]):
        if level < high:
            t = (level - low) * ONE // (high - low)
            return [mix(a, b, t) for a, b in zip(below, above)]
    return LEVELS[-1][1]


def pixel(x, y):
    longitude, latitude = (2 * x + 1) * 0x8000 // WIDTH, (2 * y + 1) * 0x4000 // HEIGHT
    ring, up = sine(latitude), sine(latitude + 0x4000)
    point = [ring * sine(longitude + 0x4000) // ONE, up, ring * sine(longitude) // ONE]
    far = [(c + 3 * ONE) * 8 // 5 for c in point]
    level = fractal(far, 6, 1)
    # Noise crowds around one half: spread it out.
    level = max(0, min(ONE - 1, (level - ONE // 2) * 9 // 5 + ONE // 2))
    colour = colour_of(level)
    if abs(up) + (level - ONE // 2) // 3 > 59500:
        colour = ICE
    # A net of meridians and parallels, 15 degrees apart; meridians end near the poles.
    across = min(longitude * 24 % ONE, -longitude * 24 % ONE)
    along = min(latitude * 24 % ONE, -latitude * 24 % ONE)
    if along < 2400 or (across * ring // ONE < 2400 and ring > 18000):
        colour = [mix(a, b, ONE * 2 // 5) for a, b in zip(colour, LINE)]
    return bytes(colour)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    rows = []
    previous = bytes(3 * WIDTH)
    for y in range(HEIGHT):
        row = b"".join(pixel(x, y) for x in range(WIDTH))
        rows.append(b"\2" + bytes((a - b) & 0xFF for a, b in zip(row, previous)))
        previous = row
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"sRGB", b"\0")
    png += chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b"")
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "globe.png"), "wb") as file:
        file.write(png)


if __name__ == "__main__":
    main()
