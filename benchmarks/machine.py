"""What a measurement was made on: date, processor, cores used, versions, commit."""

from __future__ import annotations

import datetime
import os
import platform
import subprocess
from pathlib import Path

import numpy as np

import swifttailor


def describe() -> str:
    """One line to print above every table of timings."""
    processor = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        names = [
            line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if "model name" in line
        ]
        processor = names[0] if names else processor
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    commit = subprocess.run(
        ["git", "describe", "--always", "--dirty"], capture_output=True, text=True, cwd=Path(__file__).parent
    ).stdout.strip()
    return (
        f"{datetime.date.today()}, {processor}, {cores} core(s) visible, Python {platform.python_version()}, "
        f"numpy {np.__version__}, swifttailor {swifttailor.__version__}, commit {commit or 'unknown'}"
    )
