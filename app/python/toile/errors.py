# SPDX-License-Identifier: GPL-3.0-or-later
"""What toile raises. Ctrl-C raises KeyboardInterrupt, as everywhere."""


class Error(Exception):
    """Something that cannot be done. str() is a sentence that says what may help.

    code: the name that reports have, "no-geometry"; "wrong-usage" or
        "not-proved" of a UsageError.
    subject: the name of the file, piece, seam or cut that it is about; empty: everything.
    """

    code: str
    subject: str

    def __init__(self, text: str, code: str = "", subject: str = "") -> None:
        super().__init__(text, code, subject)
        self.code = code
        self.subject = subject

    def __str__(self) -> str:
        return str(self.args[0])


class FileError(Error):
    """A file that cannot be read, understood or written."""


class UsageError(Error, ValueError):
    """A call that nobody can make sense of: an unknown option, a value out of range."""
