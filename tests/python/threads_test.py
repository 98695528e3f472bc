# SPDX-License-Identifier: GPL-3.0-or-later
"""Hundreds of calls on several threads: the same results, and no memory kept.

TOILE_CALLS: how many, as by night; only then memory is looked at, which is the machine's, too.
TOILE_MEMORY=0: not even then.
"""

import ctypes
import gc
import os
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import toile
from support import grid

CALLS = int(os.environ.get("TOILE_CALLS", "300"))
THREADS = 4
DAEMON = """
import threading
import toile
from support import grid
made = toile.garment(*grid(150, bump=400), unit="mm")
runs = threading.Event()
def work():
    while True:
        made.flatten(pattern=True, progress=lambda fraction: runs.set())
for _ in range(3):
    threading.Thread(target=work, daemon=True).start()
runs.wait()
print("ends")
"""
AT_THE_END = """
import atexit
import threading
def load():
    try:
        toile.garment(*grid(), unit="mm")
    except toile.Error as error:
        print(error.code)
def late():
    thread = threading.Thread(target=load)
    thread.start()
    thread.join()
atexit.register(late)
import toile
from support import grid
print("ends")
"""
ALLOWED = 8 << 20  # bytes: what the allocator keeps for its threads


def resident() -> int:
    """Of this process, bytes."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Threads(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.sheets = [grid(5, bump=bump) for bump in (0, 3, 6, 9)]
        self.shared = toile.garment(*self.sheets[3], unit="mm")
        self.expected = [self.call(k) for k in range(len(self.sheets))]

    def call(self, number: int) -> tuple[bytes, bytes]:
        """One garment of its own, one that is shared; and everything that can be asked of it."""
        sheet = self.sheets[number % len(self.sheets)]
        flat = toile.garment(*sheet, unit="mm").flatten(threads=1, pattern=True)
        shared = self.shared.flatten(threads=1, method="lscm")
        with self.assertRaises(toile.UsageError):
            flat.write("pattern.xyz")
        outline = flat.pattern.pieces[0].cutting_line
        if number % 50 == 0:
            flat.write(self.folder / f"{number}.svg", self.folder / f"{number}.dxf")
        return outline.tobytes() + flat[0].strain.tobytes(), shared[0].positions.tobytes()

    def run_calls(self, count: int) -> None:
        with ThreadPoolExecutor(THREADS) as pool:
            for number, result in enumerate(pool.map(self.call, range(count))):
                self.assertEqual(result, self.expected[number % len(self.sheets)])
        gc.collect()

    def check_end(self, program: str, said: str) -> None:
        done = subprocess.run(
            [sys.executable, "-c", program],
            cwd=Path(__file__).parent,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )
        self.assertEqual((done.returncode, done.stdout), (0, said), done.stderr)

    def test_the_end_ends_calls_of_daemons(self) -> None:
        self.check_end(DAEMON, "ends\n")

    @unittest.skipIf(sys.version_info >= (3, 12), "which starts no thread at its end")
    def test_a_thread_started_at_the_end_comes_back(self) -> None:
        self.check_end(AT_THE_END, "ends\ncancelled\n")

    def test_numpy_keeps_its_threads(self) -> None:
        libraries = {
            line.split()[-1]
            for line in Path("/proc/self/maps").read_text().splitlines()
            if "openblas" in line
        }
        if not libraries:
            self.skipTest("needs OpenBLAS")
        blas = ctypes.CDLL(libraries.pop())
        for threads in (2, 1):
            blas.openblas_set_num_threads(threads)
            self.run_calls(20)
            self.assertEqual(blas.openblas_get_num_threads(), threads)
        blas.openblas_set_num_threads(os.cpu_count() or 1)

    def test_memory_is_level(self) -> None:
        # So many at a time: what waits for its turn is memory of the test's own.
        self.run_calls(CALLS // 10)
        before = resident()
        for _ in range(9):
            self.run_calls(CALLS // 10)
        grown = resident() - before
        # A sanitizer keeps what is freed.
        if "TOILE_CALLS" not in os.environ or os.environ.get("TOILE_MEMORY") == "0":
            return
        self.assertLess(grown, ALLOWED, f"{grown >> 10} KiB more after {CALLS} calls")


if __name__ == "__main__":
    unittest.main()
