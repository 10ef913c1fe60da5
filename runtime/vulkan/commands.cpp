// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/commands.h"

#include <array>
#include <cassert>

#include "runtime/vulkan/native.h"

namespace boxlight::gpu {

struct Commands::Native {
  const Device::Native& device;
  vk::raii::CommandBuffer buffer;
  std::vector<std::string> passes;
};

std::vector<PassTime> Device::run(const std::function<void(Commands&)>& record) {
  return translated("run", [&] {
    const vk::CommandBufferAllocateInfo allocation(*native_->pool, vk::CommandBufferLevel::ePrimary, 1);
    Commands::Native recording{
        *native_, std::move(vk::raii::CommandBuffers(native_->device, allocation).front()), {}};
    recording.buffer.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (native_->timestampBits) recording.buffer.resetQueryPool(*native_->queries, 0, 2 * kMaxPasses);
    Commands commands(recording);
    record(commands);
    recording.buffer.end();
    const vk::CommandBuffer submitted = *recording.buffer;
    native_->queue.submit(vk::SubmitInfo({}, {}, submitted));
    native_->queue.waitIdle();

    std::vector<PassTime> times;
    if (!native_->timestampBits || recording.passes.empty()) return times;
    const auto count = uint32_t(2 * recording.passes.size());
    const auto [result, ticks] =
        native_->queries.getResults<uint64_t>(0, count, count * sizeof(uint64_t), sizeof(uint64_t),
                                              vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    const uint64_t valid =
        native_->timestampBits >= 64 ? ~uint64_t(0) : (uint64_t(1) << native_->timestampBits) - 1;
    for (size_t i = 0; i < recording.passes.size(); ++i) {
      const uint64_t elapsed = (ticks[2 * i + 1] - ticks[2 * i]) & valid;
      times.push_back({recording.passes[i], double(elapsed) * native_->nanosecondsPerTick * 1e-6});
    }
    return times;
  });
}

void Commands::pass(const char* name, const std::function<void()>& commands) {
  const auto first = uint32_t(2 * native_.passes.size());
  assert(first < 2 * kMaxPasses);
  native_.passes.emplace_back(name);
  const auto stamp = [&](uint32_t query) {
    if (native_.device.timestampBits)
      native_.buffer.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *native_.device.queries, query);
  };
  stamp(first);
  commands();
  stamp(first + 1);
}

void Commands::barrier() {
  const vk::MemoryBarrier everything(vk::AccessFlagBits::eMemoryWrite,
                                     vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite);
  native_.buffer.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands,
                                 vk::PipelineStageFlagBits::eAllCommands, {}, everything, {}, {});
}

void Commands::bind(const Bindings& bindings, bool graphics, std::span<const std::byte> push) {
  const auto point = graphics ? vk::PipelineBindPoint::eGraphics : vk::PipelineBindPoint::eCompute;
  const auto& native = bindings.native();
  native_.buffer.bindDescriptorSets(point, native.layout, 0, *native.set, {});
  if (!push.empty())
    native_.buffer.pushConstants<std::byte>(native.layout, vk::ShaderStageFlagBits::eAll, 0, push);
}

void Commands::fill(const Buffer& buffer, uint32_t value) {
  native_.buffer.fillBuffer(*buffer.native().buffer, 0, VK_WHOLE_SIZE, value);
  barrier();
}

void Commands::dispatch(const ComputePipeline& pipeline, uvec3 groups, std::span<const std::byte> push) {
  native_.buffer.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.native().pipeline);
  bind(pipeline.bindings(), false, push);
  native_.buffer.dispatch(groups.x, groups.y, groups.z);
  barrier();
}

void Commands::dispatchIndirect(const ComputePipeline& pipeline, const Buffer& counts, uint64_t offset) {
  native_.buffer.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.native().pipeline);
  bind(pipeline.bindings(), false, {});
  native_.buffer.dispatchIndirect(*counts.native().buffer, offset);
  barrier();
}

namespace {

vk::BufferImageCopy upperLeft(vk::ImageAspectFlagBits aspect, uvec2 extent, uint64_t offset) {
  return {offset, 0, 0, {aspect, 0, 0, 1}, {0, 0, 0}, {extent.x, extent.y, 1}};
}

}  // namespace

void Commands::copySamples(const RasterTarget& target, uvec2 extent, const Buffer& to, uint64_t offset) {
  native_.buffer.copyImageToBuffer(*target.native().color, vk::ImageLayout::eTransferSrcOptimal,
                                   *to.native().buffer,
                                   upperLeft(vk::ImageAspectFlagBits::eColor, extent, offset));
  barrier();
}

void Commands::copyDepth(const RasterTarget& target, uvec2 extent, const Buffer& to, uint64_t offset) {
  native_.buffer.copyImageToBuffer(*target.native().depth, vk::ImageLayout::eTransferSrcOptimal,
                                   *to.native().buffer,
                                   upperLeft(vk::ImageAspectFlagBits::eDepth, extent, offset));
  barrier();
}

void Commands::copyTile(const Buffer& from, const Buffer& to, const ImageTile& tile, uint32_t width) {
  std::vector<vk::BufferCopy> rows;
  const uint64_t bytes = tile.size.x * sizeof(vec4);
  for (uint32_t y = 0; y < tile.size.y; ++y)
    rows.emplace_back(y * bytes, (uint64_t(tile.origin.y + y) * width + tile.origin.x) * sizeof(vec4), bytes);
  native_.buffer.copyBuffer(*from.native().buffer, *to.native().buffer, rows);
  barrier();
}

void Commands::draw(const RasterPipeline& pipeline, const RasterTarget& target, uvec2 extent,
                    uint32_t vertexCount, std::span<const std::byte> push) {
  const vk::Rect2D area({0, 0}, {extent.x, extent.y});
  const std::array<vk::ClearValue, 2> clear = {vk::ClearColorValue(std::array<uint32_t, 4>{}),
                                               vk::ClearDepthStencilValue(0.0f, 0)};
  native_.buffer.beginRenderPass({*target.native().pass, *target.native().framebuffer, area, clear},
                                 vk::SubpassContents::eInline);
  native_.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.native().pipeline);
  bind(pipeline.bindings(), true, push);
  native_.buffer.setViewport(0, vk::Viewport(0, 0, float(extent.x), float(extent.y), 0, 1));
  native_.buffer.setScissor(0, area);
  native_.buffer.draw(vertexCount, 1, 0, 0);
  native_.buffer.endRenderPass();
  barrier();
}

}  // namespace boxlight::gpu
