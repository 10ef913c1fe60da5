# SPDX-License-Identifier: Apache-2.0
"""How pictures of a moving camera change from frame to frame, beside how the truth does. A frame is rows of linear (R, G, B, A).

Path-traced frames are noisy, and so are their differences. With two independent renderings t and t' of every frame, means of
products of one of each are free of that noise: mean d(t) d(t') is the power of the truth's changes, mean (d(v) - d(t)) (d(v) - d(t'))
that of the error in those of v. Edges alias pixel by pixel, and differently for other samples: means of BLOCK x BLOCK pixels are compared."""
import math

BLOCK = 4  # pixels; a rest at the right and at the bottom is left out


def flat(frame):
    """Means of blocks, as numbers one after the other."""
    shown = [[display(pixel) for pixel in row] for row in frame]
    return [
        sum(pixel[c] for row in shown[y : y + BLOCK] for pixel in row[x : x + BLOCK]) / BLOCK**2
        for y in range(0, len(shown) - BLOCK + 1, BLOCK)
        for x in range(0, len(shown[0]) - BLOCK + 1, BLOCK)
        for c in range(3)
    ]


def display(pixel):
    """What a screen shows of a pixel, without the curve: clamped at white, over black."""
    return [min(max(c, 0.0), 1.0) for c in pixel[:3]]


def change(before, after):
    return [b - a for a, b in zip(before, after)]


def mean_product(a, b):
    return math.fsum(x * y for x, y in zip(a, b)) / len(a)


def steps(frames, truths, others):
    """Of each step from one frame to the next: (RMS change of the frames, of the truth, of the error between the two changes)."""
    found = []
    for i in range(len(frames) - 1):
        v, t, u = (change(flat(f[i]), flat(f[i + 1])) for f in (frames, truths, others))
        powers = mean_product(v, v), mean_product(t, u), mean_product(change(t, v), change(u, v))
        found.append(tuple(math.sqrt(max(power, 0.0)) for power in powers))
    return found


def summary(found):
    """What the steps say of all frames."""

    def rms(k):
        return math.sqrt(math.fsum(step[k] ** 2 for step in found) / len(found))

    if min(step[1] for step in found) <= 0:
        raise ValueError("the truth does not change, or its noise hides that it does: give it more paths")
    ratios = sorted(step[0] / step[1] for step in found)
    return {"change": rms(0) / rms(1), "error": rms(2) / rms(1), "largest": ratios[-1], "least": ratios[0]}
