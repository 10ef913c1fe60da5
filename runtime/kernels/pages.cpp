// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/pages.h"

#include <atomic>
#include <bit>
#include <cassert>
#include <exception>
#include <functional>
#include <numeric>
#include <thread>

#include "common/base/error.h"
#include "common/light/relight.h"

namespace boxlight::gpu {
namespace {

uint32_t tileOf(const asset::Asset& asset, uint32_t record) {
  const auto after =
      std::upper_bound(asset.tiles.begin(), asset.tiles.end(), record,
                       [](uint32_t r, const asset::Tile& tile) { return r < tile.firstRecord; });
  return uint32_t(after - asset.tiles.begin()) - 1;
}

bool isLoaded(const PageSlot& slot) { return (slot.maskLow | slot.maskHigh) != 0; }

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

constexpr double mebibytes(uint64_t bytes) { return double(bytes) / double(1 << 20); }

uint64_t sum(const std::vector<uint64_t>& values) {
  return std::accumulate(values.begin(), values.end(), uint64_t(0));
}

}  // namespace

ResidentPages::ResidentPages(Device& device, Bindings& bindings, const asset::AssetReader& reader,
                             uint64_t poolBytes, int threads)
    : device_(device),
      bindings_(bindings),
      reader_(reader),
      poolCapacity_(std::min(poolBytes, device.limits().maxStorageBufferRange) / sizeof(PackedBox)),
      threads_(threads),
      lambertEmits_(reader.asset().tiles.size()),
      glossyEmits_(reader.asset().tiles.size()),
      slots_(reader.asset().streamMasks.size()),
      table_(device, "page table", uint64_t(slots_.size()) * sizeof(PageSlot)) {
  bindings.set(kBindPageTable, table_);
}

PageSlot& ResidentPages::slot(Page page) {
  return slots_[page.stream * reader_.asset().tiles.size() + page.tile];
}

uint64_t ResidentPages::boxesOf(Page page) const {
  const auto& asset = reader_.asset();
  return uint64_t(std::popcount(asset.mask(page.stream, page.tile))) *
         asset.boxesPerKernel(page.stream, page.tile);
}

/// Ascending by stream, then tile.
std::vector<ResidentPages::Page> ResidentPages::neededPages(std::span<const VisibleRecord> visible,
                                                            vec3 eye) const {
  const auto& asset = reader_.asset();
  const size_t tileCount = asset.tiles.size();
  std::vector<bool> needed(asset.streamCount() * tileCount), allCells(tileCount);
  const std::vector<ViewSphere> spheres = viewSpheresOf(asset);
  std::vector<uint32_t> near(spheres.size());  // where the walks over the view triangles start
  for (const auto& [r, glossy] : visible) {
    const uint32_t tile = tileOf(asset, r);
    needed[asset.diffuseStream() * tileCount + tile] = true;
    if (!glossy || asset.tiles[tile].glossyBoxes == 0) continue;
    if (asset.hasCells(r)) {
      allCells[tile] = true;
      continue;
    }
    const auto& p = asset.records[r].position;
    const auto& n = asset.records[r].normal;
    const vec3 normal(n[0], n[1], n[2]), towards = eye - vec3(p[0], p[1], p[2]);
    const float distance = glm::length(towards);
    const vec3 view = distance > 0.0f ? towards / distance : normal;
    const uint32_t sphere = asset.viewSphere(r);
    const ViewBlend blend = spheres[sphere].locate(raiseAboveHorizon(view, normal), near[sphere]);
    near[sphere] = blend.triangle;
    for (const uint32_t v : blend.view) needed[v * tileCount + tile] = true;
  }
  // Where a pixel's lobe points is for its normal map to say: all cells of its tile may be read.
  for (uint32_t cell = 0; cell < asset.cellCount(); ++cell)
    for (uint32_t tile = 0; tile < tileCount; ++tile)
      if (allCells[tile]) needed[(asset.firstCellStream() + cell) * tileCount + tile] = true;
  std::vector<Page> pages;
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < tileCount; ++tile)
      if (needed[stream * tileCount + tile] && asset.mask(stream, tile) != 0) pages.push_back({stream, tile});
  return pages;
}

void ResidentPages::forget() {
  std::fill(slots_.begin(), slots_.end(), PageSlot{});
  for (Pool& pool : pools_) pool.boxes = 0;
  pageCount_ = 0;
}

/// A place in a pool for every page, pool after pool, behind what is there. Returns the number of boxes in
/// each pool.
std::vector<uint64_t> ResidentPages::place(const std::vector<Page>& pages) {
  std::vector<uint64_t> used;
  for (const Pool& pool : pools_) used.push_back(pool.boxes);
  while (used.size() > 1 && used.back() == 0) used.pop_back();
  if (used.empty()) used.push_back(0);
  for (const Page page : pages) {
    const uint64_t boxes = boxesOf(page), mask = reader_.asset().mask(page.stream, page.tile);
    if (used.back() + boxes > poolCapacity_) used.push_back(0);
    slot(page) = {uint32_t(mask), uint32_t(mask >> 32), uint32_t(used.back()), uint32_t(used.size() - 1)};
    used.back() += boxes;
  }
  return used;
}

