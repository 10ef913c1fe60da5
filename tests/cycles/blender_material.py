# SPDX-License-Identifier: Apache-2.0
"""The materials of cases.py as Cycles' closures. Runs inside Blender 3.4."""
import math

import bpy

from cases import brushed_alpha

TANGENT = "anisotropy_direction"  # mesh attribute; "tangent" would be one of Cycles' own


class Nodes:
    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.tree.nodes.clear()

    def add(self, kind, **inputs):
        node = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in inputs.items():
            socket = node.inputs[name.replace("_", " ")]
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
            else:
                socket.default_value = (*value, 1) if isinstance(value, (tuple, list)) else value
        return node.outputs[0]

    def combine(self, kind, a, b, **inputs):
        node = self.tree.nodes.new("ShaderNode" + kind)
        shaders = [socket for socket in node.inputs if socket.type == "SHADER"]
        self.tree.links.new(a, shaders[0])
        self.tree.links.new(b, shaders[1])
        for name, value in inputs.items():
            node.inputs[name].default_value = value
        return node.outputs[0]


def diffuse(nodes, m):
    surface = nodes.add("BsdfDiffuse", Color=m["diffuse"], Roughness=0.0)
    if "transmission" in m:
        surface = nodes.combine("MixShader", surface, nodes.add("BsdfTranslucent", Color=m["transmitted"]),
                                Fac=m["transmission"])
    if "emission" in m:
        surface = nodes.combine("AddShader", surface, nodes.add("Emission", Color=m["emission"], Strength=1.0))
    if "alpha" in m:
        surface = nodes.combine("MixShader", nodes.add("BsdfTransparent", Color=(1, 1, 1)), surface, Fac=m["alpha"])
    return surface


def metal(nodes, m):
    """Cycles' alpha across and along its tangent are roughness^2 (1 + a) and roughness^2 / (1 + a), a < 0."""
    along, across = brushed_alpha(m)
    attribute = nodes.tree.nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = TANGENT
    surface = nodes.add("BsdfAnisotropic", Color=m["metal"], Roughness=(along * across) ** .25,
                        Anisotropy=math.sqrt(across / along) - 1, Tangent=attribute.outputs["Vector"])
    surface.node.distribution = "GGX"
    return surface


def glass(nodes, m):
    surface = nodes.add("BsdfGlass", Color=(1, 1, 1), IOR=m["ior"], Roughness=m["roughness"])
    surface.node.distribution = "GGX"
    return surface


def volume(nodes, m):
    """Scattering by density times colour, absorption by density times what the colour lacks."""
    density = max(m["absorption"])
    absorbed = nodes.add("VolumeAbsorption", Color=tuple(1 - a / density for a in m["absorption"]), Density=density)
    if "scattering" not in m:
        return absorbed
    density = max(m["scattering"])
    scattered = nodes.add("VolumeScatter", Color=tuple(s / density for s in m["scattering"]), Density=density,
                          Anisotropy=m.get("g", 0.0))
    return nodes.combine("AddShader", scattered, absorbed)


def blender_material(name, m):
    nodes = Nodes(name)
    make = metal if "metal" in m else glass if "ior" in m else diffuse
    output = nodes.tree.nodes.new("ShaderNodeOutputMaterial")
    nodes.tree.links.new(make(nodes, m), output.inputs["Surface"])
    if m.get("closed"):
        nodes.tree.links.new(volume(nodes, m), output.inputs["Volume"])
    return nodes.material
