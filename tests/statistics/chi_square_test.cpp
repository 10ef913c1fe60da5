// SPDX-License-Identifier: Apache-2.0
// Pearson's chi-square of every material's sampled directions against its density, over the whole sphere.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/bsdf_lab.h"
#include "tests/support/material_cases.h"
#include "tests/support/statistics.h"

using namespace boxlight;

namespace {

constexpr int kPilots = 1 << 14, kSamples = 1 << 16;
constexpr int kCellLevels = 6, kQuadratureLevels = 10;  ///< halvings of the sphere
constexpr float kCosines[] = {1.0f, 0.7f, 0.2f, 0.03f, 1e-3f};

/// Equal-area coordinates of the sphere: height above the plane of incidence, and the angle in it. Mirrored
/// and refracted directions lie on their equator, where floats resolve a lobe of any width, and the horizon
/// is the angles +-pi/2.
struct Chart {
  explicit Chart(double azimuth) : c(std::cos(azimuth)), s(std::sin(azimuth)) {}
  glm::dvec2 coordinates(vec3 w) const {
    const double x = c * double(w.x) + s * double(w.y), y = c * double(w.y) - s * double(w.x);
    return {y, std::atan2(x, double(w.z))};
  }
  vec3 direction(glm::dvec2 p) const {
    const double ring = std::sqrt(std::max(0.0, 1 - p.x * p.x)), x = ring * std::sin(p.y);
    return {float(c * x - s * p.x), float(s * x + c * p.x), float(ring * std::cos(p.y))};
  }
  double c, s;
};

struct Rect {
  glm::dvec2 low, high;
};

/// A cell of the test, halved by its share of pilot samples, so that cells crowd wherever a lobe is.
class Partition {
 public:
  /// Cells are made from `pilots`, the quadrature inside them from those of the narrowest lobe.
  Partition(const Bsdf& bsdf, const Chart& chart, std::vector<glm::dvec2> pilots,
            std::vector<glm::dvec2> narrow)
      : bsdf_(bsdf), chart_(chart), narrow_(std::move(narrow)) {
    for (int root = 0; root < 3; ++root) {  // below the horizon on both sides, and above
      const double lows[] = {-kPiDouble, -kPiDouble / 2, kPiDouble / 2, kPiDouble};
      const Rect rect{{-1, lows[root]}, {1, lows[root + 1]}};
      std::vector<glm::dvec2> inside;
      for (const glm::dvec2 p : pilots)
        if (p.y >= rect.low.y && p.y < rect.high.y) inside.push_back(p);
      split(rect, inside.data(), inside.data() + inside.size(), 0);
    }
  }

  /// Cells are [index] of these.
  std::vector<Rect> cells;
  std::vector<double> expected;  ///< integral of the density over each

 private:
  void split(Rect rect, glm::dvec2* first, glm::dvec2* last, int level) {
    if (level == kCellLevels || (level < kCellLevels && last - first < 64)) {
      cells.push_back(rect);
      const auto inside = [&](glm::dvec2 p) {
        return p.x >= rect.low.x && p.x <= rect.high.x && p.y >= rect.low.y && p.y < rect.high.y;
      };
      std::vector<glm::dvec2> lobe;
      std::copy_if(narrow_.begin(), narrow_.end(), std::back_inserter(lobe), inside);
      expected.push_back(quadrature(rect, lobe.data(), lobe.data() + lobe.size(), level));
      return;
    }
    const auto [low, high] = halve(rect, first, last, level);
    glm::dvec2* middle = first + (last - first) / 2;
    split(low, first, middle, level + 1);
    split(high, middle, last, level + 1);
  }

  std::pair<Rect, Rect> halve(Rect rect, glm::dvec2* first, glm::dvec2* last, int level) const {
    const int axis = level % 2;
    glm::dvec2* middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](auto a, auto b) { return a[axis] < b[axis]; });
    std::pair<Rect, Rect> halves{rect, rect};
    halves.first.high[axis] = halves.second.low[axis] = (*middle)[axis];
    return halves;
  }

  /// The integral, again over halves of the pilots, and from their bounds outwards in doubling strips: the
  /// corner of a large cell that holds the skirt of a narrow lobe is not overlooked.
  double quadrature(Rect rect, glm::dvec2* first, glm::dvec2* last, int level) const {
    if (first == last) return refine(rect, gauss(rect), 0);
    if (level < kQuadratureLevels && last - first >= 8) {
      const auto [low, high] = halve(rect, first, last, level);
      glm::dvec2* middle = first + (last - first) / 2;
      return quadrature(low, first, middle, level + 1) + quadrature(high, middle, last, level + 1);
    }
    const std::vector<double> x = cuts(rect, first, last, 0), y = cuts(rect, first, last, 1);
    double sum = 0;
    for (size_t i = 1; i < x.size(); ++i)
      for (size_t j = 1; j < y.size(); ++j) {
        const Rect strip{{x[i - 1], y[j - 1]}, {x[i], y[j]}};
        sum += refine(strip, gauss(strip), 0);
      }
    return sum;
  }

  static std::vector<double> cuts(Rect rect, const glm::dvec2* first, const glm::dvec2* last, int axis) {
    double low = rect.high[axis], high = rect.low[axis];
    for (const glm::dvec2* p = first; p != last; ++p)
      low = std::min(low, (*p)[axis]), high = std::max(high, (*p)[axis]);
    const double width = std::max(high - low, 1e-6 * (rect.high[axis] - rect.low[axis]));
    std::vector<double> result = {rect.low[axis], rect.high[axis]};
    const auto walk = [&](double from, double step) {
      for (; from > rect.low[axis] && from < rect.high[axis]; from += step, step *= 2) result.push_back(from);
    };
    walk(low, -width);
    walk(high, width);
    std::sort(result.begin(), result.end());
    return result;
  }

  double refine(Rect rect, double coarse, int depth) const {
    const glm::dvec2 middle = 0.5 * (rect.low + rect.high);
    const Rect quarters[] = {{rect.low, middle},
                             {{middle.x, rect.low.y}, {rect.high.x, middle.y}},
                             {{rect.low.x, middle.y}, {middle.x, rect.high.y}},
                             {middle, rect.high}};
    double sums[4], fine = 0;
    for (int q = 0; q < 4; ++q) fine += sums[q] = gauss(quarters[q]);
    if (depth == 8 || std::abs(fine - coarse) < 2e-7 + 1e-3 * fine) return fine;
    fine = 0;
    for (int q = 0; q < 4; ++q) fine += refine(quarters[q], sums[q], depth + 1);
    return fine;
  }

  /// Three Gauss-Legendre points along each axis.
  double gauss(Rect rect) const {
    constexpr double kPoint[] = {-0.7745966692414834, 0, 0.7745966692414834},
                     kWeight[] = {5 / 18., 8 / 18., 5 / 18.};
    const glm::dvec2 middle = 0.5 * (rect.low + rect.high), half = 0.5 * (rect.high - rect.low);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const glm::dvec2 p = middle + half * glm::dvec2(kPoint[i], kPoint[j]);
        sum += kWeight[i] * kWeight[j] * double(bsdf_.evaluate(chart_.direction(p)).density);
      }
    return sum * 4 * half.x * half.y;
  }

  const Bsdf& bsdf_;
  const Chart& chart_;
  std::vector<glm::dvec2> narrow_;
};

