# SPDX-License-Identifier: Apache-2.0
"""Just enough OpenEXR for goldens: scan-line files with zip or no compression, half or float channels (the file layout
document of openexr.com). Pixels are rows of float tuples (R, G, B, A)."""
import struct
import zlib

MAGIC = 20000630
HALF, FLOAT = 1, 2
NONE, ZIPS, ZIP = 0, 2, 3
ROWS_PER_BLOCK = {NONE: 1, ZIPS: 1, ZIP: 16}


def read(path):
    data = path.read_bytes()
    if struct.unpack_from("<I", data)[0] != MAGIC:
        raise ValueError(f"{path}: not an EXR file")
    header, position = read_header(data, 8)
    compression = header["compression"][0]
    if compression not in ROWS_PER_BLOCK:
        raise ValueError(f"{path}: compression {compression} is not read here")
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = read_channels(header["channels"])
    blocks = -(-height // ROWS_PER_BLOCK[compression])
    rows = []
    for offset in struct.unpack_from(f"<{blocks}Q", data, position):
        first, size = struct.unpack_from("<iI", data, offset)
        count = min(ROWS_PER_BLOCK[compression], height - (first - y0))
        raw_size = count * width * sum(4 if kind == FLOAT else 2 for _, kind in channels)
        block = data[offset + 8 : offset + 8 + size]
        rows += read_rows(block if size == raw_size else unpack(block), channels, width, count)
    return rows


def read_header(data, position):
    header = {}
    while data[position]:
        name, position = read_name(data, position)
        _, position = read_name(data, position)
        (size,) = struct.unpack_from("<I", data, position)
        header[name] = data[position + 4 : position + 4 + size]
        position += 4 + size
    return header, position + 1


def read_name(data, position):
    end = data.index(0, position)
    return data[position:end].decode(), end + 1


def read_channels(data):
    channels, position = [], 0
    while data[position]:
        name, position = read_name(data, position)
        channels.append((name, struct.unpack_from("<I", data, position)[0]))
        position += 16
    return channels


def read_rows(block, channels, width, count):
    position = 0
    for _ in range(count):
        planes = {"A": [1.0] * width}
        for name, kind in channels:
            planes[name] = struct.unpack_from(f"<{width}{'f' if kind == FLOAT else 'e'}", block, position)
            position += width * (4 if kind == FLOAT else 2)
        yield list(zip(planes["R"], planes["G"], planes["B"], planes["A"]))


def unpack(block):
    """Undoes zip: deflate, differences of bytes, even bytes before odd ones."""
    data = bytearray(zlib.decompress(block))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    half = (len(data) + 1) // 2
    result = bytearray(len(data))
    result[0::2], result[1::2] = data[:half], data[half:]
    return bytes(result)


def pack(block):
    data = block[0::2] + block[1::2]
    differences = bytes([data[0]]) + bytes((b - a + 128) & 255 for a, b in zip(data, data[1:]))
    packed = zlib.compress(differences, 9)
    return packed if len(packed) < len(block) else block


def write_half(path, rows):
    """Half floats, zip. The same rows give the same bytes."""
    width, height = len(rows[0]), len(rows)
    channels = b"".join(name + b"\0" + struct.pack("<IIII", HALF, 0, 1, 1) for name in (b"A", b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    attributes = (
        (b"channels", b"chlist", channels),
        (b"compression", b"compression", bytes([ZIP])),
        (b"dataWindow", b"box2i", window),
        (b"displayWindow", b"box2i", window),
        (b"lineOrder", b"lineOrder", b"\0"),
        (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
        (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)),
        (b"screenWindowWidth", b"float", struct.pack("<f", 1)),
    )
    header = struct.pack("<II", MAGIC, 2)
    for name, kind, value in attributes:
        header += name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    header += b"\0"
    blocks = []
    for first in range(0, height, ROWS_PER_BLOCK[ZIP]):
        block = b"".join(
            struct.pack(f"<{width}e", *(pixel[channel] for pixel in row))
            for row in rows[first : first + ROWS_PER_BLOCK[ZIP]]
            for channel in (3, 2, 1, 0)
        )
        packed = pack(block)
        blocks.append(struct.pack("<iI", first, len(packed)) + packed)
    offsets, position = b"", len(header) + 8 * len(blocks)
    for block in blocks:
        offsets += struct.pack("<Q", position)
        position += len(block)
    path.write_bytes(header + offsets + b"".join(blocks))


def write_png(path, rows, exposure=0.0):
    """8-bit sRGB, clamped: what the programs' PNGs show, over black."""
    raw = b"".join(b"\0" + bytes(encode(value * 2.0**exposure) for pixel in row for value in pixel[:3]) for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def encode(value):
    value = min(max(value, 0.0), 1.0)
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))
