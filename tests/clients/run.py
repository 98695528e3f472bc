#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has other programs open the files that Toile writes, and checks what they see in them.

    tests/clients/run.py [--toile PROGRAM] [--work FOLDER] [--only WORD] [--write-docs]

Writes each garment in every format, then runs every check; one whose client is not installed is
skipped by name. Ends with 1 where a check fails, or where all ran and the table of docs/exports.md
is not what came of it; --write-docs writes it. Which clients, and where from: tests/nightly.sh.
The system's Python is the one that has Debian's ezdxf.
"""
import argparse
import pathlib
import sys
import traceback

import beside_clo
import docs_table
import in_blender
import in_drawings
import in_ezdxf
import in_garmentcode
import in_gltf_validator
import in_librecad
import in_usd
import in_viewers
from check import Fault, missing
from garments import ROOT, garments

MODULES = (in_ezdxf, in_librecad, beside_clo, in_viewers, in_drawings, in_blender,
           in_gltf_validator, in_usd, in_garmentcode)


def result_of(check, garment):
    """What came of it in a word, and why."""
    try:
        worst = check.run(garment)
        return "passed", "" if worst is None else f"largest difference {worst:.4f} mm"
    except Fault as fault:
        return "FAILED", str(fault)
    except Exception:  # a client's own, or what our check did not expect of it
        return "FAILED", traceback.format_exc().strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--toile", default=ROOT / "build/release/app/toile", type=pathlib.Path)
    parser.add_argument("--work", default=ROOT / "build/clients", type=pathlib.Path)
    parser.add_argument("--only", default="", help="checks with this word in format or client")
    parser.add_argument("--write-docs", action="store_true")
    given = parser.parse_args()
    checks = [check for module in MODULES for check in module.CHECKS
              if given.only in f"{check.format} {check.client}"]
    found, failed, skipped = garments(given.work.resolve()), 0, set()
    results = {check: {} for check in checks}
    for garment in found:
        garment.write(given.toile.resolve())
        for check in checks:
            if check.garment not in ("", garment.name):
                continue
            lacking = missing(check)
            word, why = ("skipped", f"{lacking} is not there") if lacking else result_of(
                check, garment)
            failed += word == "FAILED"
            if lacking:
                skipped.add(lacking)
            results[check][garment.name] = word
            print(f"{word}  {garment.name:9}  {check.format:12}  {check.client:12}  {check.what}"
                  + (f": {why}" if why else ""), flush=True)
    print(f"{failed} failed; not there: {', '.join(sorted(skipped)) or 'none'}")
    return 1 if failed else docs_table.settle(results, found, skipped, given)


if __name__ == "__main__":
    sys.exit(main())
