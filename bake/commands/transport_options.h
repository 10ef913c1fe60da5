// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "bake/scene/scene.h"
#include "bake/transport/scatter.h"
#include "common/base/cli.h"

namespace boxlight {

/// What `bake` and `render` mean alike by light transport.
struct TransportOptions {
  uint32_t bounces = 0;  ///< 0: no limit but Russian roulette
  std::string ggx = "single";
  float fireflyLimit = 0;  ///< 0: no limit
  uint64_t seed = 0;

  uint32_t bounceLimit() const { return bounces ? bounces : kUnlimitedBounces; }
  float energyLimit() const {
    return fireflyLimit > 0.0f ? fireflyLimit : std::numeric_limits<float>::infinity();
  }
  /// Marks the scene's materials for --ggx multi.
  void applyTo(Scene& scene) const;
  /// Says what --firefly-limit has cost, if it is set.
  void reportRemoved(double part) const;
};

void addTransportOptions(CLI::App& command, TransportOptions& options, const char* aboutLimit);

}  // namespace boxlight
