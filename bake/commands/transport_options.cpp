// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/transport_options.h"

#include "common/base/log.h"

namespace boxlight {

void TransportOptions::applyTo(Scene& scene) const {
  if (ggx != "multi") return;
  for (asset::Material& material : scene.materials) material.flags |= asset::kMultipleScattering;
  scene.materialExtensions.resize(scene.materials.size());
}

void TransportOptions::reportRemoved(double part) const {
  if (fireflyLimit > 0.0f)
    log().info("--firefly-limit {} removed {:.3g} % of the light", fireflyLimit, 100 * part);
}

void addTransportOptions(CLI::App& command, TransportOptions& options, const char* aboutLimit) {
  command
      .add_option("--bounces", options.bounces,
                  "Surface interactions of a path at most; 0 = no limit but Russian roulette")
      ->capture_default_str();
  command
      .add_option("--ggx", options.ggx, "Rough GGX with single scattering (glTF) or with the energy it loses")
      ->check(CLI::IsMember({"single", "multi"}))
      ->capture_default_str();
  command.add_option("--firefly-limit", options.fireflyLimit, aboutLimit)
      ->check(inRange(0, 1e30))
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Seed of the random numbers")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace boxlight
