# SPDX-License-Identifier: GPL-3.0-or-later
"""GLB files before the validator of Khronos, whose format it is."""
import pathlib

from check import Check, require, said_by

FAULTS = pathlib.Path(__file__).with_name("gltf_faults.cjs")


def valid(garment):
    said = said_by("node", FAULTS, garment.file("glb"))
    require(not said, said.strip())


CHECKS = [Check("GLB", "Khronos' validator", "neither error nor warning", "", valid, ("node",),
                node="gltf-validator")]
