// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/pages.h"

#include <atomic>
#include <bit>
#include <cassert>
#include <exception>
#include <functional>
#include <thread>

#include "common/base/error.h"
#include "common/light/view_sphere.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

struct Page {
  uint32_t stream, tile;
};

uint32_t tileOf(const asset::Asset& asset, uint32_t record) {
  const auto after =
      std::upper_bound(asset.tiles.begin(), asset.tiles.end(), record,
                       [](uint32_t r, const asset::Tile& tile) { return r < tile.firstRecord; });
  return uint32_t(after - asset.tiles.begin()) - 1;
}

/// Ascending by stream, then tile.
std::vector<Page> neededPages(const asset::Asset& asset, std::span<const VisibleRecord> visible, vec3 eye) {
  const size_t tileCount = asset.tiles.size();
  std::vector<bool> needed(asset.streamCount() * tileCount);
  const ViewSphere sphere(asset.info.viewFrequency);
  uint32_t near = 0;  // where the walk over the view triangles starts
  for (const auto& [r, glossy] : visible) {
    const uint32_t tile = tileOf(asset, r);
    needed[asset.diffuseStream() * tileCount + tile] = true;
    if (!glossy || asset.tiles[tile].glossyBoxes == 0) continue;
    const auto& p = asset.records[r].position;
    const auto& n = asset.records[r].normal;
    const vec3 normal(n[0], n[1], n[2]), towards = eye - vec3(p[0], p[1], p[2]);
    const float distance = glm::length(towards);
    const vec3 view = distance > 0.0f ? towards / distance : normal;
    const ViewBlend blend = sphere.locate(raiseAboveHorizon(view, normal), near);
    near = blend.triangle;
    for (const uint32_t v : blend.view) needed[v * tileCount + tile] = true;
  }
  std::vector<Page> pages;
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < tileCount; ++tile)
      if (needed[stream * tileCount + tile] && asset.mask(stream, tile) != 0) pages.push_back({stream, tile});
  return pages;
}

uint32_t boxesOf(const asset::Asset& asset, Page page) {
  return uint32_t(std::popcount(asset.mask(page.stream, page.tile))) *
         asset.boxesPerKernel(page.stream, page.tile);
}

/// A place in a pool for every page, pool after pool. Returns the number of boxes in each pool.
std::vector<uint64_t> placePages(const asset::Asset& asset, const std::vector<Page>& pages,
                                 uint64_t poolCapacity, std::vector<PageSlot>& table) {
  std::vector<uint64_t> used(1, 0);
  for (const Page page : pages) {
    const uint64_t boxes = boxesOf(asset, page);
    if (used.back() + boxes > poolCapacity) used.push_back(0);
    const uint64_t mask = asset.mask(page.stream, page.tile);
    table[page.stream * asset.tiles.size() + page.tile] = {uint32_t(mask), uint32_t(mask >> 32),
                                                           uint32_t(used.back()), uint32_t(used.size() - 1)};
    used.back() += boxes;
  }
  return used;
}

