#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A plain reader of .ptb files, written from docs/format.md alone.

    read_ptb.py ASSET.ptb     check the file and print a summary as JSON

Needs the Debian packages python3-zstandard and python3-xxhash. Ends with 3 if the file is damaged, with 5 if it is of
another version or scheme, with 77 (skipped, for CTest) if a package is missing.
"""
import json
import math
import struct
import sys

try:
    import xxhash
    import zstandard
except ImportError as missing:
    print(f"read_ptb.py: {missing}; apt-get install python3-zstandard python3-xxhash", file=sys.stderr)
    sys.exit(77)

NONE = 0xFFFFFFFF
MAGIC = bytes([0xAB, 0x50, 0x54, 0x42, 0x0D, 0x0A, 0x1A, 0x0A])
HEADER = struct.Struct("<8sHHIIIQQ")
CHUNK = struct.Struct("<IIQQQQ")
NO_CODEC, ZSTD, PAGES, PLANES = 0, 1, 2, 3

# Chapters 3 to 7: one row of numbers for each record, reserved fields left out ("4x").
TABLES = {
    "INFO": struct.Struct("<10I6f"),
    "VERT": struct.Struct("<20f"),
    "TRIS": struct.Struct("<4I"),
    "MATL": struct.Struct("<12fI" + 5 * "IHH" + "4x"),
    "MATX": struct.Struct("<29f" + 12 * "IHH"),
    "TXFM": struct.Struct("<6f"),
    "TEXI": struct.Struct("<8I"),
    "ATLS": struct.Struct("<2I"),
    "levl": struct.Struct("<2I"),
    "RECS": struct.Struct("<3fI3fI3ff3ff4I"),
    "TILE": struct.Struct("<4I"),
    "VISI": struct.Struct("<256I"),
    "CELL": struct.Struct("<2I"),
    "VIEW": struct.Struct("<2I"),
    "MASK": struct.Struct("<Q"),
    "PGIX": struct.Struct("<QIIQ"),
}
OPTIONAL = ["MATX", "TXFM", "VISI", "CELL", "VIEW", "levl"]
REQUIRED = [name for name in ["PROV", *TABLES, "TEXD", "PAGE"] if name not in OPTIONAL]
BOX = struct.Struct("<4H3eH")
LIGHT, EMISSION, HIDDEN, COSINE = 0, 1, 2, 3
SKETCH, SPLIT, CELLS = 1, 2, 3
BACK_SIDE, SPLIT_LOBE, DIRECTION_CELLS = 1, 2, 4  # flags of a record; bits 3 and 4 are the number of its sphere of views
BYTE_OF_PLANE = [14, 15, 1, 3, 5, 7, 0, 2, 4, 6, 9, 11, 13, 8, 10, 12]
TURNS = [6, 7, 6, 7, 2, 2, 2, 0]
FLOAT_MAX = (2 - 2**-23) * 2.0**127


class Invalid(Exception):
    code = 3


class Unsupported(Exception):
    code = 5


def require(condition, message, kind=Invalid):
    if not condition:
        raise kind(message)


def xxh64(data):
    return xxhash.xxh64_intdigest(data, 0)


def decompress(frame, raw_size, place):
    parameters = zstandard.get_frame_parameters(frame)
    require(parameters.content_size == raw_size and parameters.dict_id == 0, f"{place}: not a frame of {raw_size} bytes")
    decoder = zstandard.ZstdDecompressor().decompressobj()
    raw = decoder.decompress(frame)
    require(decoder.unused_data == b"" and len(raw) == raw_size, f"{place}: not exactly one frame")
    return raw


def from_planes(planes, slots):
    """Chapter 7, "Planes": the boxes of a page, kernel after kernel."""
    count = len(planes) // 16
    kernels = count // slots
    data = bytearray()
    for i in range(count):
        at = i % slots * kernels + i // slots
        turned = bytearray(16)
        for plane, byte in enumerate(BYTE_OF_PLANE):
            turned[byte] = planes[plane * count + at]
        words = [((w << turn) | (w >> (16 - turn))) & 0xFFFF for w, turn in zip(struct.unpack("<8H", turned), TURNS)]
        words[2], words[3] = (words[2] - 1) & 0xFFFF, (words[3] - 1) & 0xFFFF
        data += struct.pack("<8H", *words)
    return bytes(data)


class Ptb:
    """Every table as a list of rows of numbers; texels as bytes; pages on demand."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        self.read_head()
        self.raw = {name: self.decode(name) for name in self.chunks if name != "PAGE"}
        self.raw.update((name, b"") for name in OPTIONAL if name not in self.chunks)
        self.provenance = json.loads(self.raw["PROV"])
        require(isinstance(self.provenance, dict), "PROV: not an object")
        self.tables = {}
        self.emitted = {}  # (tile, is Lambert) -> do kernels begin with emitted radiance?
        for name, layout in TABLES.items():
            require(len(self.raw[name]) % layout.size == 0, f"{name}: not a whole number of entries")
            self.tables[name] = list(layout.iter_unpack(self.raw[name]))
        require(len(self.raw["TEXD"]) % 4 == 0, "TEXD: not a whole number of texels")
        self.texels = memoryview(self.raw["TEXD"])
        self.read_info()
        self.read_cells()
        self.read_views()
        self.check_mesh()
        self.check_atlas()
        self.check_tiles()
        self.check_pages()

    def read_head(self):
        data = self.data
        require(len(data) >= HEADER.size, "head: too short")
        magic, major, minor, scheme, count, _, size, head_hash = HEADER.unpack_from(data)
        require(magic == MAGIC, "head: magic")
        require(major == 1, f"head: version {major}.{minor}", Unsupported)
        require(size == len(data), "head: file size")
        end = HEADER.size + count * CHUNK.size
        require(count <= 256 and end <= len(data), "head: chunk table")
        require(xxh64(data[:32] + data[HEADER.size : end]) == head_hash, "head: hash")
        require(scheme in (SKETCH, SPLIT, CELLS), f"head: scheme {scheme}", Unsupported)
        self.header = (major, minor, scheme, count, size, head_hash)
        self.chunk_rows = [CHUNK.unpack_from(data, HEADER.size + i * CHUNK.size) for i in range(count)]
        self.chunks = {}
        used = []
        for row in self.chunk_rows:
            kind, codec, offset, stored, raw, _ = row
            name = kind.to_bytes(4, "little").decode("latin-1")
            require(offset % 16 == 0 and offset >= end and offset + stored <= len(data), f"{name}: range")
            used.append((offset, offset + stored))
            if name not in REQUIRED + OPTIONAL:
                require("a" <= name[0] <= "z", f"{name}: unknown", Unsupported)
                continue
            require(name not in self.chunks, f"{name}: twice")
            require(codec in ((PAGES, PLANES) if name == "PAGE" else (NO_CODEC, ZSTD)), f"{name}: codec", Unsupported)
            require(codec != NO_CODEC or raw == stored, f"{name}: sizes")
            require(codec != ZSTD or raw <= max(16 << 20, 1024 * stored), f"{name}: expands too far")
            self.chunks[name] = row
        used = sorted(pair for pair in used if pair[0] != pair[1])
        require(all(a[1] <= b[0] for a, b in zip(used, used[1:])), "head: chunks overlap")
        missing = [name for name in REQUIRED if name not in self.chunks]
        require(not missing, f"head: no {missing}")

    def decode(self, name):
        _, codec, offset, stored, raw, chunk_hash = self.chunks[name]
        data = self.data[offset : offset + stored]
        require(xxh64(data) == chunk_hash, f"{name}: hash")
        return decompress(data, raw, name) if codec == ZSTD else data

    def read_info(self):
        require(len(self.tables["INFO"]) == 1, "INFO: not one entry")
        info = self.tables["INFO"][0]
        self.atlas_size, self.frequency, self.view_count = info[0:2], info[2], info[3]
        require(1 <= self.frequency <= 16 and self.view_count == 10 * self.frequency**2 + 2, "INFO: views")
        require(all(1 <= side <= 16384 for side in self.atlas_size), "INFO: atlas")
        for name, count in zip(("VERT", "TRIS", "MATL", "TEXI", "RECS", "TILE"), info[4:10]):
            require(len(self.tables[name]) == count, f"{name}: count")
        for name in ("INFO", "VERT", "MATL", "MATX", "TXFM", "RECS"):
            require(all(math.isfinite(n) for row in self.tables[name] for n in row), f"{name}: not finite")

    def read_cells(self):
        spheres = self.tables["CELL"]
        require(len(spheres) == (1 if self.header[2] == CELLS else 0), "CELL: not one entry in a file of cells, or some in another")
        for frequency, count in spheres:
            require(1 <= frequency <= 16 and count == 10 * frequency**2 + 2, "CELL: cells")
        self.stream_count = self.view_count + 1 + sum(count for _, count in spheres)

    def read_views(self):
        self.views_of_sphere = [self.view_count]
        above = self.frequency
        for frequency, count in self.tables["VIEW"]:
            require(1 <= frequency < above and count == 10 * frequency**2 + 2, "VIEW: not coarser than the sphere before")
            self.views_of_sphere.append(count)
            above = frequency
        require(len(self.views_of_sphere) <= 4, "VIEW: more than three spheres")

    def check_mesh(self):
        t = self.tables
        for *corners, material in t["TRIS"]:
            require(max(corners) < len(t["VERT"]) and material < len(t["MATL"]), "TRIS: index")
        for name, start in (("MATL", 13), ("MATX", 29)):
            for row in t[name]:
                for texture, texcoord, transform in zip(row[start::3], row[start + 1 :: 3], row[start + 2 :: 3]):
                    known = texture < len(t["TEXI"]) and texcoord <= 1 and transform <= len(t["TXFM"])
                    require(texture == NONE or known, f"{name}: texture")
        self.check_extensions()
        for width, height, first, wrap_s, wrap_t, srgb, nearest, filtering in t["TEXI"]:
            require(1 <= width <= 16384 and 1 <= height <= 16384, "TEXI: size")
            require(4 * (first + width * height) <= len(self.texels), "TEXI: texels")
            require(max(wrap_s, wrap_t, filtering) <= 2 and max(srgb, nearest) <= 1, "TEXI: sampler")

    def check_extensions(self):
        materials, extensions = self.tables["MATL"], self.tables["MATX"]
        require(len(extensions) in (0, len(materials)), "MATX: count")
        require(extensions or not any(row[12] & 0b111100 for row in materials), "MATL: flags need MATX")
        require(len(self.tables["TXFM"]) <= 65535, "TXFM: count")
        for row in extensions:
            require(row[0] >= 0 and row[16] > 0 and abs(row[28]) < 1, "MATX: ior, iridescenceIor or scatterAnisotropy")
            require(min(row[19:28]) >= 0, "MATX: emissive, absorption or scattering")

    def check_atlas(self):
        records, sizes = self.tables["RECS"], self.level_sizes()
        for level, texels in enumerate(self.texels_of_levels(sizes)):
            for sides in texels:
                for back, record in enumerate(sides):
                    known = record == NONE or (record < len(records) and records[record][3] & BACK_SIDE == back)
                    require(known and (record == NONE or records[record][19] == level), f"atlas, level {level}: record")
        for row in records:
            require(row[7] < len(self.tables["MATL"]), "RECS: material")
            require(row[19] < len(sizes), "RECS: level")
            require(row[16] < sizes[row[19]][0] and row[17] < sizes[row[19]][1], "RECS: texel")
            sphere = row[3] >> 3 & 3
            require(sphere < len(self.views_of_sphere) and not (sphere and row[3] & DIRECTION_CELLS), "RECS: sphere of views")
            for vector in (row[4:7], row[8:11]):
                require(abs(math.hypot(*vector) - 1) < 1e-3, "RECS: not unit")
            lobe, cells = row[3] & SPLIT_LOBE, row[3] & DIRECTION_CELLS
            require(not lobe or self.header[2] in (SPLIT, CELLS), "RECS: split records in a sketch")
            require(not cells or (lobe and self.header[2] == CELLS), "RECS: direction cells without a split lobe or the scheme")
        split = sum(bool(row[3] & SPLIT_LOBE) for row in records)
        require(split == len(self.tables["VISI"]), "VISI: not one map for each split record")

    def level_sizes(self):
        """Chapter 5: texels each way of the atlas and of its coarser levels."""
        sizes = [tuple(self.atlas_size)]
        while sum(w * h for w, h in sizes[1:]) < len(self.tables["levl"]):
            require(sizes[-1] != (1, 1), "levl: more than all levels")
            sizes.append(tuple(max(side // 2, 1) for side in sizes[-1]))
        return sizes

    def texels_of_levels(self, sizes):
        width, height = sizes[0]
        require(len(self.tables["ATLS"]) == width * height, "ATLS: count")
        require(sum(w * h for w, h in sizes[1:]) == len(self.tables["levl"]), "levl: not a whole number of levels")
        yield self.tables["ATLS"]
        first = 0
        for width, height in sizes[1:]:
            yield self.tables["levl"][first : first + width * height]
            first += width * height

    def check_tiles(self):
        end = 0
        for first, count, glossy, diffuse in self.tables["TILE"]:
            require(first == end and 1 <= count <= 64 and max(glossy, diffuse) <= 256, "TILE: range")
            end = first + count
        require(end == len(self.tables["RECS"]), "TILE: do not cover the records")
        for name in ("MASK", "PGIX"):
            require(len(self.tables[name]) == self.stream_count * len(self.tables["TILE"]), f"{name}: count")

    def page_list(self):
        """(stream, tile, mask, boxes per kernel, page entry) of every page, absent ones included."""
        tiles = self.tables["TILE"]
        for index, ((mask,), entry) in enumerate(zip(self.tables["MASK"], self.tables["PGIX"])):
            stream, tile = divmod(index, len(tiles))
            yield stream, tile, mask, tiles[tile][3 if stream == self.view_count else 2], entry

    def records_of(self, mask, tile):
        first = self.tables["TILE"][tile][0]
        return [first + bit for bit in range(64) if mask >> bit & 1]

    def check_pages(self):
        size = self.chunks["PAGE"][3]
        for stream, tile, mask, boxes, (offset, stored, raw, _) in self.page_list():
            place = f"page {stream} {tile}"
            require(mask >> self.tables["TILE"][tile][1] == 0 and (mask == 0 or boxes > 0), f"{place}: mask")
            kinds = {self.tables["RECS"][record][3] & DIRECTION_CELLS for record in self.records_of(mask, tile)}
            allowed = {0, DIRECTION_CELLS} if stream == self.view_count else {DIRECTION_CELLS} if stream > self.view_count else {0}
            require(kinds <= allowed, f"{place}: mask of records with and without direction cells")
            if stream < self.view_count:
                spheres = {self.tables["RECS"][record][3] >> 3 & 3 for record in self.records_of(mask, tile)}
                require(all(stream < self.views_of_sphere[sphere] for sphere in spheres), f"{place}: mask of records with fewer views")
            require(raw == 16 * bin(mask).count("1") * boxes and (raw == 0) == (stored == 0), f"{place}: size")
            require(offset + stored <= size, f"{place}: range")

    def page(self, stream, tile, entry):
        """Rows of 0, u0, v0, width, height, energy R G B, of 1, radiance R G B, of 2, hidden part, of 3, u0, v0, width, height, amplitude."""
        offset, stored, raw, page_hash = entry
        if stored == 0:
            return []
        start = self.chunks["PAGE"][2] + offset
        frame = self.data[start : start + stored]
        place = f"page {stream} {tile}"
        require(xxh64(frame) == page_hash, f"{place}: hash")
        boxes = self.tables["TILE"][tile][3 if stream == self.view_count else 2]
        data = decompress(frame, raw, place)
        if self.chunks["PAGE"][1] == PLANES:
            data = from_planes(data, boxes)
        rows = [self.slot(place, *slot) for slot in BOX.iter_unpack(data)]
        kernels = [rows[first : first + boxes] for first in range(0, len(rows), boxes)]
        self.check_kinds(stream, tile, [[row[0] for row in kernel] for kernel in kernels])
        self.check_emitted(stream, tile, rows[::boxes])
        return rows

    def slot(self, place, u0, v0, du, dv, red, green, blue, kind):
        energy = (red, green, blue)
        require(all((e >= 0 or kind == COSINE) and math.isfinite(e) for e in energy), f"{place}: energy")
        require(kind in (LIGHT, EMISSION, HIDDEN, COSINE), f"{place}: kind")
        if kind == HIDDEN:
            return (HIDDEN, red)
        if kind == EMISSION:
            require(-148 <= du - 32768 <= 128, f"{place}: exponent")
            radiance = [math.ldexp(e, du - 32768) for e in energy]
            require(max(radiance) <= FLOAT_MAX, f"{place}: emitted radiance")
            return (EMISSION, *radiance)
        require(v0 + dv + 1 <= 65536, f"{place}: box below the domain")
        edges = (u0 / 65536, v0 / 65536, (du + 1) / 65536, (dv + 1) / 65536)
        if kind == COSINE:
            require(v0 % 512 == 0 and (v0 + dv + 1) % 512 == 0, f"{place}: cosine box off its raster")
            return (COSINE, *edges, red)
        return (LIGHT, *edges, *energy)

    def check_kinds(self, stream, tile, kernels):
        """Emitted radiance in slot 0 only; behind it, exactly the glossy kernels of split records say their hidden part. Cosine boxes in
        Lambert kernels only."""
        (mask,) = self.tables["MASK"][stream * len(self.tables["TILE"]) + tile]
        for record, kinds in zip(self.records_of(mask, tile), kernels):
            place = f"page {stream} {tile}, record {record}"
            if kinds[0] == EMISSION:
                kinds = kinds[1:]
            if stream != self.view_count and self.tables["RECS"][record][3] & SPLIT_LOBE:
                require(kinds[:1] == [HIDDEN], f"{place}: no hidden part")
                kinds = kinds[1:]
            require(set(kinds) <= ({LIGHT, COSINE} if stream == self.view_count else {LIGHT}), f"{place}: kinds")

    def check_emitted(self, stream, tile, first_slots):
        key = (tile, stream == self.view_count)
        found = {row[0] == EMISSION for row in first_slots}
        found.add(self.emitted.setdefault(key, first_slots[0][0] == EMISSION))
        require(len(found) == 1, f"page {stream} {tile}: some kernels of the tile have emitted radiance, some not")
        require(found == {False} or self.tables["MATX"], f"page {stream} {tile}: emitted radiance needs MATX")


def view_sphere(f):
    """Chapter 6: directions and triangles."""
    phi = (1 + math.sqrt(5)) / 2
    corners = [(-1, phi, 0), (1, phi, 0), (-1, -phi, 0), (1, -phi, 0), (0, -1, phi), (0, 1, phi),
               (0, -1, -phi), (0, 1, -phi), (phi, 0, -1), (phi, 0, 1), (-phi, 0, -1), (-phi, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    directions, triangles, numbers = [], [], {}
    for face in faces:
        def point(i, j):
            weights = (f - i - j, i, j)
            key = frozenset((corner, weight) for corner, weight in zip(face, weights) if weight)
            if key not in numbers:
                numbers[key] = len(directions)
                total = [sum(w * corners[c][axis] for c, w in zip(face, weights)) for axis in range(3)]
                directions.append(tuple(x / math.hypot(*total) for x in total))
            return numbers[key]

        for i in range(f):
            for j in range(f - i):
                triangles.append((point(i, j), point(i + 1, j), point(i, j + 1)))
                if i + j + 1 < f:
                    triangles.append((point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)))
    return directions, triangles


def summary(ptb):
    pages = boxes = 0
    energy = 0.0
    for stream, tile, _, _, entry in ptb.page_list():
        rows = ptb.page(stream, tile, entry)
        pages += bool(rows)
        boxes += len(rows)
        energy += sum(sum(row[5:8]) for row in rows if row[0] == LIGHT)
    return {"version": f"{ptb.header[0]}.{ptb.header[1]}", "provenance": ptb.provenance,
            "views": ptb.view_count, "atlas": list(ptb.atlas_size),
            "entries": {name: len(rows) for name, rows in ptb.tables.items()},
            "pages": pages, "boxes": boxes, "energy": energy}


def main(path):
    try:
        print(json.dumps(summary(Ptb(path)), indent=2))
    except (Invalid, Unsupported) as error:
        print(f"read_ptb.py: {path}: {error}", file=sys.stderr)
        return error.code
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
