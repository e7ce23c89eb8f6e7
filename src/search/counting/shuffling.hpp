/// \file
/// An order in which a part of the values tells what all are like.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace map_matcher::search {

/// Fisher-Yates with a fixed seed. std::shuffle may differ between standard libraries.
template <typename T>
void shuffle(std::vector<T>& values) {
  std::mt19937 random;  // its default seed
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random() % i]);
  }
}

/// Neighbours stay beside each other, for the processor's caches, but the neighbourhoods come in shuffled order, so
/// that a search knows early what a pose is worth.
template <typename T>
std::vector<T> inShuffledNeighbourhoods(const std::vector<T>& values) {
  constexpr std::size_t kNeighbourhood = 64;
  std::vector<std::size_t> neighbourhoods((values.size() + kNeighbourhood - 1) / kNeighbourhood);
  std::iota(neighbourhoods.begin(), neighbourhoods.end(), std::size_t{0});
  shuffle(neighbourhoods);
  std::vector<T> result;
  result.reserve(values.size());
  for (const std::size_t neighbourhood : neighbourhoods) {
    const std::size_t begin = neighbourhood * kNeighbourhood;
    const std::size_t end = std::min(begin + kNeighbourhood, values.size());
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(begin),
                  values.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

}  // namespace map_matcher::search
