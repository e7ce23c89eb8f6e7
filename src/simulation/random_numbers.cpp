#include "map_matcher/simulation/random_numbers.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace map_matcher::simulation {
namespace {

/// One step of splitmix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014): neighbouring
/// inputs give unrelated outputs.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

}  // namespace

RandomNumbers::RandomNumbers(std::uint64_t seed, std::uint64_t stream) : engine_(mixed(mixed(seed) + stream)) {}

double RandomNumbers::uniform() {
  constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53, the spacing of doubles below 1
  return static_cast<double>(engine_() >> 11U) * kUnit;
}

std::size_t RandomNumbers::index(std::size_t count) {
  if (count == 0) {
    throw std::invalid_argument("count is 0, expected at least 1 to choose from");
  }
  // Numbers above the last multiple of count would favour the small ones; they are drawn again.
  const std::uint64_t limit = std::numeric_limits<std::uint64_t>::max() / count * count;
  std::uint64_t drawn = engine_();
  while (drawn >= limit) {
    drawn = engine_();
  }
  return static_cast<std::size_t>(drawn % count);
}

double RandomNumbers::gaussian() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u = 0.0;
  double v = 0.0;
  double square = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    v = uniform(-1.0, 1.0);
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(square) / square);
  spare_ = v * scale;
  has_spare_ = true;
  return u * scale;
}

}  // namespace map_matcher::simulation
