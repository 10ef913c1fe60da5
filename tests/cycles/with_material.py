#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a copy of a .glb with one material for everything, moved and scaled: p' = scale (p - centre).

    with_material.py IN.glb OUT.glb --lambert R,G,B                 pure Lambert (KHR_materials_specular, factor 0)
    with_material.py IN.glb OUT.glb --metal R,G,B --roughness .2    metallic-roughness, metallic 1
"""
import argparse

from glb import read_glb, write_glb


def numbers(text):
    return [float(x) for x in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("--lambert", type=numbers)
    parser.add_argument("--metal", type=numbers)
    parser.add_argument("--roughness", type=float, default=0.2)
    parser.add_argument("--centre", type=numbers, default=[0, 0, 0])
    parser.add_argument("--scale", type=float, default=1)
    options = parser.parse_args()

    document, rest = read_glb(options.source)
    colour = (options.lambert or options.metal) + [1]
    material = {"pbrMetallicRoughness": {"baseColorFactor": colour, "metallicFactor": 0 if options.lambert else 1,
                                         "roughnessFactor": options.roughness}}
    if options.lambert:
        material["extensions"] = {"KHR_materials_specular": {"specularFactor": 0}}
        document.setdefault("extensionsUsed", []).append("KHR_materials_specular")
    document["materials"] = [material]
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            primitive["material"] = 0
    scene = document["scenes"][document.get("scene", 0)]
    document["nodes"].append({"children": scene["nodes"], "scale": [options.scale] * 3,
                              "translation": [-options.scale * c for c in options.centre]})
    scene["nodes"] = [len(document["nodes"]) - 1]
    write_glb(options.target, document, rest)


main()
