#!/usr/bin/env python3
"""Draws studio.hdr: three soft boxes before a dim wall, as a Radiance picture of all directions."""
import math
import pathlib

WIDTH, HEIGHT = 64, 33
# Left and right edge in columns, upper and lower edge in rows, colour.
BOXES = [(8, 18, 6, 14, (9, 8, 6.5)), (38, 44, 8, 20, (3, 4, 6)), (54, 62, 2, 5, (14, 14, 14))]


def radiance(x, y):
    for left, right, top, bottom, colour in BOXES:
        if left <= x < right and top <= y < bottom:
            return colour
    shade = 0.06 + 0.14 * (1 - y / (HEIGHT - 1))
    return (shade, shade, 1.1 * shade)


def rgbe(colour):
    mantissa, exponent = math.frexp(max(colour))
    scale = mantissa * 256 / max(colour)
    return bytes(int(c * scale) for c in colour) + bytes([exponent + 128])


pixels = b"".join(rgbe(radiance(x, y)) for y in range(HEIGHT) for x in range(WIDTH))
head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n"
pathlib.Path(__file__).with_name("studio.hdr").write_bytes(head.encode() + pixels)
