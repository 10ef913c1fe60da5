# SPDX-License-Identifier: Apache-2.0
"""8-bit pictures as rows of RGB bytes: the PNGs that the programs write, and how far two pictures are apart."""
import struct
import zlib


def read_png(path):
    """Rows of RGB bytes of an 8-bit RGB or RGBA PNG without interlacing (RFC 2083); alpha is dropped."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    position, packed = 8, b""
    while position < len(data):
        size, kind = struct.unpack_from(">I4s", data, position)
        body = data[position + 8 : position + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert depth == 8 and colour in (2, 6) and interlace == 0, path
        packed += body if kind == b"IDAT" else b""
        position += 12 + size
    channels = 3 if colour == 2 else 4
    rows = unfilter(zlib.decompress(packed), width * channels, height, channels)
    return [bytes(value for i, value in enumerate(row) if i % channels < 3) for row in rows]


def unfilter(raw, stride, height, step):
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            line[i] = (line[i] + prediction(kind, left, above[i], corner)) & 255
        rows.append(line)
        above = line
    return rows


def prediction(kind, left, above, corner):
    if kind < 4:
        return (0, left, above, (left + above) // 2)[kind]
    guess = left + above - corner
    distances = (abs(guess - left), abs(guess - above), abs(guess - corner))
    return (left, above, corner)[distances.index(min(distances))]


def difference(a, b):
    """(largest, mean) difference of two pictures in 8-bit steps; infinite where their sizes differ."""
    if len(a) != len(b) or len(a[0]) != len(b[0]):
        return float("inf"), float("inf")
    steps = [abs(x - y) for row, other in zip(a, b) for x, y in zip(row, other)]
    return max(steps), sum(steps) / len(steps)