void ResidentPages::requireFit(const std::vector<uint64_t>& used) const {
  if (used.size() <= kMaxBoxPools) return;
  fail(ExitCode::runtime,
       "{}: this view needs {:.1f} MiB of boxes, but {} storage buffers of {:.1f} MiB are all that '{}' "
       "binds; bake with fewer boxes{} or a smaller atlas, or choose another device",
       reader_.path().string(), mebibytes(sum(used) * sizeof(PackedBox)), kMaxBoxPools,
       mebibytes(poolCapacity_ * sizeof(PackedBox)), device_.info().name,
       reader_.asset().cellCount() > 0 ? ", fewer direction cells" : "");
}

void ResidentPages::noteEmission(Page page, const PackedBox& first) {
  if (isEmission(first))
    (page.stream == reader_.asset().diffuseStream() ? lambertEmits_ : glossyEmits_)[page.tile] = 1;
}

void ResidentPages::require(std::span<const VisibleRecord> visible, vec3 eye) {
  const std::vector<Page> needed = neededPages(visible, eye);
  std::vector<Page> missing;
  for (const Page page : needed)
    if (!isLoaded(slot(page))) missing.push_back(page);
  if (missing.empty() && !pools_.empty()) return;
  std::vector<uint64_t> used = place(missing);
  if (pageCount_ > 0 && (used.size() > kMaxBoxPools || sum(used) * sizeof(PackedBox) > kKeptBytes)) {
    forget();
    missing = needed;
    used = place(missing);
  }
  requireFit(used);
  while (pools_.size() < used.size()) pools_.push_back({Buffer(device_, "box pages", 0)});
  load(missing);
}

void ResidentPages::load(const std::vector<Page>& pages) {
  std::vector<uint64_t> first, fresh(pools_.size());
  for (const Pool& pool : pools_) first.push_back(pool.boxes);
  for (const Page page : pages) fresh[slot(page).pool] += boxesOf(page);
  std::vector<std::vector<PackedBox>> boxes;
  for (const uint64_t count : fresh) boxes.emplace_back(count);
  parallelFor(pages.size(), threads_, [&](size_t i) {
    const PageSlot& place = slot(pages[i]);
    const std::vector<PackedBox> page = reader_.page(pages[i].stream, pages[i].tile);
    assert(page.size() == boxesOf(pages[i]));
    std::copy(page.begin(), page.end(), boxes[place.pool].begin() + (place.firstBox - first[place.pool]));
  });
  for (const Page page : pages) {
    const PageSlot& place = slot(page);
    noteEmission(page, boxes[place.pool][place.firstBox - first[place.pool]]);
  }
  for (uint32_t p = 0; p < pools_.size(); ++p) {
    Pool& pool = pools_[p];
    pool.boxes += fresh[p];
    const uint64_t bytes = pool.boxes * sizeof(PackedBox);
    if (bytes > pool.buffer.size()) {  // exact at first, then with room for what the camera will see
      const uint64_t room = first[p] == 0 ? bytes : std::max(bytes, bytes + bytes / 2);
      grow(device_, pool.buffer, "box pages", std::min(room, poolCapacity_ * sizeof(PackedBox)));
    }
    upload(device_, pool.buffer, std::as_bytes(std::span(boxes[p])), first[p] * sizeof(PackedBox));
    bindings_.set(kBindBoxPools + p, pool.buffer);
  }
  upload(device_, table_, std::as_bytes(std::span(slots_)));
  pageCount_ += uint32_t(pages.size());
}

uint64_t ResidentPages::bytes() const {
  uint64_t total = 0;
  for (const Pool& pool : pools_) total += pool.buffer.size();
  return total;
}

bool ResidentPages::emitters() const {
  const auto any = [](const std::vector<uint8_t>& tiles) {
    return std::find(tiles.begin(), tiles.end(), 1) != tiles.end();
  };
  return any(lambertEmits_) || any(glossyEmits_);
}

uint64_t ResidentPages::countBoxes(std::span<const VisibleRecord> visible, uint32_t boxLimit) const {
  const auto& asset = reader_.asset();
  uint64_t boxes = 0;
  for (const auto& [record, glossy] : visible) {
    const uint32_t t = tileOf(asset, record);
    boxes += std::min(asset.tiles[t].diffuseBoxes - lambertEmits_[t], boxLimit);
    if (!glossy || asset.hasCells(record)) continue;
    const uint32_t slots = asset.tiles[t].glossyBoxes - glossyEmits_[t];
    boxes += asset.isSplit(record) ? 3 * std::min(slots - 1, boxLimit) : std::min(slots, boxLimit);
  }
  return boxes;
}

}  // namespace boxlight::gpu
