# SPDX-License-Identifier: GPL-3.0-or-later
"""What a check is, and how one asks another program."""
import dataclasses
import os
import shutil
import subprocess
from typing import Callable


class Fault(Exception):
    """What a client says against a file, or a figure that is not what it should be."""


@dataclasses.dataclass(frozen=True)
class Check:
    format: str  # as the table names it
    client: str
    what: str  # a few words; what is checked
    within: str  # what it is held to; empty: it is so or it is not
    run: Callable  # takes a garment, raises Fault; the largest difference where there is one
    needs: tuple = ()  # programs that must be installed
    python: str = ""  # a Python module that must be there
    node: str = ""  # a package of Node that must be there, on NODE_PATH
    beside: tuple = ()  # files that must be there
    garment: str = ""  # the only one it is about; empty: all


def said_by(*command, folder=None, seconds=300):
    """What a program prints; a Fault where it fails."""
    environment = os.environ | {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
    try:
        done = subprocess.run([str(word) for word in command], cwd=folder, timeout=seconds,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment)
    except subprocess.TimeoutExpired as late:
        raise Fault(f"{command[0]} did not end in {seconds} s") from late
    if done.returncode:
        said = (done.stderr or done.stdout).decode(errors="replace").strip()
        raise Fault(f"{command[0]} ended with {done.returncode}: {said[-300:]}")
    return done.stdout.decode(errors="replace")


def missing(check):
    """Name of what the check needs and is not there, or nothing; see `Check`."""
    for program in check.needs:
        if not shutil.which(program):
            return program
    if check.python:
        try:
            __import__(check.python)
        except ImportError:
            return f"Python's {check.python}"
    if check.node and subprocess.run(
            ["node", "-e", f"require.resolve('{check.node}')"],
            stderr=subprocess.DEVNULL, check=False).returncode:
        return f"Node's {check.node}"
    for path in check.beside:
        if not path.is_file():
            return str(path)
    return ""


def require(holds, message):
    if not holds:
        raise Fault(message)


def same(value, wanted, what):
    require(value == wanted, f"{what}: {value} instead of {wanted}")


def near(value, wanted, within, what):
    """The difference, where it is no Fault."""
    require(abs(value - wanted) <= within,
            f"{what}: {value:.4f} instead of {wanted:.4f}, not within {within}")
    return abs(value - wanted)
