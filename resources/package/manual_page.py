#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes toile(1) from what the program says of itself: manual_page.py PROGRAM PAGE FOLDER

FOLDER is where the documentation is installed.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

documentation = ""  # where it is installed
ABOUT = """\
.B toile
opens a garment mesh of several pieces, lays every piece flat at true scale,
shows where the cloth must stretch, and writes the pattern as DXF, PDF, SVG and
more.
Every boundary edge of a flat piece has exactly its 3D length, so that the two
sides of a seam sew.
.PP
Without a command it opens the window, with the files that are given or a
welcome page.
"""

EXAMPLES = {
    "Open a garment in the window": "toile dress.obj --unit cm",
    "Its pattern, exactly as it is in 3D": "toile flatten dress.obj --unit cm -o dress.svg",
    "A pattern to cut and sew, for printing on A4": "toile flatten dress.obj --pattern -o dress.pdf --paper a4",
    "Cut open what cannot lie flat": "toile flatten leggings.ply --auto-cut -o leggings.dxf",
    "Whether it is ready to cut": "toile check dress.obj",
    "A picture of the garment and its strain": "toile render dress.obj --overlay strain -o dress.png",
}


def said(program: str, *words: str) -> str:
    # As a terminal without colours and languages would have it.
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    text = subprocess.run(
        [program, *words], check=True, capture_output=True, text=True, env=environment
    ).stdout
    return re.sub(r"\bdocs/(?=[-\w]+\.md\b)", f"{documentation}/", text)


def plain(text: str) -> str:
    """As roff text: no dash, backslash or leading dot means more than it says."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("~", "\\(ti").replace("^", "\\(ha")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.MULTILINE)


def sections(help_text: str) -> dict[str, list[str]]:
    """The lines below each heading, without its colon; those before the first are at ""."""
    found: dict[str, list[str]] = {"": []}
    name = ""
    for line in help_text.splitlines():
        if heading := re.fullmatch(r"([A-Z][A-Za-z ]*):", line):
            name = heading[1]
            found.setdefault(name, [])
        elif name and line and not line.startswith(" "):
            found[""].append(line)  # a note below the options
        else:
            found[name].append(line)
    return found


def entries(lines: list[str]) -> list[tuple[str, str]]:
    """Names and what is said of them: beside them from a column on, or below where they are long."""
    column = " " * 30
    rows: list[tuple[str, str]] = []
    lines = [line for line in lines if line.strip()]
    for line, below in zip(lines, [*lines[1:], ""]):
        if line.startswith(column) and rows:
            rows[-1] = (rows[-1][0], f"{rows[-1][1]} {line.strip()}".strip())
        elif below.startswith(column):
            rows.append((line.strip(), ""))
        else:
            rows.append((line[: len(column)].strip(), line[len(column) :].strip()))
    return rows


def wrapped(text: str) -> str:
    """In lines short enough for mandoc, also with backslashes; none begins as a request does."""
    return "\n".join(map(plain, textwrap.wrap(text, 64, break_on_hyphens=False)))


def listed(rows: list[tuple[str, str]]) -> str:
    """Options or positionals, each with what stands for its value, and what is said of it."""
    page = ""
    for name, text in rows:
        option, _, value = name.partition(" ")
        page += f".TP\n\\fB{plain(option)}\\fR" + (f" \\fI{plain(value)}\\fR" if value else "")
        page += f"\n{wrapped(text)}\n"
    return page


def usage_of(parts: dict[str, list[str]]) -> str:
    return next(line for line in parts[""] if line.startswith("Usage: ")).removeprefix("Usage: ")


def option_entries(parts: dict[str, list[str]]) -> list[tuple[str, str]]:
    """The options of all sections: `entries` of everything that is nothing else."""
    others = ("", "Positionals", "Help", "Subcommands", "Example", "Exit status")
    return entries([line for name, lines in parts.items() if name not in others for line in lines])


def command_page(program: str, command: str, shared: dict[str, str]) -> str:
    """One command. What was said before, in the same words, is named only.

    shared: what was said of each option so far; is added to.
    """
    parts = sections(said(program, command, "--help"))
    usage = usage_of(parts)
    first, *below = (line for line in parts[""] if line and not line.startswith("Usage: "))
    page = f".SS toile {command}\n{wrapped(first)}.\n"
    page += f".PP\n.B {plain(usage)}\n"
    if below:
        page += f".PP\n{wrapped(' '.join(below))}\n"
    again: list[str] = []
    rows: list[tuple[str, str]] = []
    for name, text in [*entries(parts.get("Positionals", [])), *option_entries(parts)]:
        if shared.get(name) == text:
            again.append(name.split(" ")[0])
        else:
            rows.append((name, text))
            shared.setdefault(name, text)
    page += listed(rows)
    if again:
        page += ".PP\nAnd, as above:\n"
        page += ",\n".join(f"\\fB{plain(option)}\\fR" for option in again) + ".\n"
    page += f".PP\nExample:\n.PP\n.B {plain(' '.join(parts['Example']).strip())}\n"
    return page


def manual_page(program: str) -> str:
    version = said(program, "--version").split()[1]
    parts = sections(said(program, "--help"))
    options = option_entries(parts) + entries(parts["Help"])
    commands = entries(parts["Subcommands"])
    described = (Path(__file__).parent / "toile.metainfo.xml").read_text(encoding="utf-8")
    date = re.search(r'<release [^>]*date="([^"]*)"', described)[1]
    page = f'.TH TOILE 1 "{date}" "Toile {version}" "User Commands"\n'
    page += ".SH NAME\ntoile \\- sewing patterns from 3D garments\n.SH SYNOPSIS\n"
    page += ".B toile\n[\\fIOPTIONS\\fR] [\\fIFILE\\fR...]\n.br\n"
    page += ".B toile\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] \\fIINPUT\\fR...\n"
    for command, _ in commands:  # those that take something else
        usage = usage_of(sections(said(program, command, "--help"))).split()
        if usage[2:] != ["[OPTIONS]", "INPUT..."]:
            page += f".br\n.B toile {command}\n" + plain(" ".join(usage[2:])) + "\n"
    page += f".SH DESCRIPTION\n{ABOUT}"
    page += f".SH COMMANDS\n{listed(commands)}"
    page += ".SH OPTIONS\nOf the window; most of them the commands know too.\n" + listed(options)
    page += ".SH OPTIONS OF COMMANDS\n"
    shared = dict(options)
    for command, _ in commands:
        page += command_page(program, command, shared)
    page += ".SH EXIT STATUS\n"
    for status, meaning in entries(parts["Exit status"]):
        page += f".TP\n.B {status}\n{wrapped(meaning)}\n"
    page += ".SH EXAMPLES\n"
    for what, line in EXAMPLES.items():
        page += f".TP\n{what}:\n.B {plain(line)}\n"
    page += ".SH FILES\n.TP\n.I ~/.config/Toile\nwhat was chosen in the window\n"
    page += ".TP\n.I ~/.local/share/Toile\nrecovery files of projects that were not saved\n"
    page += f".SH SEE ALSO\nThe documentation in {documentation}, beginning with\nfirst\\-steps.md.\n"
    return page


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    documentation = sys.argv[3]
    Path(sys.argv[2]).write_text(manual_page(sys.argv[1]), encoding="utf-8")
