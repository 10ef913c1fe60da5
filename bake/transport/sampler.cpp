// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/sampler.h"

namespace boxlight {
namespace {

/// Finaliser of SplitMix64: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA
/// 2014.
uint64_t mix64(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}

uint32_t reverseBits(uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// A hash in which a bit depends only on lower bits: on reversed bits, an Owen scramble. Constants by N.
/// Vegdahl, "Building a Better LK Hash", 2021.
uint32_t scrambleReversed(uint32_t x, uint32_t seed) {
  x ^= x * 0x3D20ADEAu;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526C56u;
  x ^= x * 0x53A22864u;
  return x;
}

uint32_t owenScramble(uint32_t x, uint32_t seed) {
  return reverseBits(scrambleReversed(reverseBits(x), seed));
}

/// Second dimension of the Sobol sequence; the first is reverseBits.
uint32_t sobolSecond(uint32_t index) {
  uint32_t result = 0;
  for (uint32_t column = 1u << 31; index; index >>= 1, column ^= column >> 1)
    if (index & 1) result ^= column;
  return result;
}

float toUnit(uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

constexpr uint64_t kGoldenGamma = 0x9E3779B97F4A7C15ull;

}  // namespace

Sampler::Sampler(const StreamKey& key, uint32_t path) : path_(path) {
  streamHash_ = mix64(mix64(key.seed + kGoldenGamma) ^ ((uint64_t(key.texel) << 32) | key.stream));
  pathHash_ = mix64(streamHash_ ^ (uint64_t(path) * kGoldenGamma + 1));
}

float Sampler::next() { return toUnit(uint32_t(mix64(pathHash_ + kGoldenGamma * ++counter_) >> 32)); }

vec2 Sampler::next2() {
  if (pair_ == kStratifiedPairs) {
    const uint64_t bits = mix64(pathHash_ + kGoldenGamma * ++counter_);
    return {toUnit(uint32_t(bits >> 32)), toUnit(uint32_t(bits))};
  }
  // Each pair has its own order of the same sequence (padding), so pairs are independent of one another.
  const uint64_t seeds = mix64(streamHash_ + kGoldenGamma * ++pair_);
  const uint32_t index = owenScramble(path_, uint32_t(seeds));
  const uint64_t scrambles = mix64(seeds);
  return {toUnit(owenScramble(reverseBits(index), uint32_t(scrambles))),
          toUnit(owenScramble(sobolSecond(index), uint32_t(scrambles >> 32)))};
}

}  // namespace boxlight
