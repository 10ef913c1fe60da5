# SPDX-License-Identifier: Apache-2.0
"""exr.py reads what it writes, and reads what the programs write as they do themselves."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import exr

BIN = Path(sys.argv.pop(1)) / "bin"


class Exr(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_round_trip(self):
        rows = [[(x / 8, y / 4, x * y / 64, 1.0) for x in range(37)] for y in range(21)]
        exr.write_half(self.folder / "a.exr", rows)
        self.assertEqual(exr.read(self.folder / "a.exr"), rows)

    def test_axes_of_the_programs(self):
        path, copy = self.folder / "axes.exr", self.folder / "copy.exr"
        subprocess.run([BIN / "boxlight_data", "environment", "axes", path], check=True)
        rows = exr.read(path)
        self.assertEqual((len(rows[0]), len(rows)), (256, 128))
        self.assertEqual(rows[64][128], (1.0, 0.0, 0.0, 1.0))  # the centre is +X: red
        self.assertEqual(rows[64][192], (0.0, 0.0, 1.0, 1.0))  # three quarters are +Z: blue
        self.assertEqual(rows[0][0], (0.0, 1.0, 0.0, 1.0))  # the top is +Y: green
        exr.write_half(copy, rows)
        subprocess.run([BIN / "ptbake", "compare", copy, path, "--fail", "0"], check=True, capture_output=True)


if __name__ == "__main__":
    unittest.main()
