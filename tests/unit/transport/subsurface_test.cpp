// SPDX-License-Identifier: Apache-2.0
// Random walks against exact answers. The boundary is KHR_materials_diffuse_transmission of 1 without a
// specular layer: it passes everything as Lambert light and reflects nothing, inside or outside. So a
// kernel's paths see a medium under diffuse light with a transparent boundary, the textbook case.
#include <gtest/gtest.h>

#include "bake/transport/warp.h"
#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

double meanOfEverything(const KernelPaths& paths, int channel) {
  double sum = 0;
  for (const Deposit& deposit : paths.deposits) sum += double(deposit.throughput[channel]);
  return sum / paths.traced;
}

/// Spherical albedo of a half space that scatters isotropically: 1 - 2 sqrt(1 - a) int H(m) m dm, with H from
/// 1/H(m) = sqrt(1 - a) + a/2 int x H(x) / (m + x) dx. Chandrasekhar, "Radiative Transfer", 1950, sections 34
/// and 38.
double halfSpaceAlbedo(double albedo) {
  constexpr int kSteps = 400;
  const auto node = [](int i) { return (i + 0.5) / kSteps; };
  const double root = std::sqrt(1 - albedo);
  std::vector<double> h(kSteps, 1.0), next(kSteps);
  for (int iteration = 0; iteration < 200; ++iteration) {
    for (int i = 0; i < kSteps; ++i) {
      double sum = 0;
      for (int j = 0; j < kSteps; ++j) sum += node(j) * h[size_t(j)] / (node(i) + node(j)) / kSteps;
      next[size_t(i)] = 1 / (root + albedo / 2 * sum);
    }
    for (int i = 0; i < kSteps; ++i) h[size_t(i)] = 0.5 * (h[size_t(i)] + next[size_t(i)]);
  }
  double moment = 0;
  for (int i = 0; i < kSteps; ++i) moment += node(i) * h[size_t(i)] / kSteps;
  return 1 - 2 * root * moment;
}

/// Exactly one scattering, albedo factored out: light of radiance 1 from everywhere above a slab,
/// Chandrasekhar's equation III.48 integrated over both directions with the Henyey-Greenstein phase function.
struct SingleScattering {
  double reflected = 0, transmitted = 0;
};
SingleScattering singleScattering(double depth, double g) {
  constexpr int kSteps = 64, kAround = 64;
  const auto phase = [g](double cosine) {
    return (1 - g * g) / (4 * kPiDouble * std::pow(1 + g * g - 2 * g * cosine, 1.5));
  };
  SingleScattering answer;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double in = (i + 0.5) / kSteps, out = (j + 0.5) / kSteps;
      const double sines = std::sqrt((1 - in * in) * (1 - out * out));
      double back = 0, forth = 0;
      for (int k = 0; k < kAround; ++k) {
        const double around = sines * std::cos(2 * kPiDouble * (k + 0.5) / kAround);
        back += phase(around - in * out) * 2 * kPiDouble / kAround;
        forth += phase(around + in * out) * 2 * kPiDouble / kAround;
      }
      const double reflected = in * out / (in + out) * (1 - std::exp(-depth / in - depth / out));
      const double passed = std::abs(in - out) < 1e-9
                                ? depth * std::exp(-depth / in)
                                : in * out / (in - out) * (std::exp(-depth / in) - std::exp(-depth / out));
      answer.reflected += 2 * back * reflected / (kSteps * kSteps);
      answer.transmitted += 2 * forth * passed / (kSteps * kSteps);
    }
  return answer;
}

/// Unscattered transmittance of diffuse light: 2 E3(depth).
double direct(double depth) {
  constexpr int kSteps = 4096;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (i + 0.5) / kSteps;
    sum += 2 * cosine * std::exp(-depth / cosine) / kSteps;
  }
  return sum;
}

}  // namespace

TEST(Subsurface, ChandrasekharsTablesAreReproducedByTheTestItself) {
  // His table XI gives the first moments of H; the spherical albedos below follow from them.
  EXPECT_NEAR(halfSpaceAlbedo(0.5), 0.1467, 5e-4);
  EXPECT_NEAR(halfSpaceAlbedo(0.9), 0.4776, 1e-3);
  const SingleScattering thin = singleScattering(1e-4, 0.5);
  EXPECT_NEAR((thin.reflected + thin.transmitted) / 2e-4, 1, 0.02);  // every flight's mean length is twice d
}

TEST(Subsurface, HalfSpacesReflectChandrasekharsSphericalAlbedo) {
  const Rgb albedo(0.9f, 0.99f, 0.999f);  // one walk, three weights
  const Scene scene = test::slab(test::diffuseMedium(Rgb(1) - albedo, albedo), 250);
  const Intersector world(scene);
  const KernelPaths paths = test::lambertPaths(world, 0, true, 1 << 16);
  for (int c = 0; c < 3; ++c) {
    const test::Estimate reflected = test::slabAnswer(paths, c).reflected;
    EXPECT_LT(std::abs(reflected.z(halfSpaceAlbedo(double(albedo[c])))), 4) << reflected.mean;
    EXPECT_LT(reflected.error() / reflected.mean, 5e-3);
  }
}

