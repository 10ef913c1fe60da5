// SPDX-License-Identifier: Apache-2.0
#include "common/asset/finding.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace boxlight::asset {
namespace {

constexpr const char* kCopyAgain = "the file is damaged: copy it again, or bake it again";
constexpr const char* kBakeAgain =
    "bake the scene again; if this comes back, the program that wrote it is wrong";
constexpr const char* kUpdate = "use a newer version of this program, or bake the scene again with this one";

using enum FindingCode;
using enum Severity;

constexpr FindingKind kKinds[] = {
    {tooShort, error, "the file is too short for its head", kCopyAgain},
    {magic, error, "not a .ptb file, or changed by a text-mode transfer", "name an asset that ptbake wrote"},
    {majorVersion, error, "another major version", kUpdate, ExitCode::unsupported},
    {fileSize, error, "the file's size is not the one it was written with", kCopyAgain},
    {chunkTable, error, "the chunk table does not fit", kCopyAgain},
    {headHash, error, "the hash of header and chunk table differs", kCopyAgain},
    {scheme, error, "an unknown transport scheme", kUpdate, ExitCode::unsupported},
    {newerMinor, note, "a newer minor version", "nothing to do: what this version does not know is optional"},
    {chunkRange, error, "a chunk lies outside the file, on its head, or unaligned", kCopyAgain},
    {chunkOverlap, error, "two chunks overlap", kBakeAgain},
    {chunkDuplicate, error, "a chunk is there twice", kBakeAgain},
    {chunkMissing, error, "a required chunk is missing", kBakeAgain},
    {chunkUnknown, error, "an unknown chunk that must be understood", kUpdate, ExitCode::unsupported},
    {chunkSkipped, note, "an unknown chunk that may be skipped", "nothing to do"},
    {chunkCodec, error, "a codec that this chunk cannot have", kUpdate, ExitCode::unsupported},
    {chunkSize, error, "a chunk's sizes contradict each other or its contents", kBakeAgain},
    {chunkHash, error, "the hash of a chunk differs", kCopyAgain},
    {chunkFrame, error, "a chunk does not decompress to its raw size", kBakeAgain},
    {provenance, error, "the provenance is not a JSON object within the limits", kBakeAgain},
    {counts, error, "a table does not have as many entries as INFO says", kBakeAgain},
    {limits, error, "a size is zero or above the format's limit", kBakeAgain},
    {viewCount, error, "the number of views is not 10 f^2 + 2", kBakeAgain},
    {notFinite, error, "a number is NaN or infinite", kBakeAgain},
    {bounds, warning, "the bounds do not hold the mesh", kBakeAgain},
    {vertexFrame, warning, "a normal or tangent is not unit, or a bitangent sign not +1 or -1",
     "give the scene unit normals and tangents, and bake it again"},
    {triangleVertex, error, "a triangle's vertex does not exist", kBakeAgain},
    {triangleMaterial, error, "a triangle's material does not exist", kBakeAgain},
    {materialTexture, error, "a material's texture, texture coordinate or texture transform does not exist",
     kBakeAgain},
    {materialValue, warning, "a material factor is outside glTF's range",
     "mend the scene, and bake it again"},
    {textureLayout, error, "a texture's size, texels or sampler are out of range", kBakeAgain},
    {atlasRecord, error, "an atlas texel's record does not exist or is of the other side", kBakeAgain},
    {recordMaterial, error, "a record's material does not exist", kBakeAgain},
    {recordTexel, error, "a record's texel lies outside the atlas", kBakeAgain},
    {recordFrame, error, "a record's normal or tangent is not unit", kBakeAgain},
    {recordValue, error, "a record's first-hit parameter is out of range", kBakeAgain},
    {tileRange, error, "the tiles do not cover the records one after another", kBakeAgain},
    {tileBoxes, error, "a tile has more boxes per kernel than allowed", kBakeAgain},
    {maskBits, error, "a mask names kernels that its tile cannot have", kBakeAgain},
    {reserved, warning, "a reserved field or flag is not zero",
     "ignored; a newer minor version may mean something by it"},
    {vertexAtlasUv, warning, "an atlas coordinate lies outside [0,1]", kBakeAgain},
    {extensionMissing, error, "what needs MATX is in a file without it", kBakeAgain},
    {extensionValue, error, "a value of a material extension is one that no reader can use", kBakeAgain},
    {visibilityMaps, error, "there is not one visibility map for each split record, or the scheme has none",
     kBakeAgain},
    {directionCells, error,
     "the scheme cells, its one CELL of 10 f^2 + 2 cells and the records' flags contradict each other",
     kBakeAgain},
    {coarseViews, error, "the spheres of VIEW are not coarser and coarser, or do not fit the records' flags",
     kBakeAgain},
    {atlasLevels, error, "the atlas's levels are not whole, or show records of another level", kBakeAgain},
    {pageSize, error, "a page's raw size is not what its mask and tile say", kBakeAgain},
    {pageRange, error, "a page lies outside its chunk", kBakeAgain},
    {pageHash, error, "the hash of a page differs", kCopyAgain},
    {pageFrame, error, "a page does not decompress to its raw size", kBakeAgain},
    {boxRange, error,
     "a box reaches below the light domain or lies off its raster, or emitted radiance is beyond single "
     "precision",
     kBakeAgain},
    {boxEnergy, error, "a box's energy is negative, NaN or infinite, or a cosine box's amplitude no number",
     kBakeAgain},
    {kernelEnergy, warning, "a kernel returns far more light than falls in",
     "bake with more paths; fireflies look like this"},
    {boxKind, error,
     "a box is of an unknown kind, emitted radiance is not in the first slot, or a glossy kernel has cosine "
     "boxes",
     kBakeAgain},
    {emittedSlots, error, "kernels of a tile do not agree on whether they begin with emitted radiance",
     kBakeAgain},
    {hiddenPart, error, "a split record's kernel does not say its hidden part once, or another kernel does",
     kBakeAgain},
};

}  // namespace

std::span<const FindingKind> findingKinds() { return kKinds; }

const FindingKind& findingKind(FindingCode code) {
  const auto* kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                  [&](const FindingKind& candidate) { return candidate.code == code; });
  assert(kind != std::end(kKinds));
  return *kind;
}

const char* severityName(Severity severity) {
  return severity == error ? "error" : severity == warning ? "warning" : "note";
}

std::string Finding::message() const {
  return fmt::format("{}: {}{}{}; {}", chunk, place, place.empty() ? "" : ": ", what, kind->remedy);
}

std::string Reporter::chunkName(uint32_t type) {
  if (type == 0) return "head";
  std::string name;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto letter = char(type >> shift & 0xFF);
    name += letter > ' ' && letter <= '~' ? letter : '?';
  }
  return name;
}

Reporter throwingReporter(std::string file) {
  return Reporter([file = std::move(file)](const Finding& finding) {
    if (finding.kind->severity == error) throw Error(finding.kind->exitCode, file + ": " + finding.message());
  });
}

}  // namespace boxlight::asset
