# SPDX-License-Identifier: Apache-2.0
"""Triangle meshes of the cases, in glTF's space, and the .glb files that hold them. Needs numpy."""
import math

import numpy as np

from glb import binary_chunk, read_glb, write_glb

ATTRIBUTES = (("POSITION", "positions", "VEC3"), ("NORMAL", "normals", "VEC3"), ("TANGENT", "tangents", "VEC4"))
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}


class Mesh:
    """Vertices (positions, unit normals or None, tangents with the bitangent's sign or None) and triangles."""

    def __init__(self, positions, triangles, normals=None, tangents=None):
        self.positions = np.asarray(positions, np.float32)
        self.triangles = np.asarray(triangles, np.uint32)
        self.normals = None if normals is None else np.asarray(normals, np.float32)
        self.tangents = None if tangents is None else np.asarray(tangents, np.float32)

    def fitted(self, radius, centre=(0, 0, 0)):
        """Scaled and moved so that the bounds' circumscribed sphere has this radius and centre."""
        low, high = self.positions.min(0), self.positions.max(0)
        scale = 2 * radius / np.linalg.norm(high - low)
        return Mesh((self.positions - (low + high) / 2) * scale + np.float32(centre), self.triangles, self.normals,
                    self.tangents)

    def flat(self):
        """Without normals: each triangle has its own, so that renderers cannot differ in what they do to them."""
        return Mesh(self.positions, self.triangles)


def sphere(radius, centre=(0, 0, 0), columns=192, rows=96):
    """Smooth normals, tangents along the circles of latitude."""
    positions, normals, tangents, triangles = [], [], [], []
    for j in range(rows + 1):
        for i in range(columns + 1):
            theta, phi = math.pi * j / rows, 2 * math.pi * i / columns
            n = (math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi))
            normals.append(n)
            positions.append([c + radius * x for c, x in zip(centre, n)])
            tangents.append((-math.sin(phi), 0, -math.cos(phi), 1))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b = a + columns + 1
            if j + 1 < rows:
                triangles.append((a, b, b + 1))
            if j > 0:
                triangles.append((a, b + 1, a + 1))
    return Mesh(positions, triangles, normals, tangents)


def ground(half, height):
    """A square that faces +Y."""
    corners = [(-half, height, half), (half, height, half), (half, height, -half), (-half, height, -half)]
    return Mesh(corners, [(0, 1, 2), (0, 2, 3)])


def accessor_data(document, binary, index):
    """Of a plain accessor: tightly packed, not sparse."""
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    width, kind = WIDTH[accessor["type"]], TYPES[accessor["componentType"]]
    offset = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    assert "byteStride" not in view and "sparse" not in accessor, "interleaved and sparse accessors are not read here"
    values = np.frombuffer(binary, kind, accessor["count"] * width, offset)
    return values.reshape(-1, width) if width > 1 else values


def read_meshes(path):
    """Every primitive of a .glb whose nodes do not move anything, in the file's order."""
    document, rest = read_glb(path)
    assert not any(key in node for node in document["nodes"] for key in ("matrix", "rotation", "scale", "translation"))
    read = []
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            data = {field: accessor_data(document, rest[8:], primitive["attributes"][name])
                    for name, field, _ in ATTRIBUTES if name in primitive["attributes"]}
            triangles = accessor_data(document, rest[8:], primitive["indices"]).reshape(-1, 3)
            read.append(Mesh(triangles=triangles, **data))
    return read


def write_scene(path, parts):
    """`parts`: pairs of a mesh and its glTF material; one node each."""
    views, accessors, binary = [], [], bytearray()

    def add(array, kind, component, **more):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": array.nbytes})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind,
                          "count": array.size // WIDTH[kind], **more})
        binary.extend(array.tobytes())
        return len(accessors) - 1

    meshes = []
    for index, (mesh, _) in enumerate(parts):
        attributes = {}
        for name, field, kind in ATTRIBUTES:
            array = getattr(mesh, field)
            if array is None:
                continue
            bounds = {"min": array.min(0).tolist(), "max": array.max(0).tolist()} if name == "POSITION" else {}
            attributes[name] = add(array, kind, 5126, **bounds)
        meshes.append({"primitives": [{"attributes": attributes, "material": index,
                                       "indices": add(mesh.triangles, "SCALAR", 5125)}]})
    extensions = sorted({name for _, material in parts for name in material.get("extensions", {})})
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(parts)))}],
                "nodes": [{"mesh": index} for index in range(len(parts))], "meshes": meshes,
                "materials": [material for _, material in parts], "buffers": [{"byteLength": len(binary)}],
                "bufferViews": views, "accessors": accessors}
    if extensions:
        document["extensionsUsed"] = extensions
    write_glb(path, document, binary_chunk(bytes(binary)))