TEST(Subsurface, WhiteSlabsTransmitByMilnesExtrapolationLength) {
  // Conservative isotropic scattering under diffuse light: T = 4/3 / (depth + 2 q), q = .710446, up to terms
  // that fall like exp(-depth). Case and Zweifel, "Linear Transport Theory", 1967, section 6.6.
  for (float depth : {5.0f, 20.0f}) {
    const Scene scene = test::slab(test::diffuseMedium(Rgb(0), Rgb(1)), depth);
    const Intersector world(scene);
    const KernelPaths paths = test::lambertPaths(world, 0, true, 1 << 16);
    const test::Estimate passed = test::slabAnswer(paths, 0).transmitted;
    EXPECT_LT(std::abs(passed.z(4.0 / 3.0 / (double(depth) + 1.420892))), 4) << passed.mean;
    EXPECT_NEAR(meanOfEverything(paths, 0), 1, 2e-3);  // roulette touches the longest walks alone
  }
}

TEST(Subsurface, AnisotropyFollowsTheSimilarityRelation) {
  // The extrapolation length of Henyey-Greenstein media differs by less than 1 % from (1 - g) q: van de
  // Hulst, "Multiple Light Scattering", 1980, chapter 12.
  for (float g : {-0.5f, 0.5f, 0.8f}) {
    const float depth = 10 / (1 - g);
    const Scene scene = test::slab(test::diffuseMedium(Rgb(0), Rgb(1), g), depth);
    const Intersector world(scene);
    const test::Estimate passed =
        test::slabAnswer(test::lambertPaths(world, 0, true, 1 << 16), 0).transmitted;
    EXPECT_NEAR(passed.mean / (4.0 / 3.0 / 11.42), 1, 0.01 + 3 * passed.error() / passed.mean) << g;
  }
}

TEST(Subsurface, FaintScatteringIsSingle) {
  const Rgb albedo(0.5f, 0.5f, 0.002f);  // red keeps the walk alive, blue counts single scattering
  for (float g : {0.0f, 0.7f, -0.7f})
    for (float depth : {0.3f, 2.0f}) {
      const Scene scene = test::slab(test::diffuseMedium(Rgb(1) - albedo, albedo, g), depth);
      const Intersector world(scene);
      const KernelPaths paths = test::lambertPaths(world, 0, true, 1 << 17);
      const auto [reflected, transmitted] = test::slabAnswer(paths, 2);
      const SingleScattering truth = singleScattering(double(depth), double(g));
      EXPECT_NEAR(reflected.mean / 0.002 / truth.reflected, 1, 0.005 + 4 * reflected.error() / reflected.mean)
          << g << ", " << depth;
      // Most of what passes was never scattered.
      EXPECT_LT(std::abs(transmitted.z(direct(double(depth)) + 0.002 * truth.transmitted)), 4);
    }
}

TEST(Subsurface, ClearMediaOnlyAbsorb) {
  const Scene scene = test::slab(test::diffuseMedium({0, 0.5f, 3}, Rgb(0)), 1);
  const Intersector world(scene);
  const KernelPaths paths = test::lambertPaths(world, 0, true, 1 << 14);
  for (int c = 0; c < 3; ++c) {
    const double depth = c == 0 ? 0 : c == 1 ? 0.5 : 3;
    EXPECT_NEAR(meanOfEverything(paths, c) / direct(depth), 1, 5e-3);
  }
}

TEST(Subsurface, ColouredExtinctionIsWeightedOverAllChannels) {
  // Channels of different extinction share each walk; every one must come out as if it were alone.
  const Rgb scattering(0.2f, 2, 5), absorption(0.1f, 0, 0.5f);
  const auto passed = [](Rgb a, Rgb s, int channel) {
    const Scene scene = test::slab(test::diffuseMedium(a, s), 1);
    return test::slabAnswer(test::lambertPaths(Intersector(scene), 0, true, 1 << 15), channel).transmitted;
  };
  for (int c = 0; c < 3; ++c) {
    const test::Estimate together = passed(absorption, scattering, c);
    const test::Estimate alone = passed(Rgb(absorption[c]), Rgb(scattering[c]), 0);
    EXPECT_LT(std::abs(together.mean - alone.mean), 4 * std::hypot(together.error(), alone.error())) << c;
  }
}

TEST(Subsurface, PathsInAWhiteBodyAreAsLongAsTheMeanChord) {
  // Blanco and Fournier, "An invariance property of diffusive random walks", Europhys. Lett. 61, 2003: under
  // diffuse light the mean length of the paths inside a white body is 4 V/S, however strongly it scatters. A
  // trace of absorption shows the length.
  for (float scattering : {0.1f, 3.0f, 30.0f}) {
    const float trace = 1e-3f;
    Scene scene = test::diffuseMedium({trace, trace, 0}, Rgb(scattering), 0.3f);
    test::addSphere(scene, vec3(0), 1, 64);
    const Intersector world(scene);
    test::Estimate length;
    for (uint32_t i = 0; i < 1 << 14; ++i) {
      Sampler sampler({3, 0, 0}, i);
      const float z = 1 - 2 * sampler.next();
      const vec3 inward(-std::sqrt(1 - z * z), z, 0);
      vec3 tangent, bitangent;
      orthonormalBasis(inward, tangent, bitangent);
      const vec3 local = cosineDirection(sampler.next2());
      Ray ray{dvec3(inward) * -1.01, local.x * tangent + local.y * bitangent + local.z * inward};
      const auto point = world.intersect(ray);
      if (!point) continue;  // passes beside the ball
      ray.origin = offsetOrigin(scene, *point, -surfaceFrame(scene, *point).geometricNormal);
      MediumStack media;
      media.enter(0);
      Rgb throughput(1);
      travel(world, media, ray, throughput, sampler);
      const bool ended = maxComponent(throughput) == 0;
      length.add(
          ended ? 0 : -std::log(double(throughput.x / throughput.z)) / double(trace) * double(throughput.z));
    }
    EXPECT_LT(std::abs(length.z(4.0 / 3.0)), 4) << scattering << ": " << length.mean;
  }
}
