/// \file
/// Random numbers that are the same on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace map_matcher::simulation {

/// Random numbers from std::mt19937_64, whose output the standard fixes. The distributions of `<random>` are not fixed
/// by it, so they are written out here: a seed gives the same numbers with every standard library. Not thread-safe.
class RandomNumbers {
 public:
  /// Numbers of one `stream` of a seed. Streams of the same seed are independent of each other, so that what one part
  /// of a simulation draws does not change what another part gets.
  explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0);

  /// Uniform in [0, 1).
  double uniform();

  /// Uniform in [low, high); low when the two are equal. low <= high.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform among 0, 1, ..., count - 1. Throws std::invalid_argument for a count of 0.
  std::size_t index(std::size_t count);

  /// True with a probability from 0 to 1.
  bool chance(double probability) { return uniform() < probability; }

  /// Normally distributed, mean 0, standard deviation 1 (Marsaglia's polar method).
  double gaussian();

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;  // second number of the last pair
  bool has_spare_ = false;
};

}  // namespace map_matcher::simulation
