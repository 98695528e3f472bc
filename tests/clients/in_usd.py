# SPDX-License-Identifier: GPL-3.0-or-later
"""USD scenes, which no program of Debian 12 reads: by our own reader, and by usdchecker."""
from check import Check, near, require, said_by, same

WITHIN = 0.02  # mm


def ours(garment):
    require("usda" in garment.read_back, "was not read back")
    pieces, difference = garment.read_back["usda"]
    same(pieces, len(garment.pieces), "pieces")
    return near(difference, 0, WITHIN, "largest difference")


def checked(garment):
    said_by("usdchecker", garment.file("usda"))


CHECKS = [
    Check("USD", "our own reader", "places and UV of every piece, the seams", f"{WITHIN} mm", ours),
    Check("USD", "usdchecker", "finds nothing", "", checked, ("usdchecker",)),
]
