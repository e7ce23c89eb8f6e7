/// \file
/// Counting in registers in which each bit belongs to another translation of a tile: adders of binary digits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "map_matcher/search/counting/precomputed_grids.hpp"

#define MAP_MATCHER_INLINE __attribute__((always_inline)) inline

namespace map_matcher::search {

/// A bit for each translation of a tile.
using TileBits = std::array<TileWord, kTileColumns>;

constexpr std::size_t kTileBytes = kTileColumns * sizeof(TileWord);

/// Vector types of GCC and clang: portable, and split by the compiler where the processor's registers are narrower.
template <int kBytes>
struct BitVector {
  // NOLINTNEXTLINE(modernize-use-using): GCC ignores the attribute of a dependent type in an alias.
  typedef std::uint64_t type __attribute__((vector_size(kBytes)));
};

/// The part of a tile's bits that begins at a byte.
template <typename Vector>
MAP_MATCHER_INLINE void load(const TileWord* words, std::size_t byte, Vector& vector) {
  std::memcpy(&vector, reinterpret_cast<const unsigned char*>(words) + byte, sizeof(vector));
}

template <typename Vector>
MAP_MATCHER_INLINE void store(const Vector& vector, std::size_t byte, TileWord* words) {
  std::memcpy(reinterpret_cast<unsigned char*>(words) + byte, &vector, sizeof(vector));
}

/// A carry-save adder: sum and two more numbers of one digit become a sum and a carry. The carry is written as a choice
/// because that is one instruction of AVX-512 and of NEON.
template <typename Vector>
MAP_MATCHER_INLINE void addDigits(Vector& sum, Vector& carry, const Vector& a, const Vector& b) {
  const Vector either = sum ^ a;
  carry = (either & b) | (~either & a);
  sum = either ^ b;
}

/// A tree of carry-save adders for 2^kDigits tiles, with two or five operations each (Harley and Seal's population
/// count).
template <int kDigits>
struct AdderTree {
  static constexpr std::size_t kTiles = std::size_t{1} << kDigits;

  /// Adds the tiles at `addresses` to digits[0 ... kDigits - 1] and makes `carry` what goes to the next digit.
  template <typename Vector>
  static MAP_MATCHER_INLINE void add(const TileWord* words, const std::uint32_t* addresses, std::size_t part,
                                     Vector* digits, Vector& carry) {
    Vector a;
    Vector b;
    AdderTree<kDigits - 1>::add(words, addresses, part, digits, a);
    AdderTree<kDigits - 1>::add(words, addresses + kTiles / 2, part, digits, b);
    addDigits(digits[kDigits - 1], carry, a, b);
  }
};

/// A single tile, which nothing is added to.
template <>
struct AdderTree<0> {
  template <typename Vector>
  static MAP_MATCHER_INLINE void add(const TileWord* words, const std::uint32_t* addresses, std::size_t part,
                                     Vector* /*digits*/, Vector& carry) {
    load(words + *addresses, part, carry);
  }
};

/// Adds `num_trees` trees of 2^kDigits tiles to counts of `num_digits` digits, one after the other. The lowest kDigits
/// digits stay in registers; `counts` has at least as many.
template <int kDigits, typename Vector>
MAP_MATCHER_INLINE void addTrees(const TileWord* words, const std::uint32_t* addresses, std::size_t num_trees,
                                 std::size_t part, TileBits* counts, int num_digits) {
  Vector digits[kDigits];
  for (int digit = 0; digit < kDigits; ++digit) {
    load(counts[digit].data(), part, digits[digit]);
  }
  for (std::size_t tree = 0; tree < num_trees; ++tree) {
    Vector carry;
    AdderTree<kDigits>::add(words, addresses + tree * AdderTree<kDigits>::kTiles, part, digits, carry);
    for (int digit = kDigits; digit < num_digits; ++digit) {
      Vector sum;
      load(counts[digit].data(), part, sum);
      store(sum ^ carry, part, counts[digit].data());
      carry &= sum;
    }
  }
  for (int digit = 0; digit < kDigits; ++digit) {
    store(digits[digit], part, counts[digit].data());
  }
}

}  // namespace map_matcher::search
