#!/usr/bin/env -S blender -b --factory-startup --python-exit-code 1 -P
# SPDX-License-Identifier: Apache-2.0
"""One case by Cycles, to be run inside Blender 3.4:

    blender -b --factory-startup --python-exit-code 1 -P render_in_cycles.py -- CASE SCENE.glb IMAGE OUT_{seed}.exr
            [--size N] [--spp N] [--seeds N] [--threads N]

Everything outside this file is in glTF's space; (x, y, z) there is (x, -z, y) in Blender. The geometry is SCENE.glb's,
the materials are cases.py's. A pixel is the mean over its square; nothing is clamped, filtered, denoised or left out:
a path may have as many bounces as Cycles can count.
"""
import argparse
import math
import pathlib
import sys

import bpy
import mathutils
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from blender_material import TANGENT, blender_material  # noqa: E402
from cases import CASES  # noqa: E402
from meshes import read_meshes  # noqa: E402

MOST_BOUNCES = 1024  # Cycles' own limit


def to_blender(vectors):
    v = np.asarray(vectors, float).reshape(-1, 3)
    return np.stack([v[:, 0], -v[:, 2], v[:, 1]], 1)


def anisotropy_directions(mesh, rotation):
    """KHR_materials_anisotropy: from the tangent towards the bitangent."""
    tangents, signs = mesh.tangents[:, :3], mesh.tangents[:, 3:]
    return math.cos(rotation) * tangents + math.sin(rotation) * signs * np.cross(mesh.normals, tangents)


def add_mesh(name, mesh, material):
    data = bpy.data.meshes.new(name)
    data.from_pydata(to_blender(mesh.positions).tolist(), [], mesh.triangles.tolist())
    if mesh.normals is not None:
        data.polygons.foreach_set("use_smooth", [True] * len(data.polygons))
        data.use_auto_smooth = True
        data.normals_split_custom_set_from_vertices(to_blender(mesh.normals).tolist())
    if "anisotropy" in material:
        attribute = data.attributes.new(TANGENT, "FLOAT_VECTOR", "POINT")
        directions = anisotropy_directions(mesh, material.get("rotation", 0))
        attribute.data.foreach_set("vector", to_blender(directions).ravel())
    data.materials.append(blender_material(name, material))
    data.validate()
    thing = bpy.data.objects.new(name, data)
    thing.cycles.shadow_terminator_geometry_offset = 0  # shadow rays start where the surface is
    bpy.context.scene.collection.objects.link(thing)


def set_world(path, rotation):
    """What is seen in direction d at rotation 0 is seen in Ry(rotation) d."""
    world = bpy.data.worlds.new("environment")
    bpy.context.scene.world = world
    world.use_nodes = True
    tree = world.node_tree
    coordinate, mapping = tree.nodes.new("ShaderNodeTexCoord"), tree.nodes.new("ShaderNodeMapping")
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(str(pathlib.Path(path).resolve()))
    texture.image.colorspace_settings.name = "Non-Color"  # radiance as it is in the file
    mapping.inputs["Rotation"].default_value = (0, 0, -math.radians(rotation))
    tree.links.new(coordinate.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], texture.inputs[0])
    tree.links.new(texture.outputs[0], tree.nodes["Background"].inputs[0])


def set_camera(eye, target, fov):
    data = bpy.data.cameras.new("camera")
    camera = bpy.data.objects.new("camera", data)
    eye, target = (mathutils.Vector(to_blender(p)[0]) for p in (eye, target))
    z = (eye - target).normalized()
    x = mathutils.Vector((0, 0, 1)).cross(z).normalized()
    camera.matrix_world = mathutils.Matrix((x, z.cross(x), z)).transposed().to_4x4()
    camera.matrix_world.translation = eye
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(fov)
    data.clip_start, data.clip_end = 1e-3, 1e5
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def set_options(options):
    scene = bpy.context.scene
    render, cycles = scene.render, scene.cycles
    render.engine, cycles.device = "CYCLES", "CPU"
    render.threads_mode, render.threads = "FIXED", options.threads
    render.resolution_x = render.resolution_y = options.size
    render.use_persistent_data, render.film_transparent = True, True
    render.use_compositing = render.use_sequencer = False
    image = render.image_settings
    image.file_format, image.color_mode, image.color_depth, image.exr_codec = "OPEN_EXR", "RGBA", "32", "ZIP"
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = options.spp, False, False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.light_sampling_threshold = cycles.min_light_bounces = cycles.min_transparent_bounces = 0
    for limit in ("max", "diffuse", "glossy", "transmission", "volume", "transparent_max"):
        setattr(cycles, limit + "_bounces", MOST_BOUNCES)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("case", choices=CASES)
    for name in ("scene", "environment", "output"):
        parser.add_argument(name)
    for name, default in (("size", 256), ("spp", 64), ("seeds", 8), ("threads", 2)):
        parser.add_argument("--" + name, type=int, default=default)
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    case = CASES[options.case]
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing, do_unlink=True)
    for index, (mesh, (_, material)) in enumerate(zip(read_meshes(options.scene), case.parts, strict=True)):
        add_mesh(f"part{index}", mesh, material)
    set_world(options.environment, case.rotation)
    set_camera(**case.camera)
    set_options(options)
    for seed in range(options.seeds):
        bpy.context.scene.cycles.seed = seed
        bpy.context.scene.render.filepath = str(pathlib.Path(options.output.replace("{seed}", str(seed))).resolve())
        bpy.ops.render.render(write_still=True)


main()