class Draws {
 public:
  explicit Draws(uint64_t seed) : engine_(seed) {}
  float next() { return float(engine_() >> 40) * 0x1p-24f; }
  vec3 from(const Bsdf& bsdf, uint32_t lobes = kAllLobes) {
    const float choice = next(), u = next();
    return bsdf.sample(choice, {u, next()}, lobes).wi;
  }
  std::vector<glm::dvec2> pilots(const Bsdf& bsdf, const Chart& chart, uint32_t lobes) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < kPilots; ++i)
      if (const vec3 w = from(bsdf, lobes); w != vec3(0)) points.push_back(chart.coordinates(w));
    return points;
  }

 private:
  std::mt19937_64 engine_;
};

struct Verdict {
  double p, integral, drawn;
  size_t cells;
};

Verdict chiSquare(const Bsdf& bsdf, const Chart& chart, uint64_t seed) {
  Draws pilots(seed), draws(seed + 1000000);
  const uint32_t narrowest = bsdf.has(kCoat) ? kCoat : bsdf.has(kSpecular) ? kSpecular : kAllLobes;
  const auto all = pilots.pilots(bsdf, chart, kAllLobes), narrow = pilots.pilots(bsdf, chart, narrowest);
  const Partition partition(bsdf, chart, all, narrow);
  std::vector<double> observed(partition.cells.size(), 0);
  double lost = 0;
  for (int i = 0; i < kSamples; ++i) {
    const vec3 w = draws.from(bsdf);
    if (w == vec3(0)) {
      ++lost;
      continue;
    }
    const glm::dvec2 p = chart.coordinates(w);
    for (size_t c = 0; c < observed.size(); ++c) {
      const Rect& r = partition.cells[c];
      if (p.x >= r.low.x && p.x <= r.high.x && p.y >= r.low.y && p.y < r.high.y) {
        ++observed[c];
        break;
      }
    }
  }
  double statistic = 0, integral = 0, poolObserved = lost, poolExpected = 0;
  int terms = 0;
  const auto add = [&](double found, double expected) {
    statistic += (found - expected) * (found - expected) / expected, ++terms;
  };
  for (size_t c = 0; c < observed.size(); ++c) {
    integral += partition.expected[c];
    const double expected = partition.expected[c] * kSamples;
    if (expected >= 20)
      add(observed[c], expected);
    else
      poolObserved += observed[c], poolExpected += expected;
  }
  poolExpected += (1 - integral) * kSamples;  // what falls below the horizon is drawn, and lost
  if (poolExpected >= 20 || poolObserved >= 20) add(poolObserved, std::max(poolExpected, 20.0));
  return {terms > 1 ? test::chiSquareP(statistic, terms - 1) : 1.0, integral, 1 - lost / kSamples,
          observed.size()};
}

}  // namespace

TEST(ChiSquare, SamplingFollowsTheDensity) {
  const auto& cases = test::materialCases();
  const double level = test::sidakLevel(int(cases.size() * std::size(kCosines)));
  uint64_t seed = 1;
  double least = 1;
  for (const test::MaterialCase& c : cases)
    for (const float cosine : kCosines) {
      const Chart chart(double(c.azimuth));
      const Bsdf bsdf = c.bsdf(test::directionAt(cosine, c.azimuth));
      const Verdict verdict = chiSquare(bsdf, chart, ++seed);
      EXPECT_GT(verdict.p, level) << c.name << ", n.v " << cosine << ", " << verdict.cells
                                  << " cells, density " << verdict.integral << ", drawn " << verdict.drawn;
      EXPECT_LT(verdict.integral, 1.002) << c.name << ", n.v " << cosine;
      least = std::min(least, verdict.p);
    }
  RecordProperty("least_p", std::to_string(least));
}
