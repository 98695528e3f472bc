# SPDX-License-Identifier: GPL-3.0-or-later
"""Slurm with one node, this machine, for as long as a test needs it.

Needs root and Debian's slurmctld, slurmd, slurm-client and munge; keeps to one folder and to free
ports, and touches neither the system's configuration nor its services.
"""
import contextlib
import os
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

NEEDED = ["slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "sinfo", "munged"]
LONGEST_START = 60  # s

CONFIGURATION = """\
ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=1
MinJobAge=600
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory} State=UNKNOWN
PartitionName=trial Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
"""


def lacking() -> list[str]:
    """What is to be installed, or root, before there can be one."""
    programs = [program for program in NEEDED if not shutil.which(program, path=search_path())]
    return programs + ([] if os.geteuid() == 0 else ["root"])


def search_path() -> str:
    return os.environ.get("PATH", "") + ":/usr/sbin:/sbin"


def free_ports(count: int) -> list[int]:
    sockets = [socket.socket() for _ in range(count)]
    for taken in sockets:
        taken.bind(("127.0.0.1", 0))
    ports = [taken.getsockname()[1] for taken in sockets]
    for taken in sockets:
        taken.close()
    return ports


@contextlib.contextmanager
def one_node_slurm(folder: Path, cpus: int = 2) -> Iterator[dict[str, str]]:
    """The environment in which sbatch finds it. All of it is stopped at the end."""
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    folder.chmod(0o755)  # munged wants nobody else to write above its socket
    key = folder / "munge.key"
    key.write_bytes(os.urandom(1024))
    key.chmod(0o600)
    controller, node = free_ports(2)
    pages = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") >> 20
    configuration = folder / "slurm.conf"
    configuration.write_text(
        CONFIGURATION.format(
            folder=folder,
            host=socket.gethostname().split(".")[0],
            controller=controller,
            node=node,
            cpus=cpus,
            memory=max(1000, pages * 3 // 4),
        )
    )
    environment = os.environ | {"SLURM_CONF": str(configuration), "PATH": search_path()}
    started: list[subprocess.Popen[bytes]] = []

    def start(*command: str) -> None:
        with open(folder / f"{command[0]}.out", "wb") as log:
            started.append(
                subprocess.Popen(
                    command, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log
                )
            )

    try:
        start(
            "munged", "--foreground", "--force", f"--key-file={key}",
            f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
            f"--seed-file={folder}/munge.seed", "--num-threads=2",
        )  # fmt: skip
        wait_until(lambda: (folder / "munge.socket").exists(), folder)
        start("slurmctld", "-D", "-c")
        start("slurmd", "-D", "-N", socket.gethostname().split(".")[0])
        wait_until(lambda: "idle" in said(["sinfo", "-h", "-o", "%T"], environment), folder)
        yield environment
    finally:
        said(["scancel", "--full", "--state=RUNNING,PENDING", "-u", "root"], environment)
        for process in reversed(started):
            process.terminate()
        for process in reversed(started):
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def said(command: list[str], environment: dict[str, str]) -> str:
    try:
        return subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=20
        ).stdout
    except subprocess.TimeoutExpired:
        return ""


def wait_until(is_there: Callable[[], bool], folder: Path) -> None:
    end = time.monotonic() + LONGEST_START
    while not is_there():
        if time.monotonic() > end:
            logs = "".join(path.read_text() for path in sorted(folder.glob("*.log")))
            outs = "".join(path.read_text() for path in sorted(folder.glob("*.out")))
            raise RuntimeError(f"Slurm does not start:\n{outs[-3000:]}{logs[-6000:]}")
        time.sleep(0.2)
