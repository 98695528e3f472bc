#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Snakefile beside it does with the shards of a list (docs/batch.md).

shards.py divide LIST FOLDER RECORDS COUNT  deals the garments out to FOLDER/shard00000.txt...
shards.py renew FOLDER RECORDS              changes the shards of which a garment failed, by
                        RECORDS/shard00000.jsonl, that the machine may be to blame for

Like cards, so that neighbours of a size do not all come to one shard. What has changed the next run
of the workflow does again.
"""
import json
import sys
from pathlib import Path

AGAIN = "# again, as the machine may be to blame\n"


def garments(path: Path) -> list[str]:
    with open(path, encoding="utf-8-sig", errors="surrogateescape", newline="\n") as lines:
        return [line for line in lines if line.strip() and not line.lstrip().startswith("#")]


def shard_names(count: int) -> list[str]:
    return [f"shard{number:05d}" for number in range(count)]


def divide(path: Path, folder: Path, records: Path, count: int) -> None:
    lines = garments(path)
    names = shard_names(count)
    for left in sorted(folder.glob("shard*.txt")):  # of a run with more shards
        if left.stem not in names:
            for ending in (".jsonl", ".jsonl.of"):
                (records / f"{left.stem}{ending}").unlink(missing_ok=True)
            left.unlink()
    for number, name in enumerate(names):
        shard = folder / f"{name}.txt"
        with open(shard, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as out:
            out.writelines(line.rstrip("\n") + "\n" for line in lines[number::count])


def is_worth_another_try(records: Path) -> bool:
    with open(records, encoding="utf-8") as lines:
        return any((json.loads(line)["error"] or {}).get("again") for line in lines)


def renew(folder: Path, records: Path) -> None:
    for shard in sorted(folder.glob("shard*.txt")):
        path = records / f"{shard.stem}.jsonl"
        if path.is_file() and is_worth_another_try(path):
            with open(shard, "a", encoding="utf-8") as lines:
                lines.write(AGAIN)  # a time alone is no change for Snakemake


def main() -> None:
    match sys.argv[1:]:
        case ["divide", path, folder, records, count]:
            divide(Path(path), Path(folder), Path(records), int(count))
        case ["renew", folder, records]:
            renew(Path(folder), Path(records))
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
