// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/rectangle_pack.h"

#include <stb/stb_rect_pack.h>

namespace {

/// The library sorts with qsort, which may order equal rectangles as it likes.
void sortRectangles(stbrp_rect* first, size_t count, int (*compare)(const void*, const void*)) {
  std::stable_sort(first, first + count,
                   [compare](const stbrp_rect& a, const stbrp_rect& b) { return compare(&a, &b) < 0; });
}

}  // namespace

#define STBRP_SORT(first, count, size, compare) sortRectangles(first, size_t(count), compare)
#define STBRP_STATIC
#define STB_RECT_PACK_IMPLEMENTATION
#include <stb/stb_rect_pack.h>

namespace boxlight {

bool packRectangles(std::vector<PackedRectangle>& rectangles, int side) {
  std::vector<stbrp_rect> rects(rectangles.size());
  for (size_t i = 0; i < rects.size(); ++i) {
    rects[i].id = int(i);
    rects[i].w = rectangles[i].size.x;
    rects[i].h = rectangles[i].size.y;
  }
  std::vector<stbrp_node> nodes(static_cast<size_t>(side));
  stbrp_context context;
  stbrp_init_target(&context, side, side, nodes.data(), side);
  if (!stbrp_pack_rects(&context, rects.data(), int(rects.size()))) return false;
  for (size_t i = 0; i < rects.size(); ++i) rectangles[i].corner = {rects[i].x, rects[i].y};
  return true;
}

}  // namespace boxlight
