# SPDX-License-Identifier: GPL-3.0-or-later
"""The program at work: `toile serve`, driven from any Python. Knows no Blender."""

from __future__ import annotations

import json
import os
import queue
import shutil
import subprocess
import threading
from operator import itemgetter
from typing import Any, Callable, Iterator


class ToileError(Exception):
    """What the program says: a sentence, with the code and the subject of its errors."""

    def __init__(self, message: str, code: str = "", subject: str | None = None):
        super().__init__(message)
        self.code = code
        self.subject = subject


def program_path(preferred: str) -> str:
    """The program that a person has named, else the one in PATH."""
    preferred = os.path.expanduser(preferred.strip())
    found = shutil.which(preferred or "toile")
    if not found:
        raise ToileError(
            f"There is no program {preferred}; correct its path in the add-on's preferences."
            if preferred
            else "Toile is not in PATH; install it, or name it in the add-on's preferences.",
            "no-program",
        )
    return found


class Requests:
    """Some requests, answered one after the other by a process of its own. Ask `poll` from time to
    time until `is_done`; nothing here waits but `wait`.
    @param reworded  what an error of the program's says to who has asked"""

    def __init__(
        self,
        program: str,
        requests: list[dict[str, Any]],
        reworded: Callable[[dict[str, Any]], str] = itemgetter("message"),
    ):
        try:
            self._process = subprocess.Popen(
                [program, "serve"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                encoding="utf-8",
            )
        except OSError as error:
            raise ToileError(f"{program} cannot be started: {error}.", "no-program") from error
        self._reworded = reworded
        self.results: list[dict[str, Any]] = []
        self.error: ToileError | None = None
        self.is_done = False
        self.progress = 0.0
        self._count = len(requests)
        self._is_cancelled = False
        self._lines: queue.SimpleQueue[str | None] = queue.SimpleQueue()
        threading.Thread(target=self._read, daemon=True).start()
        lines = [json.dumps({"id": i, **asked}) for i, asked in enumerate(requests)]
        # The program reads on while it answers, so that it takes all of them without waiting.
        self._say(*lines)

    def _read(self) -> None:
        with self._process.stdout as lines:
            for line in lines:
                self._lines.put(line)
        self._lines.put(None)

    def _say(self, *lines: str) -> None:
        try:
            self._process.stdin.write("".join(line + "\n" for line in lines))
            self._process.stdin.flush()
        except OSError:  # it has ended: what it said last tells why
            pass

    def cancel(self) -> None:
        """What is not answered yet is given up; the end comes with `poll`."""
        if self._is_cancelled:
            return
        self._is_cancelled = True
        pending = range(len(self.results), self._count)
        self._say(*(json.dumps({"id": f"stop {i}", "do": "cancel", "of": i}) for i in pending))

    def close(self) -> None:
        """Whatever is not answered yet never will be."""
        if not self.is_done:
            self._end(ToileError("Cancelled.", "cancelled"))

    def _messages(self, seconds: float) -> Iterator[dict[str, Any] | None]:
        try:
            line = self._lines.get(timeout=seconds) if seconds else self._lines.get_nowait()
            while True:
                yield json.loads(line) if line is not None else None
                line = self._lines.get_nowait()
        except queue.Empty:
            return

    def poll(self, seconds: float = 0.0) -> bool:
        """Takes in what has been said; waits so long for it. Returns whether all is done, or
        one request has failed, which ends it."""
        for message in self._messages(seconds):
            if self.is_done:
                break
            if message is None:
                self._end(ToileError("Toile has ended before it was done.", "ended"))
            elif "error" in message:
                said = message["error"]
                sentence = self._reworded(said)
                self._end(ToileError(sentence, said["code"], said["subject"]))
            elif "progress" in message:
                self.progress = (message["id"] + message["progress"]) / self._count
            elif isinstance(message["id"], int):
                self.results.append(message["result"])
                self.progress = len(self.results) / self._count
                if len(self.results) == self._count:
                    self._end(None)
        return self.is_done

    def wait(self) -> list[dict[str, Any]]:
        while not self.poll(0.1):
            pass
        if self.error:
            raise self.error
        return self.results

    def _end(self, error: ToileError | None) -> None:
        self.error = ToileError("Cancelled.", "cancelled") if self._is_cancelled else error
        self.is_done = True
        # What was asked for after a failure is of no use.
        self._process.kill()
        self._process.wait()
        try:
            self._process.stdin.close()
        except OSError:  # there is something left that nobody takes
            pass
