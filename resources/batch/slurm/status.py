#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells Snakemake how a job of Slurm stands: "running", "success" or "failed".

The controller knows what runs and what has just ended, the accounting, where there is one, what ended
long ago. Where neither answers, a job counts as running: a second one beside it would be worse.
"""
import subprocess
import sys
import time

DONE = {"COMPLETED"}
UNDER_WAY = {
    "PENDING",
    "RUNNING",
    "CONFIGURING",
    "COMPLETING",
    "SUSPENDED",
    "REQUEUED",
    "REQUEUE_HOLD",
    "RESIZING",
    "SIGNALING",
    "STAGE_OUT",
    "STOPPED",
}
LOST = "LOST"
LOOKS = 5


def said(command: list[str]) -> tuple[str, str]:
    """What it writes, and the error that it says."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return "", ""
    return done.stdout, done.stderr


def state(job: str) -> str:
    """The state's first word, without what is added to it ("CANCELLED by 0", "COMPLETED+"); LOST where
    the controller has no such job and no accounting knows it; empty where nobody answers."""
    shown, error = said(["scontrol", "-o", "show", "job", job])
    for field in shown.split():
        if field.startswith("JobState="):
            return field.removeprefix("JobState=")
    words = said(["sacct", "-X", "-n", "-P", "-o", "State", "-j", job])[0].split()
    if words:
        return words[0].rstrip("+")
    return LOST if "Invalid job id" in error else ""


def main() -> None:
    job = sys.argv[1].split(";")[0]  # "ID;cluster"
    for look in range(LOOKS):
        found = state(job)
        if found:
            break
        if look + 1 < LOOKS:
            time.sleep(look + 1)  # the controller is busy
    is_running = not found or found in UNDER_WAY
    print("success" if found in DONE else "running" if is_running else "failed")


if __name__ == "__main__":
    main()
