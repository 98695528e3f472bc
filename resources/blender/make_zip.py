#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on as Blender installs it: make_zip.py OUT.zip. Same sources, same bytes."""

import pathlib
import sys
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent / "toile_blender"
EPOCH = (1980, 1, 1, 0, 0, 0)  # of every entry


def make_zip(target: str) -> None:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(FOLDER.glob("*.py")):
            entry = zipfile.ZipInfo(f"{FOLDER.name}/{path.name}", EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, path.read_bytes())


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    make_zip(sys.argv[1])
