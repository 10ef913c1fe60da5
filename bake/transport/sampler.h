// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "common/base/math.h"

namespace boxlight {

/// Names one set of paths; every random number is a function of it, the path's index and the dimension, never
/// of the thread. A stream is a view, the shared Lambert set, or a picture.
struct StreamKey {
  uint64_t seed = 0;
  uint32_t texel = 0;
  uint32_t stream = 0;
};

/// Counter-based random numbers of one path. The first kStratifiedPairs calls of next2 draw from an
/// Owen-scrambled (0,2)-sequence over the paths of the stream, so that any power of two of them is stratified
/// in every pair; later ones are hashes. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
class Sampler {
 public:
  static constexpr uint32_t kStratifiedPairs = 5;

  Sampler(const StreamKey& key, uint32_t path);

  float next();  ///< [0,1), independent
  vec2 next2();  ///< [0,1)^2

 private:
  uint64_t streamHash_, pathHash_;
  uint32_t path_;
  uint32_t pair_ = 0;
  uint32_t counter_ = 0;
};

}  // namespace boxlight
