#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds what is installed beside the program to the standards of desktops.

files_test.py MADE PROGRAM: the folder of files that the build has made, and the program. What lacks
the tool that judges it is skipped by name; ends with 1 where a test failed.
"""

from __future__ import annotations

import configparser
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "resources/package"
made = Path()
program = ""


def needs(*tools: str) -> object:
    lacking = [tool for tool in tools if not shutil.which(tool)]
    return unittest.skipIf(lacking, f"not installed: {' '.join(lacking)}")


def run(*command: object, **options: object) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False, **options
    )
    if done.returncode != 0:
        raise AssertionError(f"{command[0]} says: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def mime_types(file: str, group: str) -> list[str]:
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    parser.optionxform = str
    parser.read(made / file, encoding="utf-8")
    return [name for name in parser[group]["MimeType"].split(";") if name]


class DesktopFiles(unittest.TestCase):
    @needs("desktop-file-validate")
    def test_the_desktop_file_is_valid(self) -> None:
        self.assertEqual(run("desktop-file-validate", made / "toile.desktop"), "")

    @needs("appstreamcli")
    def test_the_metainfo_is_valid(self) -> None:
        run("appstreamcli", "validate", "--no-net", made / "toile.metainfo.xml")

    def test_what_has_a_thumbnail_opens(self) -> None:
        self.assertEqual(
            mime_types("toile.thumbnailer", "Thumbnailer Entry"),
            mime_types("toile.desktop", "Desktop Entry"),
        )

    def test_the_thumbnailer_calls_what_the_program_knows(self) -> None:
        line = next(
            line
            for line in (made / "toile.thumbnailer").read_text().splitlines()
            if line.startswith("Exec=")
        )
        helped = run(program, "render", "--help")
        for option in re.findall(r" (-[-\w]+)", line):
            self.assertIn(option, helped)


class MimeTypes(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.work = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        # The system's and ours, and nothing of the person whose home this is.
        packages = cls.work / "data/mime/packages"
        packages.mkdir(parents=True)
        shutil.copy(PACKAGE / "toile.mime.xml", packages / "toile.xml")
        if shutil.which("update-mime-database"):
            run("update-mime-database", cls.work / "data/mime")
        cls.environment = {
            **os.environ,
            "HOME": str(cls.work),
            "XDG_DATA_HOME": str(cls.work / "data"),
            "GIO_USE_VFS": "local",
        }

    def types_of(self, paths: list[Path], by: str = "content-type") -> list[str]:
        """In the order of the paths, of what they hold, or by their names ("fast-content-type")."""
        said = run("gio", "info", "-a", f"standard::{by}", *paths, env=self.environment)
        return re.findall(rf"standard::{by}: (\S+)", said)

    @needs("gio", "update-mime-database")
    def test_a_project_is_known_by_its_first_bytes(self) -> None:
        projects = sorted((ROOT / "tests/data").glob("*.toile"))
        self.assertTrue(projects)
        bare = [self.work / project.stem for project in projects]
        for project, path in zip(projects, bare):
            shutil.copy(project, path)
        other = self.work / "other"
        other.write_text('{"format": "something-else", "title": "no toile-project"}')
        *known, of_other = self.types_of([*bare, other])
        self.assertEqual(known, ["application/vnd.toile+json"] * len(projects))
        self.assertNotEqual(of_other, "application/vnd.toile+json")

    @needs("gio", "update-mime-database")
    def test_every_file_that_the_program_reads_opens_with_it(self) -> None:
        opened = mime_types("toile.desktop", "Desktop Entry")
        said = " ".join(run(program, "info", "--help").split())
        inputs = re.search(r"Garment mesh: (.*?); a \.zip .*? project: (\.\w+)", said)
        endings = re.findall(r"\.\w+", inputs[1] + inputs[2])
        self.assertGreater(len(endings), 9)
        files = [self.work / f"a{ending}" for ending in endings]
        for file in files:
            file.write_bytes(b"x\n")
        for ending, kind in zip(endings, self.types_of(files, "fast-content-type"), strict=True):
            self.assertIn(kind, opened, ending)

    def test_the_project_has_an_icon_of_its_own(self) -> None:
        names = [
            node.get("type", "")
            for node in xml.parse(PACKAGE / "toile.mime.xml").getroot()
            if node.get("type", "").startswith("application/")
        ]
        for name in names:
            self.assertTrue((PACKAGE / f"{name.replace('/', '-')}.svg").exists(), name)


class ManualPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.page = Path(cls.enterClassContext(tempfile.TemporaryDirectory())) / "toile.1"
        run(sys.executable, PACKAGE / "manual_page.py", program, cls.page, "/opt/doc/toile")

    def test_it_names_every_option_of_every_command(self) -> None:
        shown = self.page.read_text(encoding="utf-8").replace("\\-", "-")
        helped = run(program, "--help")
        listed = helped.partition("Subcommands:")[2].partition("Exit status:")[0]
        commands = re.findall(r"^  (\w+) ", listed, re.MULTILINE)
        self.assertGreater(len(commands), 6)
        for command in commands:
            self.assertIn(f"toile {command}\n", shown)
            part = shown.partition(f".SS toile {command}\n")[2].partition("\n.S")[0]
            helped = run(program, command, "--help")
            for option in re.findall(r"^  \S*?(--[a-z][\w-]*)", helped, re.MULTILINE):
                if option != "--help":
                    self.assertIn(option, part, command)

    def test_it_tells_the_exit_statuses_of_the_help(self) -> None:
        shown = self.page.read_text(encoding="utf-8").replace("\\-", "-")
        told = shown.partition(".SH EXIT STATUS\n")[2].partition("\n.SH")[0]
        told = [
            [part.replace("\n", " ").strip() for part in entry.split("\n", 1)]
            for entry in told.split(".TP\n.B ")[1:]
        ]
        rows = run(program, "--help").partition("Exit status:\n")[2].splitlines()
        self.assertEqual(told, [[row[:30].strip(), row[30:]] for row in rows if row])
        self.assertEqual([status for status, _ in told], ["0", "1", "2", "3", "128 + N"])

    def test_it_says_what_commands_take_and_names_documents_where_they_lie(self) -> None:
        shown = self.page.read_text(encoding="utf-8").replace("\\-", "-")
        synopsis = shown.partition(".SH SYNOPSIS\n")[2].partition("\n.SH")[0]
        self.assertIn(".B toile batch\n[OPTIONS] LIST", synopsis)
        self.assertIn(".B toile serve\n[OPTIONS]", synopsis)
        self.assertIn("\\fBLIST\\fR", shown.partition(".SS toile batch\n")[2])
        documents = re.findall(r"(\S*/)([-\w]+\.md)", shown)
        self.assertTrue(documents)
        for folder, name in documents:
            self.assertEqual(folder.lstrip("("), "/opt/doc/toile/")
            self.assertTrue((ROOT / "docs" / name).is_file(), name)

    @needs("groff")
    def test_groff_has_nothing_to_say(self) -> None:
        self.assertEqual(
            subprocess.run(
                ["groff", "-man", "-ww", "-Tutf8", self.page],
                capture_output=True,
                text=True,
                check=True,
            ).stderr,
            "",
        )

    @needs("mandoc")
    def test_mandoc_has_nothing_to_say(self) -> None:
        self.assertEqual(run("mandoc", "-T", "lint", self.page), "")


if __name__ == "__main__":
    made, program = Path(sys.argv[1]), sys.argv[2]
    unittest.main(argv=sys.argv[:1], verbosity=1)
