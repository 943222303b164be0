#!/usr/bin/env python3
"""Draws the pictures of the primer's scenes, with whole numbers only, so that every machine writes the same pixels:
    python3 scenes/primer/textures/make-textures.py

sail.png: a postcard whose left, right, top and bottom cannot be confused. heart.png: eight by eight texels, to be
magnified. lantern.png: a paper lantern, seamless from left to right.
"""
import os
import struct
import zlib

HEART = [
    "........",
    ".rr..RR.",
    "rwrrRRRD",
    "rrrRRRRD",
    "rRRRRRDD",
    ".RRRRDD.",
    "..RRDD..",
    "...DD...",
]
HEART_COLOURS = {".": (250, 236, 214), "w": (255, 214, 206), "r": (240, 92, 84), "R": (214, 44, 58), "D": (150, 22, 52)}


def mix(a, b, numerator, denominator):
    return tuple(p + (q - p) * numerator // denominator for p, q in zip(a, b))


def heart(x, y):
    return HEART_COLOURS[HEART[y][x]]


def left_of(ax, ay, bx, by, x, y):
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0


def triangle(corners, x, y):
    sides = [left_of(*corners[i], *corners[(i + 1) % 3], x, y) for i in range(3)]
    return all(sides) or not any(sides)


def sail(x, y):
    if min(x, y, 191 - x, 191 - y) < 6:
        return 250, 246, 236
    if triangle(((84, 40), (84, 124), (34, 124)), x, y):
        return 250, 244, 230
    if triangle(((90, 56), (90, 124), (122, 124)), x, y):
        return 214, 66, 56
    if 85 <= x <= 89 and 36 <= y < 132:
        return 84, 56, 40
    if 132 <= y < 148 and 40 + (y - 132) <= x <= 124 - (y - 132):
        return 94, 50, 38
    if (x - 146) ** 2 + (y - 54) ** 2 < 22 ** 2:
        return 255, 214, 92
    if y < 136:
        return mix((62, 128, 198), (250, 214, 170), y, 136)
    wave = (x + 3 * (y // 9 % 2) * 8) % 48
    return (74, 158, 178) if y % 9 < 2 and wave < 26 else mix((38, 118, 152), (16, 58, 100), y - 136, 56)


def lantern(x, y):
    if y < 14 or y >= 114:
        return 18, 8, 4
    rib = (x + 8) % 32 < 2 or (y - 14) % 25 < 2
    if rib:
        return 70, 20, 6
    cx, cy = (x + 8) % 32 - 17, (y - 14) % 25 - 13
    # The poles of the sphere draw the picture together: keep the flowers to the middle rows.
    if 1 <= (y - 14) // 25 <= 2 and ((x + 8) // 32 + (y - 14) // 25) % 2 and cx * cx + cy * cy < 81 and (cx * cy) ** 2 < 420:
        return 255, 240, 190
    return mix((255, 164, 70), (240, 96, 36), abs(2 * y - 127), 127)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(name, width, height, pixel):
    rows = [b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height)]
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(b"sRGB", b"\0")
    png += chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b"")
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), name), "wb") as file:
        file.write(png)


if __name__ == "__main__":
    write("heart.png", 8, 8, heart)
    write("sail.png", 192, 192, sail)
    write("lantern.png", 256, 128, lantern)
