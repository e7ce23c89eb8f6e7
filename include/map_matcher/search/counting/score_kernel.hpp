/// \file
/// Counting matched cells for many translations at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "map_matcher/search/counting/precomputed_grids.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/weighted_cells.hpp"

namespace map_matcher::search {

/// Part of a tile that is looked at: columns and rows from its first translation on, at least 1 and at most
/// kTileColumns and kTileRows.
struct TileSize {
  int columns = kTileColumns;
  int rows = kTileRows;
};

/// The part of a tile that does not go beyond `last` [cells], for translations `stride` apart from `first` on.
inline TileSize tileWithin(const grid::Cell& last, const grid::Cell& first, int stride) {
  return {std::min(kTileColumns, (last.x - first.x) / stride + 1),
          std::min(kTileRows, (last.y - first.y) / stride + 1)};
}

/// Which translations of a tile are looked at: a word for each column, a bit for each row.
using TileMask = std::array<TileWord, kTileColumns>;

/// A translation of a tile and its matched cells.
struct TileScore {
  int column = 0;
  int row = 0;
  std::int32_t count = 0;
};

/// Instruction sets the tile kernel is built for.
enum class KernelVariant {
  kBaseline,  ///< What the compiler's target has.
  kAvx2,
  kAvx512,  ///< AVX-512 BW.
};

/// Variants that this processor can run; the last is the fastest.
std::vector<KernelVariant> availableKernelVariants();

/// Counts the matched cells of many translations. Stateless, hence thread-safe.
class ScoreKernel {
 public:
  explicit ScoreKernel(KernelVariant variant = availableKernelVariants().back());

  /// For each translation (first.x + column * stride, first.y + row * stride) of a tile: how many of the cells, moved
  /// by it, have value 1 in the level. `scores` becomes those that reach `min_count`, column by column. Gives up as
  /// soon as none of them can.
  void scoreTile(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first, const TileSize& size,
                 std::int32_t min_count, std::vector<TileScore>& scores) const;

  /// The same for cells of which some count more than once.
  void scoreTile(const PooledLevel& level, const WeightedCells& cells, const grid::Cell& first, const TileSize& size,
                 std::int32_t min_count, std::vector<TileScore>& scores) const;

  /// The same for those of the translations that are `wanted`.
  void scorePart(const PooledLevel& level, const WeightedCells& cells, const grid::Cell& first, const TileMask& wanted,
                 std::int32_t min_count, std::vector<TileScore>& scores) const;

  /// The largest count of a tile, the same as that of all its scores.
  std::int32_t bestCount(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first,
                         const TileSize& size) const;

  struct Functions;

 private:
  const Functions* functions_;
};

}  // namespace map_matcher::search
