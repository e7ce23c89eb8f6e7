/// \file
/// Counting matched cells for many translations at once.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "map_matcher/search/precomputed_grids.hpp"
#include "map_matcher/search/rotations.hpp"
#include "map_matcher/search/weighted_cells.hpp"

namespace map_matcher {

/// Shape of a tile: how many translations are counted at once.
enum class TileShape {
  kWide,    ///< 64 columns of 8 rows, for windows as large as a building.
  kNarrow,  ///< 16 columns of 12 rows, for the small window of the fine stage.
};

constexpr int tileColumns(TileShape shape) { return shape == TileShape::kWide ? kMaxTileColumns : 16; }
constexpr int tileRows(TileShape shape) { return shape == TileShape::kWide ? 8 : kMaxTileRows; }

/// Matched cells for the translations of a tile on the stride of a level, row by row.
using TileCounts = std::array<std::int32_t, 512>;

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
  /// by it, have value 1 in the level. Returns false, with the counts undefined, as soon as no translation of the tile
  /// can reach `min_count` any more.
  bool scoreTile(TileShape shape, const PooledLevel& level, const RotatedCells& cells, const Cell& first,
                 std::int32_t min_count, TileCounts& counts) const;

  /// The same for the four translations first + {0, stride} x {0, stride}: (0, 0), (1, 0), (0, 1), (1, 1).
  bool scoreChildren(const PooledLevel& level, const RotatedCells& cells, const Cell& first, std::int32_t min_count,
                     std::array<std::int32_t, 4>& counts) const;

  /// The same two for cells of which some count more than once.
  bool scoreTile(TileShape shape, const PooledLevel& level, const WeightedCells& cells, const Cell& first,
                 std::int32_t min_count, TileCounts& counts) const;
  bool scoreChildren(const PooledLevel& level, const WeightedCells& cells, const Cell& first, std::int32_t min_count,
                     std::array<std::int32_t, 4>& counts) const;

  struct Functions;

 private:
  const Functions* functions_;
};

}  // namespace map_matcher
