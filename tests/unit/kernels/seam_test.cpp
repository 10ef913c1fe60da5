// SPDX-License-Identifier: Apache-2.0
// What the eye sees at the border of two charts: the radiance that each side filters from its own texels, at
// the same point of a smooth surface, where the truth has no jump at all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

#include "bake/kernels/scene_bake.h"
#include "bake/scene/atlas.h"
#include "common/light/light_domain.h"
#include "common/light/relight.h"
#include "tests/support/kernel_lab.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

/// Root of the mean square, and the largest.
struct Rms {
  double sum = 0, most = 0;
  size_t count = 0;
  void add(double x) {
    sum += x * x;
    most = std::max(most, std::abs(x));
    ++count;
  }
  double value() const { return std::sqrt(sum / double(count)); }
};

class ChartedSphere {
 public:
  ChartedSphere() : scene(test::makeScene(test::lambert())), table(lab::tableOf(light)) {
    test::addSphere(scene, vec3(0), 1, 48);
    chooseAtlas(scene, {kSize, AtlasSource::chart});
    map = makeTexels(scene, kSize, kSize);
    const Intersector world(scene);
    baked =
        bakeScene(world, map, planRecords(world, map), ViewSphere(1), {32, 8, {}, 1}, ProgressStyle::none);
    const size_t tiles = baked.asset.tiles.size();
    Relighter relighter(baked.asset, [this, tiles](uint32_t stream, uint32_t tile) {
      return baked.pages[stream * tiles + tile];
    });
    constexpr int kRows = 96;
    for (int i = 0; i < 2 * kRows * kRows; ++i) {
      const vec2 uv((float(i % (2 * kRows)) + 0.5f) / (2 * kRows), (float(i / (2 * kRows)) + 0.5f) / kRows);
      const vec3 d = uvToDirection(uv);
      // Radiance times the cell, (pi / rows)^2 sin theta, over pi.
      quadrature.emplace_back(
          d, double(light(d).y) * std::sin(kPiDouble * double(uv.y)) * kPiDouble / kRows / kRows);
    }
    for (uint32_t r = 0; r < baked.asset.records.size(); ++r)
      radiance.push_back(relighter.relight(r, vec3(0, 0, 9), table).diffuse.y);
  }

  /// As shaders/resolve.comp does it.
  double filtered(dvec2 uv) const {
    const dvec2 at = uv * double(kSize) - 0.5, corner = glm::floor(at), f = at - corner;
    double sum = 0, total = 0;
    for (int k = 0; k < 4; ++k) {
      const ivec2 offset(k & 1, k >> 1),
          texel = glm::clamp(ivec2(corner) + offset, ivec2(0), ivec2(kSize - 1));
      const uint32_t record = baked.asset.atlas[size_t(texel.y) * kSize + size_t(texel.x)].front;
      if (record == asset::kNone) continue;
      const double weight = (offset.x ? f.x : 1 - f.x) * (offset.y ? f.y : 1 - f.y);
      sum += weight * radiance[record];
      total += weight;
    }
    return sum / total;
  }

  /// Mean radiance under the cosine of the normal, by quadrature: the sphere is convex.
  double truth(vec3 normal) const {
    double sum = 0;
    for (const auto& [direction, weight] : quadrature)
      sum += std::max(0.0, double(glm::dot(direction, normal))) * weight;
    return sum;
  }

  static constexpr uint32_t kSize = 48;
  Scene scene;
  // A broad lamp from one side: the radiance falls from its maximum to a tenth over a quarter turn.
  lab::Light light = [](vec3 d) {
    return Rgb(0.1f) + Rgb(4.0f) * std::exp(6.0f * (glm::dot(d, glm::normalize(vec3(3, 2, 1))) - 1.0f));
  };
  SummedArea table;
  TexelMap map;
  BakedScene baked;
  std::vector<std::pair<vec3, double>> quadrature;
  std::vector<double> radiance;  // of every record
};

struct Side {
  vec3 middle;
  dvec2 uv;
};

/// Points on edges that two charts share, as both see them.
std::vector<std::pair<Side, Side>> borders(const Scene& scene) {
  using Key = std::array<float, 3>;
  std::map<std::pair<Key, Key>, Side> open;
  std::vector<std::pair<Side, Side>> found;
  for (const asset::Triangle& t : scene.triangles)
    for (int k = 0; k < 3; ++k) {
      const asset::Vertex &a = scene.vertices[t.vertex[k]], &b = scene.vertices[t.vertex[(k + 1) % 3]];
      const vec3 p(a.position[0], a.position[1], a.position[2]),
          q(b.position[0], b.position[1], b.position[2]);
      const Side side{0.5f * (p + q), 0.5 * dvec2(a.atlasUv[0] + b.atlasUv[0], a.atlasUv[1] + b.atlasUv[1])};
      const Key from{p.x, p.y, p.z}, to{q.x, q.y, q.z};
      if (const auto other = open.find({to, from}); other == open.end())
        open.emplace(std::pair(from, to), side);
      else if (glm::distance(other->second.uv, side.uv) > 1e-9)
        found.emplace_back(other->second, side);
    }
  return found;
}

}  // namespace

TEST(Seams, JumpNoMoreThanNeighbouringTexelsDo) {
  const ChartedSphere sphere;
  Rms jump, error;
  for (const auto& [a, b] : borders(sphere.scene)) {
    const double left = sphere.filtered(a.uv), right = sphere.filtered(b.uv);
    const double truth = sphere.truth(glm::normalize(a.middle));
    jump.add(left - right);
    error.add(left - truth);
    error.add(right - truth);
  }
  ASSERT_GT(jump.count, 100u);

  Rms step, truthStep, inside;
  const auto& records = sphere.baked.asset.records;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> at;
  for (uint32_t r = 0; r < records.size(); ++r) at[{records[r].atlasX, records[r].atlasY}] = r;
  const auto truthOf = [&](uint32_t r) {
    return sphere.truth({records[r].normal[0], records[r].normal[1], records[r].normal[2]});
  };
  for (const auto& [place, r] : at) {
    const auto next = at.find({place.first + 1, place.second});
    if (next == at.end()) continue;
    step.add(sphere.radiance[r] - sphere.radiance[next->second]);
    truthStep.add(truthOf(r) - truthOf(next->second));
    inside.add(sphere.radiance[r] - truthOf(r));
  }
  for (const auto& [name, rms] : {std::pair("jump", jump),
                                  {"step", step},
                                  {"truthStep", truthStep},
                                  {"error", error},
                                  {"inside", inside}})
    RecordProperty(name, fmt::format("{:.4f}, at most {:.4f}", rms.value(), rms.most));
  // The truth does not jump at the border; it moves by truthStep over one texel.
  EXPECT_LT(jump.value(), 1.5 * truthStep.value()) << "jump " << jump.value() << ", neighbouring texels "
                                                   << step.value() << ", their truth " << truthStep.value();
  EXPECT_LT(jump.value(), 1.5 * step.value());
  EXPECT_LT(jump.most, 1.5 * step.most);
  EXPECT_LT(error.value(), 1.5 * truthStep.value())
      << "error at borders " << error.value() << ", of texels " << inside.value();
}
