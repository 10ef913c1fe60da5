# SPDX-License-Identifier: Apache-2.0
"""A labelled grid of small pictures as a PNG, with the standard library alone. Pixels are rows of linear (R, G, B)."""
import struct
import zlib

# 5 x 7 capitals and digits; a row is a base-32 digit (0-9, a-v) whose bits are pixels, the highest at the left.
FONT = {
    "A": "ehhvhhh", "B": "uhhuhhu", "C": "ehggghe", "D": "uhhhhhu", "E": "vggsggv", "F": "vggsggg", "G": "ehgnhhf",
    "H": "hhhvhhh", "I": "e44444e", "J": "72222ic", "K": "hikokih", "L": "ggggggv", "M": "hrllhhh", "N": "hpplljh",
    "O": "ehhhhhe", "P": "uhhuggg", "Q": "ehhhlid", "R": "uhhukih", "S": "fgge11u", "T": "v444444", "U": "hhhhhhe",
    "V": "hhhhha4", "W": "hhhllla", "X": "hha4ahh", "Y": "hha4444", "Z": "v1248gv", " ": "0000000", "-": "000v000",
    ".": "00000cc", ":": "0cc0cc0", "/": "1124488", "0": "ehjlphe", "1": "4c4444e", "2": "eh1248v", "3": "eh1611e",
    "4": "26aiv22", "5": "vgu111u", "6": "68guhhe", "7": "v124444", "8": "ehhehhe", "9": "ehhf12c",
}  # fmt: skip
GLYPH_WIDTH, LINE_HEIGHT = 6, 13
BACKGROUND, INK = (30, 30, 30), (230, 230, 230)


def over(rows, grey):
    """Premultiplied RGBA over linear grey."""
    return [[tuple(c + (1 - a) * grey for c in pixel) for *pixel, a in row] for row in rows]


def halve(rows):
    """The mean of 2 x 2 pixels."""
    return [
        [tuple(sum(c) / 4 for c in zip(*four)) for four in zip(above[::2], above[1::2], below[::2], below[1::2])]
        for above, below in zip(rows[::2], rows[1::2])
    ]


def encode(value):
    """8-bit sRGB, clamped."""
    value = min(max(value, 0.0), 1.0)
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))


class Sheet:
    """Cells of `columns`, each a label above its pictures, which lie below each other."""

    def __init__(self, columns, cells, margin=4):
        height, width = len(cells[0][1][0]), len(cells[0][1][0][0])
        step_x = width + margin
        step_y = LINE_HEIGHT + len(cells[0][1]) * (height + 2) + margin
        lines = -(-len(cells) // columns)
        self.width, self.height = columns * step_x + margin, lines * step_y + margin
        self.pixels = [[BACKGROUND] * self.width for _ in range(self.height)]
        for i, (label, pictures) in enumerate(cells):
            x, y = margin + i % columns * step_x, margin + i // columns * step_y
            self.write(label, x + (width - GLYPH_WIDTH * len(label)) // 2, y + 2)
            for k, picture in enumerate(pictures):
                self.paste(picture, x, y + LINE_HEIGHT + k * (height + 2))

    def paste(self, rows, x, y):
        for j, row in enumerate(rows):
            self.pixels[y + j][x : x + len(row)] = [tuple(map(encode, pixel)) for pixel in row]

    def write(self, text, x, y):
        for i, letter in enumerate(text.upper()):
            for j, digit in enumerate(FONT[letter]):
                for k in range(5):
                    if int(digit, 32) >> (4 - k) & 1:
                        self.pixels[y + j][x + GLYPH_WIDTH * i + k] = INK

    def save(self, path):
        above = bytes(3 * self.width)
        lines = []
        for row in self.pixels:
            line = bytes(channel for pixel in row for channel in pixel)
            lines.append(filtered(line, above))
            above = line

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        data = zlib.compress(b"".join(lines), 9)
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def filtered(line, above):
    """A PNG line by the one of three filters that leaves the least sum of magnitudes (PNG specification, 12.8)."""
    left, corner = bytes(3) + line[:-3], bytes(3) + above[:-3]
    choices = (
        (1, bytes((x - a) & 255 for x, a in zip(line, left))),
        (2, bytes((x - b) & 255 for x, b in zip(line, above))),
        (4, bytes((x - paeth(a, b, c)) & 255 for x, a, b, c in zip(line, left, above, corner))),
    )
    kind, best = min(choices, key=lambda choice: sum(min(d, 256 - d) for d in choice[1]))
    return bytes([kind]) + best


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c