/// Calls `action(i)` for i below `count` from several threads; rethrows the first exception.
void parallelFor(size_t count, int threads, const std::function<void(size_t)>& action) {
  std::atomic<size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto work = [&] {
    for (size_t i = next++; i < count && !failed; i = next++) {
      try {
        action(i);
      } catch (...) {
        if (!failed.exchange(true)) failure = std::current_exception();
      }
    }
  };
  const size_t wanted = threads > 0 ? size_t(threads) : std::max(std::thread::hardware_concurrency(), 1u);
  std::vector<std::jthread> others(std::min(wanted, std::max<size_t>(count, 1)) - 1);
  for (auto& thread : others) thread = std::jthread(work);
  work();
  others.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

std::vector<std::vector<PackedBox>> readPages(const asset::AssetReader& reader,
                                              const std::vector<Page>& pages,
                                              const std::vector<PageSlot>& table,
                                              const std::vector<uint64_t>& used, int threads) {
  std::vector<std::vector<PackedBox>> pools;
  for (const uint64_t boxes : used) pools.emplace_back(boxes);
  parallelFor(pages.size(), threads, [&](size_t i) {
    const Page page = pages[i];
    const PageSlot& slot = table[page.stream * reader.asset().tiles.size() + page.tile];
    const std::vector<PackedBox> boxes = reader.page(page.stream, page.tile);
    assert(boxes.size() == boxesOf(reader.asset(), page));
    std::copy(boxes.begin(), boxes.end(), pools[slot.pool].begin() + slot.firstBox);
  });
  return pools;
}

constexpr double mebibytes(uint64_t bytes) { return double(bytes) / double(1 << 20); }

void requireFit(const Device& device, const asset::AssetReader& reader, const std::vector<uint64_t>& used,
                uint64_t poolBytes) {
  if (used.size() <= kMaxBoxPools) return;
  uint64_t boxes = 0;
  for (const uint64_t pool : used) boxes += pool;
  fail(ExitCode::runtime,
       "{}: this view needs {:.1f} MiB of boxes, but {} storage buffers of {:.1f} MiB are all that '{}' "
       "binds; bake with fewer "
       "boxes or a smaller atlas, or choose another device",
       reader.path().string(), mebibytes(boxes * sizeof(PackedBox)), kMaxBoxPools, mebibytes(poolBytes),
       device.info().name);
}

}  // namespace

ResidentPages::ResidentPages(Device& device, Bindings& bindings, const asset::AssetReader& reader,
                             std::span<const VisibleRecord> visible, vec3 eye, uint64_t poolBytes,
                             int threads)
    : lambertEmits_(reader.asset().tiles.size()),
      glossyEmits_(reader.asset().tiles.size()),
      table_(device, "page table", uint64_t(reader.asset().streamMasks.size()) * sizeof(PageSlot)) {
  const auto& asset = reader.asset();
  const std::vector<Page> pages = neededPages(asset, visible, eye);
  std::vector<PageSlot> table(asset.streamMasks.size(), PageSlot{});
  poolBytes = std::min(poolBytes, device.limits().maxStorageBufferRange);
  const auto used = placePages(asset, pages, poolBytes / sizeof(PackedBox), table);
  requireFit(device, reader, used, poolBytes);
  const auto pools = readPages(reader, pages, table, used, threads);
  for (const auto& [stream, tile] : pages) {
    const PageSlot& slot = table[stream * asset.tiles.size() + tile];
    if (!isEmission(pools[slot.pool][slot.firstBox])) continue;
    (stream == asset.diffuseStream() ? lambertEmits_ : glossyEmits_)[tile] = 1;
  }
  for (const auto& boxes : pools) {
    pools_.push_back(makeBuffer(device, "box pages", boxes));
    bindings.set(kBindBoxPools + uint32_t(pools_.size()) - 1, pools_.back());
  }
  upload(device, table_, std::as_bytes(std::span(table)));
  bindings.set(kBindPageTable, table_);
  pageCount_ = uint32_t(pages.size());
}

uint64_t ResidentPages::bytes() const {
  uint64_t total = 0;
  for (const Buffer& pool : pools_) total += pool.size();
  return total;
}

bool ResidentPages::emitters() const {
  const auto any = [](const std::vector<uint8_t>& tiles) {
    return std::find(tiles.begin(), tiles.end(), 1) != tiles.end();
  };
  return any(lambertEmits_) || any(glossyEmits_);
}

uint64_t ResidentPages::countBoxes(const asset::Asset& asset, std::span<const VisibleRecord> visible,
                                   uint32_t boxLimit) const {
  uint64_t boxes = 0;
  for (const auto& [record, glossy] : visible) {
    const uint32_t t = tileOf(asset, record);
    boxes += std::min(asset.tiles[t].diffuseBoxes - lambertEmits_[t], boxLimit);
    if (!glossy) continue;
    const uint32_t slots = asset.tiles[t].glossyBoxes - glossyEmits_[t];
    boxes += asset.isSplit(record) ? 3 * std::min(slots - 1, boxLimit) : std::min(slots, boxLimit);
  }
  return boxes;
}

}  // namespace boxlight::gpu
