# SPDX-License-Identifier: Apache-2.0
"""What is compared: scenes of materials that glTF and Cycles can both express. A material is a dictionary of physical
numbers; gltf_material() and blender_material.py say it in either language."""
import math
from dataclasses import dataclass, field

from meshes import ground, read_meshes, sphere

GREY = {"diffuse": (.5, .5, .5)}
# Reduced scattering 4 to 8 per radius: light gets through, and most of it scatters many times.
MARBLE = {"diffuse": (1, 1, 1), "transmitted": (.95, .95, .95), "transmission": 1, "scattering": (4, 6, 8),
          "absorption": (.3, .1, .02), "closed": True}
GLASS = {"ior": 1.5, "roughness": .01, "absorption": (.1, .5, 1.2), "closed": True}
BRUSHED = {"metal": (.9, .6, .3), "roughness": .2, "anisotropy": .5, "rotation": .7}
LEAF = {"diffuse": (.6, .5, .2), "transmitted": (.3, .7, .1), "transmission": .4}


@dataclass
class Case:
    """`parts`: pairs of a function that makes the mesh, given the folder of foreign models, and its material.
    `model`: of render_as_cycles, where Cycles' closures are not glTF's."""
    parts: list
    environment: str  # in that folder, or "black"
    rotation: float = 0
    camera: dict = field(default_factory=lambda: CAMERA)
    model: str = ""


def head(folder):
    return read_meshes(folder / "models/suzi.glb")[0].fitted(1)


def on_ground(mesh, material, height):
    return [(mesh, material), (lambda _: ground(6, height), GREY)]


def in_glass(**changes):
    """A red ball inside a ball of glass."""
    return [(lambda _: sphere(1).flat(), {**GLASS, **changes}),
            (lambda _: sphere(.4, (.15, -.2, .1)).flat(), {"diffuse": (.8, .3, .2)})]


def marble(**changes):
    return [(lambda _: sphere(1).flat(), {**MARBLE, **changes})]


CAMERA = {"eye": (0, .7, 3.6), "target": (0, 0, 0), "fov": 35}
CLOSE = {"eye": (0, .7, 3.6), "target": (0, 0, 0), "fov": 24}
ABOVE = {"eye": (0, 2.4, 3), "target": (0, -.2, 0), "fov": 30}
OUTDOOR, INDOOR, STUDIO = "hdri/kloppenheim_05_1k.hdr", "hdri/vestibule_1k.hdr", "hdri/studio_small_03_1k.hdr"

CASES = {
    "leaf": Case([(head, LEAF)], OUTDOOR, 40, CLOSE),
    "marble": Case(marble(), INDOOR),
    "marble_forward": Case(marble(g=.5), INDOOR),
    "blend": Case(on_ground(head, {"diffuse": (.8, .4, .1), "alpha": .4}, -.53), OUTDOOR, camera=ABOVE),
    "lamp": Case(on_ground(head, {"diffuse": (.3, .3, .3), "emission": (3, 1.6, .5)}, -.53), "black", camera=ABOVE),
    "glass": Case(in_glass(), INDOOR, model="glass"),
    "rough_glass": Case(in_glass(roughness=.4), INDOOR, model="glass"),
    "brushed": Case(on_ground(lambda _: sphere(.7, columns=384, rows=192), BRUSHED, -.72), STUDIO, camera=ABOVE,
                    model="metal"),
}


def brushed_alpha(material):
    """KHR_materials_anisotropy: GGX alpha along the tangent and across it."""
    alpha = material["roughness"] ** 2
    return alpha + (1 - alpha) * material.get("anisotropy", 0) ** 2, alpha


def medium_extensions(material):
    """Coefficients in 1/m: those of absorption alone are Beer's colour at one metre, with scattering they are said
    themselves."""
    absorption = material["absorption"]
    result = {"extensions": {"KHR_materials_volume": {
        "thicknessFactor": 1, "attenuationDistance": 1, "attenuationColor": [math.exp(-a) for a in absorption]}}}
    if "scattering" in material:
        result["extras"] = {"boxlight_scatter": {"scattering": material["scattering"], "absorption": absorption,
                                                 "scatterAnisotropy": material.get("g", 0)}}
    return result


def gltf_material(material):
    colour = material.get("metal") or material.get("diffuse") or (1, 1, 1)
    result = {"pbrMetallicRoughness": {"baseColorFactor": [*colour, material.get("alpha", 1)],
                                       "metallicFactor": 1 if "metal" in material else 0,
                                       "roughnessFactor": material.get("roughness", 1)}, "doubleSided": True}
    extensions = {}
    if "diffuse" in material:
        extensions["KHR_materials_specular"] = {"specularFactor": 0}
    if "transmission" in material:
        extensions["KHR_materials_diffuse_transmission"] = {
            "diffuseTransmissionFactor": material["transmission"],
            "diffuseTransmissionColorFactor": material["transmitted"]}
    if "ior" in material:
        extensions["KHR_materials_transmission"] = {"transmissionFactor": 1}
        extensions["KHR_materials_ior"] = {"ior": material["ior"]}
    if "anisotropy" in material:
        extensions["KHR_materials_anisotropy"] = {"anisotropyStrength": material["anisotropy"],
                                                  "anisotropyRotation": material.get("rotation", 0)}
    if "emission" in material:
        strength = max(material["emission"])
        extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": strength}
        result["emissiveFactor"] = [c / strength for c in material["emission"]]
    if "alpha" in material:
        result["alphaMode"] = "BLEND"
    if material.get("closed"):
        medium = medium_extensions(material)
        extensions.update(medium.pop("extensions"))
        result.update(medium, doubleSided=False)
    if extensions:
        result["extensions"] = extensions
    return result
