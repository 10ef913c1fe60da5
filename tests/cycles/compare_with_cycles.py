#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Renders cases with ptbake and with Cycles and measures one against the other (README.md).

    compare_with_cycles.py [CASE...] --programs build/bin --foreign FOLDER -o FOLDER [--size N] [--spp N] [--seeds N]

Both renderers make the picture `seeds` times with other random numbers; the spread gives the variance of either mean.
Pictures that are in the output folder already are kept. Prints one row of a table per case; CASE.png shows ours,
Cycles' and five times their difference in grey. Needs Blender 3.4, python3-numpy and python3-openimageio.
"""
import argparse
import subprocess
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

from cases import CASES, gltf_material
from meshes import write_scene

TRIMMED = .001  # the part of the worst pixels that is left out
BLOCK = 8       # pixels a side
ROUNDING = 1e-5  # of means in single precision, relative


def read(path):
    return oiio.ImageBuf(str(path)).get_pixels(oiio.FLOAT).astype(float)


def write(path, pixels):
    buffer = oiio.ImageBuf(oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], oiio.UINT8))
    buffer.set_pixels(oiio.ROI(), np.ascontiguousarray(pixels, np.float32))
    buffer.write(str(path))


def write_black(path):
    buffer = oiio.ImageBuf(oiio.ImageSpec(4, 2, 3, oiio.FLOAT))
    buffer.write(str(path))


def run(*command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    assert result.returncode == 0, f"{command}\n{result.stdout}\n{result.stderr}"


def pictures(options, name, program):
    return [options.output / f"{name}.{program}.{seed}.exr" for seed in range(options.seeds)]


def render_ours(options, name, program, scene, environment):
    case = CASES[name]
    command = [options.programs / "ptbake", "render"]
    if program != "ptbake":
        command = [options.programs / program, "--model", case.model]
    camera = [part for key, value in case.camera.items()
              for part in ("--" + key, ",".join(map(str, value)) if isinstance(value, tuple) else value)]
    for seed, picture in enumerate(pictures(options, name, program)):
        if not picture.exists():
            run(*command, scene, "--env", environment, "-o", picture, "--spp", options.spp, "--seed", seed, "--size",
                f"{options.size}x{options.size}", "--background", "off", "--env-rotation", case.rotation, *camera)


def render_cycles(options, name, scene, environment):
    if all(picture.exists() for picture in pictures(options, name, "cycles")):
        return
    script = Path(__file__).with_name("render_in_cycles.py")
    run("blender", "-b", "--factory-startup", "--python-exit-code", 1, "-P", script, "--", name, scene, environment,
        options.output / f"{name}.cycles.{{seed}}.exr", "--size", options.size, "--spp", options.spp, "--seeds",
        options.seeds)


def trimmed_rms(squares):
    ordered = np.sort(squares.mean(1))
    return np.sqrt(ordered[:len(ordered) - int(TRIMMED * len(ordered))].mean())


def block_means(seeds, mask):
    """Means over blocks of pixels that lie wholly inside the mask: seeds x blocks x channels."""
    count, height, width, _ = seeds.shape
    blocks = seeds.reshape(count, height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean((2, 4))
    inside = mask.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).all((1, 3))
    return blocks[:, inside]


def variance_of_mean(seeds):
    return seeds.var(0, ddof=1) / len(seeds)


def measure(ours, theirs):
    """Over object pixels: alpha above .5 in Cycles' picture. Arrays are seeds x height x width x RGBA."""
    mask = theirs[..., 3].mean(0) > .5
    alpha = np.abs(ours[..., 3].mean(0) - theirs[..., 3].mean(0)).mean()
    ours, theirs = ours[..., :3], theirs[..., :3]
    a, b = ours[:, mask], theirs[:, mask]
    means = a.mean((1, 2)), b.mean((1, 2))
    error = np.hypot(*(np.sqrt(variance_of_mean(m)) for m in means)) / means[1].mean()
    rms, noise = trimmed_rms((a.mean(0) - b.mean(0)) ** 2), trimmed_rms(variance_of_mean(a) + variance_of_mean(b))
    x, y = block_means(ours, mask), block_means(theirs, mask)
    rounding = (ROUNDING * y.mean(0)) ** 2
    z = (x.mean(0) - y.mean(0)) / np.sqrt(variance_of_mean(x) + variance_of_mean(y) + rounding + 1e-30)
    return {"pixels": int(mask.sum()), "mean": means[1].mean(), "bias": means[0].mean() / means[1].mean() - 1,
            "error": error, "rms": rms, "noise": noise, "z": np.sqrt((z ** 2).mean()), "alpha": alpha,
            "channels": a.mean((0, 1)) / b.mean((0, 1)) - 1}


def show(path, ours, theirs):
    a, b = (seeds.mean(0)[..., :3] for seeds in (ours, theirs))
    scale = .5 / max(b[b > 0].mean(), 1e-6)
    both = np.concatenate([a, b, np.full_like(a, .2 / scale) + 5 * (a - b)], 1)
    write(path, np.clip(both * scale, 0, 1) ** (1 / 2.2))


def compare(options, name, program):
    scene, case = options.output / f"{name}.glb", CASES[name]
    write_scene(scene, [(make(options.foreign), gltf_material(material)) for make, material in case.parts])
    environment = options.foreign / case.environment
    if case.environment == "black":
        environment = options.output / "black.exr"
        write_black(environment)
    render_ours(options, name, program, scene, environment)
    render_cycles(options, name, scene, environment)
    ours, theirs = (np.stack([read(p) for p in pictures(options, name, who)]) for who in (program, "cycles"))
    m = measure(ours, theirs)
    show(options.output / f"{name}.{program}.png", ours, theirs)
    print(f"| {name} | {program} | {m['pixels']} | {m['mean']:.4g} | {100 * m['bias']:+.2f} +-{100 * m['error']:.2f} % | "
          f"{m['rms']:.3g} | {m['noise']:.3g} | {m['rms'] / m['noise']:.2f} | {m['z']:.2f} |", flush=True)
    if options.verbose:
        print("   channels", 100 * m["channels"], "alpha", m["alpha"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--foreign", type=Path, required=True)
    parser.add_argument("-o", "--output", type=Path, required=True)
    for name, default in (("size", 256), ("spp", 64), ("seeds", 8)):
        parser.add_argument("--" + name, type=int, default=default)
    parser.add_argument("-v", "--verbose", action="store_true")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    for name in options.cases or CASES:
        for program in ["ptbake"] + ["render_as_cycles"] * bool(CASES[name].model):
            compare(options, name, program)


main()
