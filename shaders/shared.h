// SPDX-License-Identifier: Apache-2.0
// Constants and records that C++ and GLSL share. Vectors have GLSL's names in both; records follow std430.
#ifndef BOXLIGHT_SHARED_H
#define BOXLIGHT_SHARED_H

#ifdef __cplusplus
#include "common/base/math.h"
namespace boxlight::gpu {
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = unsigned;
#define SHARED_CONSTANT inline constexpr uint
#else
#define SHARED_CONSTANT const uint
#endif

// Bindings of the one descriptor set.
SHARED_CONSTANT kBindFrame = 0;                // FrameConstants
SHARED_CONSTANT kBindVertices = 1;             // asset::Vertex, as floats
SHARED_CONSTANT kBindTriangles = 2;            // asset::Triangle
SHARED_CONSTANT kBindMaterials = 3;            // asset::Material
SHARED_CONSTANT kBindTextures = 4;             // TextureHeader
SHARED_CONSTANT kBindTextureLevels = 5;        // TextureLevel
SHARED_CONSTANT kBindTexels = 6;               // RGBA8
SHARED_CONSTANT kBindAtlas = 7;                // asset::AtlasTexel, level after level
SHARED_CONSTANT kBindRecords = 8;              // GpuRecord
SHARED_CONSTANT kBindTiles = 9;                // asset::Tile
SHARED_CONSTANT kBindPageTable = 10;           // PageSlot[streamCount][tileCount]
SHARED_CONSTANT kBindBoxPools = 11;            // kMaxBoxPools bindings of asset::PackedBox
SHARED_CONSTANT kBindViews = 15;               // ViewTriangle: views, cells, coarse views
SHARED_CONSTANT kBindSummedArea = 16;          // of the light: see kConstantExactSums
SHARED_CONSTANT kBindLayers = 17;              // LayerHeader, then uvec2[layer][sample]: triangle + 1, alpha
SHARED_CONSTANT kBindLayerDepths = 18;         // floats[2][sample]: of the opaque triangle, of the last layer
SHARED_CONSTANT kBindVisibilityMaps = 19;      // by record the place of its map or kAbsent, then maps
SHARED_CONSTANT kBindVisible = 20;             // VisibleHeader, then record indices
SHARED_CONSTANT kBindMarks = 21;               // one word a record
SHARED_CONSTANT kBindShaded = 22;              // kShadedRadiances vec4 a record, then see below
SHARED_CONSTANT kBindTables = 23;              // floats: see kTable... below
SHARED_CONSTANT kBindBackground = 24;          // environment image, RGB floats
SHARED_CONSTANT kBindPicture = 25;             // RGBA floats of one image tile
SHARED_CONSTANT kBindMaterialExtensions = 26;  // asset::MaterialExtension
SHARED_CONSTANT kBindTextureTransforms = 27;   // asset::TextureTransform
SHARED_CONSTANT kBindBlended = 28;             // indices of the blended triangles, ascending
SHARED_CONSTANT kBindMoments = 29;             // of the light: see kMomentColumns
SHARED_CONSTANT kBufferBindings = 30;
SHARED_CONSTANT kBindVisibility = 30;  // r32ui image: triangle + 1, or 0
// What shading reads most, once more as texel buffers, which lavapipe reads in a third of the time.
SHARED_CONSTANT kBindTableTexels = 31;   // kBindTables
SHARED_CONSTANT kBindLightTexels = 32;   // kBindSummedArea
SHARED_CONSTANT kBindMapTexels = 33;     // kBindVisibilityMaps
SHARED_CONSTANT kBindMomentTexels = 34;  // kBindMoments

// Bindings of the passes that make the light's table, in a set of their own.
SHARED_CONSTANT kLightConstants = 0;   // LightConstants
SHARED_CONSTANT kLightImage = 1;       // the environment, RGB floats
SHARED_CONSTANT kLightTables = 2;      // floats: shares of AxisCover, or TiltTables
SHARED_CONSTANT kLightCovers = 3;      // AxisCover::Texel of every column, then of every row of the map
SHARED_CONSTANT kLightMap = 4;         // RGB floats
SHARED_CONSTANT kLightRowFactors = 5;  // one float a row
SHARED_CONSTANT kLightRowSums = 6;     // RowSum
SHARED_CONSTANT kLightEntries = 7;     // the table: kBindSummedArea of the frame
SHARED_CONSTANT kLightHighlights = 8;  // Highlight
SHARED_CONSTANT kMomentConstants = 9;  // MomentConstants
SHARED_CONSTANT kMomentCovers = 10;    // MomentCover::Texel of every column, then of every row of the lattice
SHARED_CONSTANT kMomentWeights = 11;   // floats: three a column's share, then two a row's
SHARED_CONSTANT kMomentTexels =
    12;  // floats[axis][row][column][channel] in units of the table, then the sum of their squares
SHARED_CONSTANT kMomentCells = 13;  // vec4[cell][axis]: moments of R, G, B and of a light of 1
SHARED_CONSTANT kMomentTable = 14;  // kBindMoments of the frame

// Bindings of the window's own set.
SHARED_CONSTANT kBindShown = 0;    // linear RGBA, premultiplied, vec4[shownSize]
SHARED_CONSTANT kBindTruth = 1;    // the same of the truth, vec4[truthSize]
SHARED_CONSTANT kBindDisplay = 2;  // sRGB as RGBA8, uint[size]

// Specialisation constants of every shader that looks at surfaces or kernels: what an asset does not have is
// not compiled in.
SHARED_CONSTANT kConstantGlossy = 0;         // any glossy kernel
SHARED_CONSTANT kConstantBackground = 1;     // the environment behind the object
SHARED_CONSTANT kConstantTextured = 2;       // any texture
SHARED_CONSTANT kConstantTransformed = 3;    // any transformed texture
SHARED_CONSTANT kConstantColored = 4;        // any vertex colour
SHARED_CONSTANT kConstantMasked = 5;         // any asset::kAlphaMask
SHARED_CONSTANT kConstantExtended = 6;       // any asset::MaterialExtension
SHARED_CONSTANT kConstantClearcoat = 7;      // any material with a coat
SHARED_CONSTANT kConstantSheen = 8;          // ... with sheen
SHARED_CONSTANT kConstantOtherSide = 9;      // ... with diffuse transmission
SHARED_CONSTANT kConstantFilm = 10;          // ... with iridescence
SHARED_CONSTANT kConstantLayers = 11;        // blended layers at most, 0 without asset::kAlphaBlend
SHARED_CONSTANT kConstantNormalMapped = 12;  // any normal map of a base layer
SHARED_CONSTANT kConstantSplit = 13;         // any asset::kSplitLobe
SHARED_CONSTANT kConstantExactSums = 14;     // of the light's table: 64-bit prefixes, not 42-bit ones
SHARED_CONSTANT kConstantCells = 15;         // any asset::kDirectionCells
SHARED_CONSTANT kConstantBoxPools = 16;      // that resident pages fill
SHARED_CONSTANT kConstantEmitters = 17;      // has any resident kernel emitted radiance?
SHARED_CONSTANT kConstantWeights = 18;  // between the views boxes have the mean weight, not the mean energy
SHARED_CONSTANT kConstantLambert = 19;  // any Lambert kernel
SHARED_CONSTANT kConstantLevels = 20;   // coarser levels of the atlas
SHARED_CONSTANT kSurfaceConstants = 21;
SHARED_CONSTANT kConstantTexelBuffers = 31;  // of every shader: the device has large texel buffers

// Tables of floats, one after another: A and B of the specular albedo [n.v][roughness], S of the diffuse
// Fresnel factor [n.v], the linear values of the 256 sRGB codes, the cells of round lobes and of streaks
// (each area, spread, and of every sample cosine and sine of phi and 1 - random.y), and, where anything has a
// sheen, its albedo [n.v][roughness].
SHARED_CONSTANT kAlbedoNodes = 64;
SHARED_CONSTANT kTableFresnel = 2 * kAlbedoNodes * kAlbedoNodes;
SHARED_CONSTANT kTableSrgb = kTableFresnel + kAlbedoNodes;
SHARED_CONSTANT kLobeBoxes = 18;
SHARED_CONSTANT kLobeSamples = 4;  // of each
SHARED_CONSTANT kLobeCellFloats = 2 + 3 * kLobeSamples;
SHARED_CONSTANT kTableRoundCells = kTableSrgb + 256;
SHARED_CONSTANT kTableStripCells = kTableRoundCells + kLobeBoxes * kLobeCellFloats;
SHARED_CONSTANT kTableSheen = kTableStripCells + kLobeBoxes * kLobeCellFloats;

// Before the rows of a visibility map (shaders/visibility_maps.glsl): a bit for each block of 8 x 8 cells
// that has hidden ones, and a byte for the visible part of each quarter of a block.
SHARED_CONSTANT kMapBlockWords = 4;
SHARED_CONSTANT kMapQuarterWords = 128;

// Shaded records: two vec4 of each, diffuse and glossy, whose a is the hidden part that it stands for where
// the record's lobe is split; then, where anything has a normal map, three of each: how diffuse R, G and B
// change with the normal.
SHARED_CONSTANT kShadedRadiances = 2;
SHARED_CONSTANT kShadedGradients = 3;

SHARED_CONSTANT kMaxBoxPools = 4;
SHARED_CONSTANT kGroupSize = 64;  // threads of every linear dispatch
SHARED_CONSTANT kPixelGroup = 8;  // threads each way of every dispatch over an image
SHARED_CONSTANT kAbsent = 0xFFFFFFFFu;

// Of the atlas around a place: four of one level, or of each of two that are mixed.
SHARED_CONSTANT kMaxCorners = 8;

// Marks of texel records. On the list, kLambertOnly is set where kMarkSeen is not.
SHARED_CONSTANT kMarkSeen = 1u;
SHARED_CONSTANT kMarkLambert = 2u;  // needed by the other side, which lets diffuse light through
SHARED_CONSTANT kLambertOnly = 0x80000000u;

// Summed-area table: prefixes are summed with kGuardBits below the unit that is kept, then rounded to
// kPrefixBits. Exact ones are kept as they are.
SHARED_CONSTANT kGuardBits = 16;
SHARED_CONSTANT kPrefixBits = 42;
SHARED_CONSTANT kSegments = 8;  // of a column, summed side by side (sat_columns_groups.comp)

// Moments of the light (common/light/moment_cover.h): uvec4[lattice row][lattice column][axis], of which R, G
// and B are sums over the texels above and left, modulo 2^32, of the light times that component of its
// direction; then uvec4[node][axis], floats: the moments of a hemisphere and that component of its normal.
SHARED_CONSTANT kMomentColumns = 256;
SHARED_CONSTANT kMomentRows = 128;
SHARED_CONSTANT kMomentStride = kMomentColumns + 1;
SHARED_CONSTANT kHorizonColumns = 48;
SHARED_CONSTANT kHorizonRows = 25;
SHARED_CONSTANT kHorizonNodeCount = kHorizonColumns * kHorizonRows;
SHARED_CONSTANT kHorizonCellColumns = 32;
SHARED_CONSTANT kHorizonCellRows = 16;
SHARED_CONSTANT kHorizonCellCount = kHorizonCellColumns * kHorizonCellRows;
SHARED_CONSTANT kMomentNodes = 3 * kMomentStride * (kMomentRows + 1);  // place of the first
// Then the number of bright texels (bright_texels.h), which nodes and trees leave out, and
// uvec4[bright][axis]: their sums, and as w the horizon cell that they lie in, column and row on the
// lattice.
SHARED_CONSTANT kBrightTexels = 32;
SHARED_CONSTANT kMomentBright = kMomentNodes + 3 * kHorizonNodeCount;
// Then the cells of the light's trees (common/light/light_tree.h), LightCell: uvec4[cell][axis], floats:
// light of R, G, B and a light of 1.
SHARED_CONSTANT kTreeRoots = 88;
SHARED_CONSTANT kTreeLevels = 5;
SHARED_CONSTANT kTreeLeaves = 256;  // of each
SHARED_CONSTANT kTreeCells = kTreeRoots * 341;
SHARED_CONSTANT kMomentTree = kMomentBright + 1 + 3 * kBrightTexels;
SHARED_CONSTANT kMomentEnd = kMomentTree + 3 * kTreeCells;
SHARED_CONSTANT kMomentSquares = 9 * kMomentColumns * kMomentRows;  // place among the lattice's texels

struct FrameConstants {
  vec4 eye;           // xyz; w = distance of the near plane
  vec4 right;         // unit, divided by tan(half the horizontal field of view)
  vec4 up;            // unit, divided by tan(half the vertical field of view)
  vec4 forward;       // unit
  vec4 rayRight;      // unit, times tan(half the horizontal field of view)
  vec4 rayUp;         // unit, times tan(half the vertical field of view)
  uvec2 imageSize;    // pixels
  uint samples;       // visibility samples of a pixel, each way
  uint boxLimit;      // boxes evaluated of each kernel at most
  uvec2 lightSize;    // of the light map
  float lightUnit;    // radiance times steradian of one unit of the summed-area table, times the intensity
  float lightOffset;  // in u: the environment's rotation
  uvec2 backgroundSize;
  uvec2 atlasSize;
  uint recordCount, tileCount, diffuseStream, atlasLevels;  // the streams of cells follow the diffuse one
  vec4 toEnvironment[3];  // columns: from directions of the world to those of the image, for the background
  float lightIntensity;   // of the background; lightUnit has it
  uint cellTriangles;     // behind those of the views
  float momentUnit;       // radiance times steradian of one unit of the moments, times the intensity
  uint reserved;
  uvec4 sphereStart, sphereTriangles;  // of the spheres of views, by the number that records have
};

// A rectangle of the picture, in pixels.
struct ImageTile {
  uvec2 origin, size;
};

// What the passes over an image tile are told.
struct TilePush {
  ImageTile tile;
  uint layers;    // drawn so far: the index of the one to draw, or the number to look at
  uint firstRow;  // of the tile's pixels to resolve
};

// What the window shows.
struct DisplayPush {
  uvec2 size;       // of the window, pixels
  uvec2 shownSize;  // of the picture
  uvec2 truthSize;
  uint toneMap;  // ToneMap
  uint split;    // columns from here on show the truth
  float gain;    // 2^exposure
};

// Before the layers: `found` counts the samples of the last one (layer_count.comp).
struct LayerHeader {
  uint found;
  uint reserved[3];
};

struct TextureHeader {
  uint firstLevel, levelCount;
  uint wrapS, wrapT;  // asset::Wrap
  uint srgb, magNearest, minFilter, reserved;
};

struct TextureLevel {
  uint firstTexel, width, height, reserved;
};

// A texel record as the shading pass sees it.
struct GpuRecord {
  vec3 position;
  uint tile;
  vec3 normal;
  uint slot;  // index in its tile, and the flags below
};
SHARED_CONSTANT kRecordSlot = 63u;
SHARED_CONSTANT kRecordSphereShift = 8;         // two bits from here on: asset::viewSphereOf
SHARED_CONSTANT kRecordHasCells = 0x80000000u;  // asset::kDirectionCells

// A resident page: its boxes start at `firstBox` of pool `pool`; an absent page has an empty mask.
struct PageSlot {
  uint maskLow, maskHigh;
  uint firstBox, pool;
};

// A triangle of the view sphere or the sphere of cells. With row k = cross of the two other corners,
// dot(direction, row k) is proportional to the barycentric weight of corner k; neighbour k lies across the
// edge opposite to it.
struct ViewTriangle {
  vec4 rows[3];
  uvec4 view;
  uvec4 neighbour;
};

// 64-bit sums of R, G, B as low and high words.
struct RowSum {
  uint low[3];
  uint high[3];
};

// What the passes that make the light's table work on.
struct LightConstants {
  uvec2 imageSize, mapSize;
  vec4 toImage[3];  // columns of untilt() (environment_tilt.h)
  vec4 ceiling;     // RGB: what samples read of a texel at most
  uint samplesPerAxis, highlightCount;
  uint columnShares;  // of the level map: places in the tables before those of rows
  uint reserved;
};

// What the passes that make the moments work on.
struct MomentConstants {
  uvec2 mapSize;      // of the light map
  float perUnit;      // units of the table in a radiance times steradian
  uint rowShares;     // of the weights: place of the first row's
  float leastSquare;  // of a bright texel, in units of the table
  uint reserved;
};

struct VisibleHeader {
  uint groups[3];  // for dispatchIndirect
  uint count;
};

#ifdef __cplusplus
static_assert(sizeof(FrameConstants) == 256 && sizeof(ViewTriangle) == 80 && sizeof(RowSum) == 24 &&
              sizeof(LightConstants) == 96);
}  // namespace boxlight::gpu
#endif
#undef SHARED_CONSTANT
#endif
