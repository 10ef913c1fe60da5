#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Known answers of motion.py."""
import math
import random
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import motion  # noqa: E402

WIDTH, HEIGHT, FRAMES = 48, 32, 4


def frames(value):
    """Grey pictures: value(x, y, frame)."""
    return [[[(*[value(x, y, f)] * 3, 1.0) for x in range(WIDTH)] for y in range(HEIGHT)] for f in range(FRAMES)]


def wave(x, y, frame):
    return 0.5 + 0.3 * math.sin(0.4 * (x - frame) + 0.1 * y)


class Motion(unittest.TestCase):
    def setUp(self):
        self.truth = frames(wave)

    def find(self, seen, truths=None, others=None):
        return motion.summary(motion.steps(frames(seen), truths or self.truth, others or self.truth))

    def test_what_moves_as_the_truth_has_no_error(self):
        found = self.find(wave)
        self.assertAlmostEqual(found["error"], 0, places=6)
        self.assertAlmostEqual(found["change"], 1, places=6)

    def test_what_stands_still_has_all_of_it(self):
        found = self.find(lambda x, y, f: wave(x, y, 0))
        self.assertAlmostEqual(found["error"], 1, places=6)
        self.assertAlmostEqual(found["change"], 0, places=6)

    def test_what_flickers_has_more(self):
        found = self.find(lambda x, y, f: wave(x, y, f) + (0.2 if f % 2 else 0.0))
        self.assertGreater(found["error"], 1)

    def test_a_pop_is_the_largest_step(self):
        found = self.find(lambda x, y, f: wave(x, y, f) + (0.15 if f >= 2 else 0.0))
        self.assertGreater(found["largest"], 1.5)
        self.assertAlmostEqual(found["least"], 1, places=6)

    def test_noise_of_the_truths_cancels(self):
        draw = random.Random(3)
        noisy = [frames(lambda x, y, f: wave(x, y, f) + draw.uniform(-0.15, 0.15)) for _ in range(2)]
        self.assertAlmostEqual(self.find(wave, *noisy)["change"], 1, delta=0.05)
        self.assertLess(self.find(wave, *noisy)["error"], 0.15)
        self.assertGreater(self.find(wave, noisy[0], noisy[0])["error"], 0.3)

    def test_what_a_screen_clamps_does_not_count(self):
        self.assertEqual(motion.display((2.0, -1.0, 0.5, 1.0)), [1.0, 0.0, 0.5])


if __name__ == "__main__":
    unittest.main()
