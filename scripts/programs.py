# SPDX-License-Identifier: Apache-2.0
"""The built programs, for scripts that measure them."""
import resource
import subprocess
from pathlib import Path

BIN = Path(__file__).resolve().parent.parent / "build/bin"


def run(program, *arguments):
    """Returns what it printed and the CPU seconds it took."""

    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = used()
    command = [str(BIN / program), *map(str, arguments)]
    printed = subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout
    return printed, used() - before
