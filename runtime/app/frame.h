// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "common/image/camera.h"
#include "common/image/image.h"
#include "common/light/relight.h"
#include "runtime/kernels/pages.h"
#include "runtime/light/light.h"
#include "runtime/vulkan/device.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// What a picture depends on beside the asset and the environment.
struct FrameSettings {
  Camera camera;
  float environmentDegrees = 0;  ///< --env-rotation
  EnvironmentTilt environmentTilt;
  float environmentIntensity = 1;  ///< its radiance times this
  uint32_t samples = 2;            ///< visibility samples of a pixel, each way
  uint32_t boxLimit = ~0u;         ///< boxes evaluated of each kernel at most
  uint32_t layerLimit = 8;         ///< blended layers of a sample at most; the farther ones are left out
  Interpolation interpolation = Interpolation::energy;
  uvec2 lightSize{512, 256};  ///< of the light map
  SatScheme satScheme = SatScheme::compact;
  bool background = true;             ///< draw the environment behind the object
  uint32_t tileEdge = 2048;           ///< image tiles are no larger, in pixels
  uint64_t poolBytes = ~uint64_t(0);  ///< storage buffers of boxes are no larger, whatever the device allows
  int threads = 0;                    ///< for reading pages; 0 = all

  bool operator==(const FrameSettings&) const = default;
};

struct FrameCounts {
  uint64_t visibleRecords = 0;
  uint64_t boxes = 0;  ///< integrals of Equation 3 in a frame
  uint64_t pages = 0, pageBytes = 0, sceneBytes = 0;
  double pageMilliseconds = 0;   ///< that frames of this view have waited for pages, wall time
  double lightMilliseconds = 0;  ///< on the device, of the last light map and table
  uint32_t layers = 0;           ///< blended layers drawn, of the image tile with the most
  uint64_t cutLayerSamples = 0;  ///< visibility samples with more layers than the limit
};

/// One asset under an environment from a camera, both of which may change between frames. A frame waits for
/// the pages that its camera needs, so every picture is complete: docs/ptview.md says what a wait costs.
class FrameRenderer {
 public:
  /// Uploads everything, finds what is visible and runs every pass once, so that no later frame waits for a
  /// compiler. `device` and `reader` must outlive it.
  FrameRenderer(Device& device, const asset::AssetReader& reader, const Image& environment,
                const FrameSettings& settings);
  ~FrameRenderer();

  /// Of the frames to come; `poolBytes` and `threads` stay as they are. `environment` must be given with
  /// another `lightSize` or `satScheme`; without it the light stays. Rotation about +Y and intensity cost
  /// nothing; another image or tilt has the table built anew.
  void set(const FrameSettings& settings, const Image* environment = nullptr);
  const FrameSettings& settings() const;

  /// Runs every pass and returns the GPU time of each, in order; those of several image tiles are added up.
  std::vector<PassTime> run();
  /// What run() drew: RGBA, linear, premultiplied, row 0 at the top. Alpha is the part of the pixel that the
  /// object covers, blended layers by their alpha, or 1 with a background.
  const Image& picture() const;

  /// A frame in pieces, for a window that does other work between them: start() does all that comes before
  /// pixels (and builds the light's table if it changed, which is not among the times), then resolve(t) for
  /// each of tiles() leaves that tile's pixels, vec4 row by row, in pixels(); a tile's rows may be resolved a
  /// few at a time, in order, by multiples of kPixelGroup.
  std::vector<PassTime> start();
  std::vector<PassTime> resolve(size_t tile, uint32_t firstRow = 0, uint32_t rows = ~0u);
  const std::vector<ImageTile>& tiles() const;
  const Buffer& pixels() const;

  const FrameCounts& counts() const;
  /// The last frame's texel records, kShadedRadiances vec4 each: diffuse and glossy radiance; with normal
  /// maps then kShadedGradients each. What readVisible does not name means nothing.
  std::vector<vec4> readShaded() const;
  std::vector<VisibleRecord> readVisible() const;
  const Light& light() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace boxlight::gpu
