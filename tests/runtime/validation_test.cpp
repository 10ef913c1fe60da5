// SPDX-License-Identifier: Apache-2.0
// Every test of the runtime demands silence of the validation layer: here it is made to speak.
#include <gtest/gtest.h>

#include "runtime/vulkan/native.h"

using namespace boxlight;

TEST(Validation, AMistakeIsHeardAndIsAFailure) {
  gpu::Device device({"", true});
  const auto log = device.validationLog();
  EXPECT_NO_THROW(gpu::requireSilence(*log));
  try {
    const vk::raii::Buffer empty(device.native().device,
                                 vk::BufferCreateInfo{{}, 0, vk::BufferUsageFlagBits::eStorageBuffer});
  } catch (const vk::Error&) {
    // a driver may refuse it, too
  }
  EXPECT_THROW(gpu::requireSilence(*log), Error);
}
