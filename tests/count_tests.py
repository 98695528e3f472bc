#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the tests in a log of CTest and prints "N passed, N failed, N skipped".

    tests/count_tests.py LastTest.log [--max-skipped N]

A test of CTest may run many: GoogleTest, Qt Test and Python's unittest print how many. Anything else
counts as one. Exits with 1 if more than N were skipped, and names them.
"""
import argparse
import re

BLOCK = re.compile(r"^\d+/\d+ Test: (\S+)\n(.*?)^Test (Pass|Fail)(?:ed\.| Reason)", re.S | re.M)
QT = re.compile(r"^Totals: (\d+) passed, (\d+) failed, (\d+) skipped", re.M)
PYTHON = re.compile(r"^Ran (\d+) tests? in .*\n\n(?:OK|FAILED)(.*)", re.M)


def google(text, word):
    return sum(int(n) for n in re.findall(rf"^\[  {word} \] (\d+) tests?[.,]", text, re.M))


def count(text, passed):
    """(passed, failed, skipped) of one test of CTest."""
    if "[==========]" in text or "[  PASSED  ]" in text:
        counts = [google(text, word) for word in ("PASSED ", "FAILED ", "SKIPPED")]
    elif QT.search(text):
        counts = [sum(int(n) for n in column) for column in zip(*QT.findall(text))]
    elif PYTHON.search(text):
        counts = [0, 0, 0]
        for ran, rest in PYTHON.findall(text):
            def number(word):
                return sum(int(n) for n in re.findall(rf"\b{word}=(\d+)", rest))
            failed, skipped = number("failures") + number("errors"), number("skipped")
            counts = [a + b for a, b in zip(counts, (int(ran) - failed - skipped, failed, skipped))]
    else:
        counts = [1, 0, 0] if passed else [0, 1, 0]
    if not passed and counts[1] == 0:  # a crash, or a limit of time
        counts[1] = 1
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("log")
    parser.add_argument("--max-skipped", type=int)
    arguments = parser.parse_args()
    with open(arguments.log, encoding="utf-8", errors="replace") as file:
        text = file.read()
    total, skipping = [0, 0, 0], []
    for name, output, result in BLOCK.findall(text):
        counts = count(output, result == "Pass")
        total = [a + b for a, b in zip(total, counts)]
        if counts[2]:
            skipping.append(f"{name}: {counts[2]}")
    too_many = arguments.max_skipped is not None and total[2] > arguments.max_skipped
    if too_many:
        print(f"More than {arguments.max_skipped} tests were skipped: {', '.join(skipping)}")
    print("{} passed, {} failed, {} skipped".format(*total))
    return 1 if too_many or total[1] or not sum(total) else 0


raise SystemExit(main())
