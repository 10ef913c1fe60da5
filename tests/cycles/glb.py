# SPDX-License-Identifier: Apache-2.0
"""The container of binary glTF 2.0."""
import json
import struct

MAGIC, VERSION, JSON_CHUNK, BINARY_CHUNK = b"glTF", 2, 0x4E4F534A, 0x004E4942


def read_glb(path):
    """The document, and everything behind its chunk as it stands in the file."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:4] == MAGIC, f"{path}: not a .glb file"
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[20 + length:]


def write_glb(path, document, rest):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    header = struct.pack("<4sIIII", MAGIC, VERSION, 20 + len(text) + len(rest), len(text), JSON_CHUNK)
    with open(path, "wb") as file:
        file.write(header + text + rest)


def binary_chunk(data):
    """`rest` of write_glb for the one buffer of a document."""
    data += bytes(-len(data) % 4)
    return struct.pack("<II", len(data), BINARY_CHUNK) + data
