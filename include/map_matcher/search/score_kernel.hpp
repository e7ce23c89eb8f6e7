/// \file
/// Counting matched cells for many translations at once.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "map_matcher/search/precomputed_grids.hpp"
#include "map_matcher/search/rotations.hpp"

namespace map_matcher {

/// Matched cells for kTileRows x kTileColumns translations on the stride of a level, row by row.
using TileCounts = std::array<std::int32_t, static_cast<std::size_t>(kTileRows) * kTileColumns>;

/// Instruction sets the tile kernel is built for.
enum class KernelVariant {
  kBaseline,  ///< What the compiler's target has.
  kAvx2,
  kAvx512,  ///< AVX-512 BW.
};

/// Variants that this processor can run; the last is the fastest.
std::vector<KernelVariant> availableKernelVariants();

/// Counts the matched cells of tiles of translations. Holds scratch memory; one per thread.
class TileScorer {
 public:
  explicit TileScorer(KernelVariant variant = availableKernelVariants().back());

  /// For each translation (first.x + column * stride, first.y + row * stride) of a tile: how many of the cells, moved
  /// by it, have value 1 in the level. Returns false, with the counts undefined, as soon as no translation of the tile
  /// can reach `min_count` any more.
  bool score(const PooledLevel& level, const RotatedCells& cells, const Cell& first, std::int32_t min_count,
             TileCounts& counts);

 private:
  KernelVariant variant_;
  std::vector<std::uint32_t> addresses_;
};

/// Matched cells for the four translations first + {0, stride} x {0, stride} of a level: (0, 0), (1, 0), (0, 1), (1,
/// 1). Returns false, with the counts undefined, as soon as none of them can reach `min_count` any more.
bool scoreChildren(const PooledLevel& level, const RotatedCells& cells, const Cell& first, std::int32_t min_count,
                   std::array<std::int32_t, 4>& counts);

}  // namespace map_matcher
