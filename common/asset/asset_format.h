// SPDX-License-Identifier: Apache-2.0
#pragma once

// The records of a .ptb file, version 1, exactly as they stand on disk and in storage buffers: little-endian,
// no padding. docs/format.md is normative; where the two disagree, this file is wrong.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "common/light/box.h"

namespace boxlight::asset {

static_assert(std::endian::native == std::endian::little, "records are read and written in place");

inline constexpr uint8_t kMagic[8] = {0xAB, 'P', 'T', 'B', '\r', '\n', 0x1A, '\n'};
inline constexpr uint16_t kMajorVersion = 1;  ///< a reader refuses any other
/// 1.1 adds MATX, TXFM and kernels with emitted radiance; 1.2 the scheme split with VISI; 1.3 the scheme
/// cells with CELL; 1.4 cosine boxes; 1.5 Codec::planes; 1.6 coarser spheres of views with VIEW, and of atlas
/// levels with levl.
inline constexpr uint16_t kMinorVersion = 6;
inline constexpr uint32_t kNone = 0xFFFFFFFFu;
inline constexpr uint32_t kTileRecords =
    64;  ///< texel records per tile at most: one bit each in a 64-bit mask

// Limits, so that a reader can size its work before it trusts the file (docs/format.md, "Limits").
inline constexpr uint32_t kMaxChunks = 256;
inline constexpr uint32_t kMaxViewFrequency = 16;
inline constexpr uint32_t kMaxAtlasSize = 16384;    ///< texels, each side
inline constexpr uint32_t kMaxTextureSize = 16384;  ///< texels, each side
inline constexpr uint32_t kMaxBoxesPerKernel = 256;
/// Exponents of emitted radiance (box.h), du - 32768: those of single precision.
inline constexpr int kMinEmissionExponent = -148, kMaxEmissionExponent = 128;
inline constexpr uint32_t kMaxTextureTransforms = 65535;
inline constexpr uint64_t kMaxProvenanceSize = 1 << 20;  ///< bytes
inline constexpr uint32_t kMaxProvenanceDepth = 32;      ///< nested objects and arrays
/// A chunk decodes to at most max(kFreeExpansion, kMaxExpansion * storedSize) bytes: a small file stays small
/// in memory.
inline constexpr uint64_t kFreeExpansion = 16 << 20;
inline constexpr uint64_t kMaxExpansion = 1024;

constexpr uint32_t fourCc(const char (&name)[5]) {
  return uint32_t(uint8_t(name[0])) | uint32_t(uint8_t(name[1])) << 8 | uint32_t(uint8_t(name[2])) << 16 |
         uint32_t(uint8_t(name[3])) << 24;
}

/// How transport is represented. Of a file of scheme split, the records with kSplitLobe are; the others are
/// as in a sketch. Of a file of scheme cells, those with kDirectionCells are; the others are as in a split.
enum class Scheme : uint32_t { sketch = 1, split = 2, cells = 3 };
const char* schemeName(Scheme scheme);  ///< as `ptbake bake --scheme` has it

enum class Codec : uint32_t {
  none = 0,
  zstd = 1,    ///< one zstd frame with its content size, no dictionary
  pages = 2,   ///< separately compressed pages, found and verified through an index chunk of their own
  planes = 3,  ///< the same, the boxes of each laid out in planes (page_codec.h)
};
inline bool isPaged(Codec codec) { return codec == Codec::pages || codec == Codec::planes; }

struct FileHeader {
  uint8_t magic[8];
  uint16_t majorVersion, minorVersion;
  Scheme scheme;
  uint32_t chunkCount;
  uint32_t reserved;
  uint64_t fileSize;  ///< bytes, the whole file
  uint64_t headHash;  ///< xxh64 (seed 0) of the 32 bytes above and the chunk table, which follows the header
};
static_assert(sizeof(FileHeader) == 40);

struct ChunkEntry {
  uint32_t type;  ///< fourCc; a lower-case first letter marks a chunk that a reader may skip if it does not
                  ///< know it
  Codec codec;
  uint64_t offset;      ///< from the start of the file, a multiple of 16
  uint64_t storedSize;  ///< bytes in the file
  uint64_t rawSize;     ///< bytes after decoding; of all pages together where isPaged
  uint64_t hash;        ///< xxh64 (seed 0) of the stored bytes; 0 where isPaged: pages carry their own
};
static_assert(sizeof(ChunkEntry) == 40);

namespace chunk {
inline constexpr uint32_t kProvenance = fourCc("PROV");  ///< UTF-8 JSON
inline constexpr uint32_t kInfo = fourCc("INFO");        ///< one Info
inline constexpr uint32_t kVertices = fourCc("VERT");    ///< Vertex[]
inline constexpr uint32_t kTriangles = fourCc("TRIS");   ///< Triangle[]
inline constexpr uint32_t kMaterials = fourCc("MATL");   ///< Material[]
inline constexpr uint32_t kMaterialExtensions =
    fourCc("MATX");  ///< MaterialExtension[materialCount]; optional
inline constexpr uint32_t kTextureTransforms = fourCc("TXFM");  ///< TextureTransform[]; optional
inline constexpr uint32_t kTextures = fourCc("TEXI");           ///< Texture[]
inline constexpr uint32_t kTexels = fourCc("TEXD");  ///< RGBA8 texels of all textures, row 0 at the top
inline constexpr uint32_t kAtlas = fourCc("ATLS");   ///< AtlasTexel[atlasWidth * atlasHeight], row 0 is v = 0
inline constexpr uint32_t kAtlasLevels =
    fourCc("levl");  ///< AtlasTexel[] of all coarser levels, one after another; optional, may be skipped
inline constexpr uint32_t kRecords = fourCc("RECS");  ///< TexelRecord[recordCount]
inline constexpr uint32_t kTiles = fourCc("TILE");    ///< Tile[tileCount]
inline constexpr uint32_t kVisibilityMaps =
    fourCc("VISI");                                      ///< VisibilityMap[records with kSplitLobe]; optional
inline constexpr uint32_t kCellSphere = fourCc("CELL");  ///< one GeodesicSphere; optional
inline constexpr uint32_t kCoarseViews = fourCc("VIEW");  ///< GeodesicSphere[0 to kMaxCoarseViews]; optional
inline constexpr uint32_t kStreamMasks = fourCc("MASK");  ///< uint64_t[streamCount][tileCount]
inline constexpr uint32_t kPageIndex = fourCc("PGIX");    ///< PageEntry[streamCount][tileCount]
inline constexpr uint32_t kPages = fourCc("PAGE");        ///< PackedBox pages, stream-major; isPaged
}  // namespace chunk

/// A stream is one set of kernels of every texel: streams 0 .. viewCount-1 are the glossy kernels of the
/// views, each record's of its own sphere of views; stream viewCount is the view-independent Lambert kernel;
/// those of direction cells follow. streamCount = viewCount + 1 + cellCount.
struct Info {
  uint32_t atlasWidth, atlasHeight;  ///< texels
  uint32_t viewFrequency;            ///< of the geodesic icosahedron, view_sphere.h
  uint32_t viewCount;                ///< 10 f^2 + 2
  uint32_t vertexCount, triangleCount, materialCount, textureCount;
  uint32_t recordCount, tileCount;
  float boundsMin[3], boundsMax[3];  ///< of the mesh, metres
};
static_assert(sizeof(Info) == 64);

struct Vertex {
  float position[3];
  float normal[3];   ///< unit
  float tangent[4];  ///< unit, w = +1 or -1: bitangent = w * cross(normal, tangent)
  float atlasUv[2];  ///< [0,1], unique
  float uv[2][2];    ///< TEXCOORD_0, TEXCOORD_1
  float color[4];    ///< COLOR_0, linear, multiplies the base colour; 1 if absent
};
static_assert(sizeof(Vertex) == 80);

struct Triangle {
  uint32_t vertex[3];  ///< counter-clockwise seen from the front
  uint32_t material;
};
static_assert(sizeof(Triangle) == 16);

enum class Wrap : uint32_t { repeat = 0, clampToEdge = 1, mirroredRepeat = 2 };

/// One image as one sampler and one colour space see it.
struct Texture {
  uint32_t width, height;
  uint32_t firstTexel;  ///< index into TEXD, in texels of four bytes
  Wrap wrapS, wrapT;
  uint32_t srgb;        ///< 1: RGB decodes by the sRGB curve, alpha is linear
  uint32_t magNearest;  ///< 1: NEAREST magnification
  uint32_t minFilter;   ///< 0 nearest, 1 linear, 2 trilinear over the mip chain
};
static_assert(sizeof(Texture) == 32);

struct TextureRef {
  uint32_t texture = kNone;  ///< index into Texture[], or kNone
  uint16_t texcoord = 0;     ///< 0 or 1
  uint16_t transform = 0;    ///< 0: none; n: entry n - 1 of TextureTransform[]
};
static_assert(sizeof(TextureRef) == 8);

/// KHR_texture_transform: uv' = rows * (u, v, 1).
struct TextureTransform {
  float rows[2][3] = {{1, 0, 0}, {0, 1, 0}};
};
static_assert(sizeof(TextureTransform) == 24);

enum MaterialFlags : uint32_t {
  kDoubleSided = 1u << 0,
  kAlphaMask = 1u << 1,  ///< a pixel whose alpha is below alphaCutoff is not there
  // Only in files that have MATX:
  kAlphaBlend = 1u << 2,          ///< alpha is coverage: a pixel shows what lies behind with the rest
  kUnlit = 1u << 3,               ///< KHR_materials_unlit: emits its base colour and reflects nothing
  kVolume = 1u << 4,              ///< KHR_materials_volume: the surface bounds a medium, it is no thin wall
  kMultipleScattering = 1u << 5,  ///< GGX lobes with the energy that single scattering loses
};
inline constexpr uint32_t kExtensionFlags = kAlphaBlend | kUnlit | kVolume | kMultipleScattering;
inline constexpr uint32_t kKnownFlags = kDoubleSided | kAlphaMask | kExtensionFlags;

/// glTF 2.0 metallic-roughness with KHR_materials_specular. Factors multiply their texture, as the
/// specification says.
struct Material {
  float baseColor[4] = {1, 1, 1, 1};
  float metallic = 1, roughness = 1;
  float normalScale = 1;
  float alphaCutoff = 0.5f;
  float specular = 1;  ///< specularFactor
  float specularColor[3] = {1, 1, 1};
  uint32_t flags = 0;  ///< MaterialFlags
  TextureRef baseColorTexture;
  TextureRef metallicRoughnessTexture;  ///< G roughness, B metallic
  TextureRef normalTexture;
  TextureRef specularTexture;       ///< A
  TextureRef specularColorTexture;  ///< RGB
  uint32_t reserved = 0;
};
static_assert(sizeof(Material) == 96);

/// What Khronos extensions add to a Material of the same index; the default adds nothing. Factors multiply
/// their texture. Lengths are world-space metres.
struct MaterialExtension {
  float ior = 1.5f;                               ///< at least 1, or 0: F0 is 1
  float anisotropy = 0, anisotropyRotation = 0;   ///< [0,1]; radians from tangent to bitangent
  float clearcoat = 0, clearcoatRoughness = 0;    ///< [0,1]
  float clearcoatNormalScale = 1;                 ///< of the clearcoat normal texture's x and y
  float sheenColor[3] = {0, 0, 0};                ///< [0,1]
  float sheenRoughness = 0;                       ///< [0,1]
  float transmission = 0;                         ///< [0,1]
  float diffuseTransmission = 0;                  ///< [0,1]
  float diffuseTransmissionColor[3] = {1, 1, 1};  ///< [0,1]
  float iridescence = 0, iridescenceIor = 1.3f;   ///< [0,1]; at least 1
  float iridescenceThickness[2] = {100, 400};     ///< of the film, nanometres, where the texture is 0 and 1
  float emissive[3] = {0, 0, 0};                  ///< emissiveFactor times emissiveStrength, radiance
  float absorption[3] = {0, 0, 0};                ///< of the medium behind a kVolume surface, 1/m
  float scattering[3] = {0, 0, 0};                ///< 1/m
  float scatterAnisotropy = 0;                    ///< Henyey-Greenstein g, (-1,1)
  TextureRef anisotropyTexture;                   ///< RG direction, B strength
  TextureRef clearcoatTexture;                    ///< R
  TextureRef clearcoatRoughnessTexture;           ///< G
  TextureRef clearcoatNormalTexture;              ///< RGB
  TextureRef sheenColorTexture;                   ///< RGB, sRGB
  TextureRef sheenRoughnessTexture;               ///< A
  TextureRef transmissionTexture;                 ///< R
  TextureRef diffuseTransmissionTexture;          ///< A
  TextureRef diffuseTransmissionColorTexture;     ///< RGB, sRGB
  TextureRef iridescenceTexture;                  ///< R
  TextureRef iridescenceThicknessTexture;         ///< G
  TextureRef emissiveTexture;                     ///< RGB, sRGB
};
static_assert(sizeof(MaterialExtension) == 212);

/// Which records an atlas texel shows: of its front and its back side. Gutter texels point at the record of
/// their nearest covered texel; texels may share a record.
struct AtlasTexel {
  uint32_t front = kNone, back = kNone;
};
static_assert(sizeof(AtlasTexel) == 8);

enum RecordFlags : uint32_t {
  kBackSide = 1u << 0,   ///< the normal below is turned to the back of the surface
  kSplitLobe = 1u << 1,  ///< glossy kernels hold all but reflections straight from the light; Scheme::split
  /// Of a split record: what other surfaces send is stored for the directions that it comes from, not for
  /// those that it leaves in; Scheme::cells.
  kDirectionCells = 1u << 2,
  /// Two bits, n << kViewSphereShift: its views are those of entry n - 1 of VIEW, 0: of Info. Not beside
  /// kDirectionCells.
  kViewSphereBits = 3u << 3,
};
inline constexpr uint32_t kKnownRecordFlags = kBackSide | kSplitLobe | kDirectionCells | kViewSphereBits;
inline constexpr uint32_t kViewSphereShift = 3;
inline constexpr uint32_t kMaxCoarseViews = 3;  ///< spheres
/// 0 for the sphere of Info, else 1 + the entry of VIEW.
constexpr uint32_t viewSphereOf(uint32_t recordFlags) {
  return (recordFlags & kViewSphereBits) >> kViewSphereShift;
}

/// One side of one texel: where its kernels were traced, and with which first-hit parameters (means over the
/// footprint).
struct TexelRecord {
  float position[3];
  uint32_t flags;   ///< RecordFlags
  float normal[3];  ///< unit shading normal of this side: the horizon of the views
  uint32_t material;
  float tangent[3];  ///< unit
  float roughness;   ///< perceptual
  float f0[3];       ///< specular reflectance at normal incidence
  float metallic;
  uint32_t atlasX, atlasY;  ///< the texel, of its level
  uint32_t emissionSlot;    ///< reserved: kNone
  uint32_t level;           ///< of the atlas: 0, or of levl
};
static_assert(sizeof(TexelRecord) == 80);

/// A sphere whose vertices are directions of kernels (view_sphere.h) besides the one in Info: that of the
/// cells of records with kDirectionCells, or one of views for the records that viewSphereOf() names it for.
struct GeodesicSphere {
  uint32_t frequency;
  uint32_t count;  ///< 10 f^2 + 2
};
static_assert(sizeof(GeodesicSphere) == 8);

/// Up to kTileRecords consecutive records, neighbours in the atlas. All glossy kernels of a tile have the
/// same number of boxes.
struct Tile {
  uint32_t firstRecord, recordCount;
  uint32_t glossyBoxes;   ///< boxes of each glossy kernel; 0 if no record of the tile has any
  uint32_t diffuseBoxes;  ///< boxes of each Lambert kernel
};
static_assert(sizeof(Tile) == 16);

/// The boxes of one stream of one tile. Bit r of the stream's mask says that record firstRecord + r has a
/// kernel in it; the page holds those kernels in record order, each with the tile's number of boxes, so a
/// kernel's place is the number of set bits below r. Absent pages (mask 0) have storedSize = rawSize = 0.
struct PageEntry {
  uint64_t offset;               ///< from the start of the PAGE chunk
  uint32_t storedSize, rawSize;  ///< zstd frame; decoded, PackedBox[popcount(mask) * boxes]
  uint64_t hash;                 ///< xxh64 (seed 0) of the stored bytes
};
static_assert(sizeof(PageEntry) == 24);

}  // namespace boxlight::asset
