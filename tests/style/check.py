#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The house style that a machine can see, over every source file: clang-format, a licence line, no file past 400 lines.

check.py SOURCE [--clang-format PROGRAM]
Prints one line per finding and ends with 1 if there is any.
"""
import argparse
import subprocess
import sys
from pathlib import Path

FOLDERS = ("bake", "runtime", "common", "shaders", "data", "tests", "scripts", "cmake", ".ci")
CPP = {".cpp", ".h", ".hpp"}
SHADERS = {".comp", ".vert", ".frag", ".glsl"}
OTHER = {".py", ".sh", ".cmake"}
SPDX = "SPDX-License-Identifier: Apache-2.0"
MOST_LINES = 400
FILES_PER_RUN = 50


def is_source(path):
    if not path.is_file() or "__pycache__" in path.parts:
        return False
    if path.suffix in CPP | SHADERS | OTHER or path.name == "CMakeLists.txt":
        return True
    return not path.suffix and path.read_bytes()[:2] == b"#!"


def source_files(root):
    files = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*")) if is_source(path)]
    return files + [path for path in [root / "CMakeLists.txt"] if path.exists()]


def text_findings(path, name):
    lines = path.read_text().splitlines()
    # A script's first line names its interpreter.
    first = 1 if lines and lines[0].startswith("#!") else 0
    if len(lines) <= first or SPDX not in lines[first]:
        yield f"{name}: line {first + 1} is not the licence line ({SPDX})"
    if len(lines) > MOST_LINES:
        yield f"{name}: {len(lines)} lines; past {MOST_LINES} it is more than one thing"


def format_findings(program, files):
    for start in range(0, len(files), FILES_PER_RUN):
        command = [program, "--dry-run", "--Werror", "--ferror-limit=1", *map(str, files[start : start + FILES_PER_RUN])]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        yield from (line for line in result.stderr.splitlines() if "error:" in line)
        if result.returncode and "error:" not in result.stderr:
            yield f"{program} failed: {result.stderr.strip()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("source", type=Path)
    parser.add_argument("--clang-format", default="clang-format")
    options = parser.parse_args()
    files = source_files(options.source)
    findings = [finding for path in files for finding in text_findings(path, path.relative_to(options.source))]
    findings += format_findings(options.clang_format, [path for path in files if path.suffix in CPP])
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
