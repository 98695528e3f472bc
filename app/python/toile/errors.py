# SPDX-License-Identifier: GPL-3.0-or-later
"""What toile raises. Ctrl-C raises KeyboardInterrupt, as everywhere."""


class Error(Exception):
    """Something that cannot be done. str() is a sentence that says what may help.

    code: the name that reports have, "no-geometry"; "wrong-usage" or
        "not-proved" of a UsageError.
    subject: the name of the file, piece, seam or cut that it is about; empty: everything.
    again: whether the machine was the reason, so that another try may help: the file may be there
        by then, or the memory.
    """

    code: str
    subject: str
    again: bool

    def __init__(self, text: str, code: str = "", subject: str = "", again: bool = False) -> None:
        super().__init__(text, code, subject, again)
        self.code = code
        self.subject = subject
        self.again = again

    def __str__(self) -> str:
        return str(self.args[0])


class FileError(Error):
    """A file that cannot be read, understood or written."""


class UsageError(Error, ValueError):
    """A call that nobody can make sense of: an unknown option, a value out of range."""
