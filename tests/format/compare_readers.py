#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does the reader written from the document (read_ptb.py) see what the C++ reader sees? Every number must be equal.

    compare_readers.py FORMAT_TOOL ASSET.ptb [--every N]     of texels, maps and pages, every Nth
"""
import argparse
import json
import subprocess
import sys

import read_ptb


def expected_tables(ptb, every):
    """What the document says the file holds, under the names that format_tool uses."""
    yield "PROV", ptb.provenance
    yield "header", [ptb.header]
    yield "chunks", ptb.chunk_rows
    for name in ("INFO", "VERT", "TRIS", "MATL", "MATX", "TXFM", "TEXI"):
        yield name, ptb.tables[name]
    yield "TEXD", [ptb.texels[i : i + 4] for i in range(0, len(ptb.texels), 4 * every)]
    for name in ("ATLS", "levl", "RECS", "TILE"):
        yield name, ptb.tables[name]
    yield "VISI", ptb.tables["VISI"][::every]
    for name in ("CELL", "VIEW"):
        yield name, ptb.tables[name]
    yield "MASK", ptb.tables["MASK"]
    spheres = [("view", ptb.frequency), *(("cell", row[0]) for row in ptb.tables["CELL"])]
    for name, frequency in spheres + [(f"{count} view", frequency) for frequency, count in ptb.tables["VIEW"]]:
        directions, triangles = read_ptb.view_sphere(frequency)
        yield f"{name}s", directions
        yield f"{name}Triangles", triangles
    for index, (stream, tile, _, _, entry) in enumerate(ptb.page_list()):
        if index % every == 0:
            yield f"page {stream} {tile}", ptb.page(stream, tile, entry)


def same(name, ours, theirs):
    if name == "PROV":
        return ours == theirs
    ours = [list(row) for row in ours]
    if not name.endswith(("views", "cells")):
        return ours == theirs
    # Directions are computed, not read: single precision there, double here.
    return len(ours) == len(theirs) and all(abs(a - b) < 1e-6 for p, q in zip(ours, theirs) for a, b in zip(p, q))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool")
    parser.add_argument("asset")
    parser.add_argument("--every", type=int, default=1)
    arguments = parser.parse_args()
    ptb = read_ptb.Ptb(arguments.asset)
    dump = subprocess.run([arguments.tool, "dump", arguments.asset, str(arguments.every)], check=True,
                          stdout=subprocess.PIPE, text=True)
    lines = dump.stdout.splitlines()
    tables = numbers = 0
    for name, rows in expected_tables(ptb, arguments.every):
        line = json.loads(lines[tables])
        if line["name"] != name or not same(name, rows, line["rows"]):
            print(f"{arguments.asset}: the readers disagree on {name} (C++: {line['name']})")
            return 1
        tables += 1
        numbers += 0 if name == "PROV" else sum(len(row) for row in rows)
    if tables != len(lines):
        print(f"{arguments.asset}: C++ prints {len(lines)} tables instead of {tables}")
        return 1
    print(f"{arguments.asset}: {tables} tables, {numbers} numbers, all equal")
    return 0


if __name__ == "__main__":
    sys.exit(main())
