#include "map_matcher/search/score_kernel.hpp"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define MAP_MATCHER_X86 1
#else
#define MAP_MATCHER_X86 0
#endif

namespace map_matcher {
namespace {

/// Cells counted in 8 bits before the counts are widened and a hopeless tile is given up; at most 255.
constexpr std::size_t kChunk = 128;

/// Vector types of GCC and clang: portable, and split by the compiler where the processor's registers are narrower.
template <int kBytes>
struct ByteVector {
  // NOLINTNEXTLINE(modernize-use-using): GCC ignores the attribute of a dependent type in an alias.
  typedef std::uint8_t type __attribute__((vector_size(kBytes)));
};

/// Up to kChunk cells and where their first translation lies.
struct Chunk {
  const PooledLevel* level;
  const std::int16_t* x;
  const std::int16_t* y;
  std::size_t size;
  Cell first;
  std::int32_t weight;  // of each cell
};

#define MAP_MATCHER_INLINE __attribute__((always_inline)) inline

/// Where the chunk's tiles begin. Inlined into each variant, so that its vector instructions compute them.
MAP_MATCHER_INLINE void computeAddresses(const Chunk& chunk, std::uint32_t* addresses) {
  const PooledLevel& level = *chunk.level;
  for (std::size_t k = 0; k < chunk.size; ++k) {
    addresses[k] = level.address(chunk.x[k] + chunk.first.x, chunk.y[k] + chunk.first.y);
  }
}

/// Adds the tiles of a chunk to `counts` and returns the largest of them. Eight-bit counters stay in registers, kRows
/// rows at once, so that one addition serves as many translations as a register has bytes; benchmark: BM_ScoreTile.
template <TileShape kShape, int kVectorBytes, int kRows>
MAP_MATCHER_INLINE std::int32_t addTiles(const Chunk& chunk, std::int32_t* counts) {
  using Vector = typename ByteVector<kVectorBytes>::type;
  constexpr int kColumns = tileColumns(kShape);
  constexpr int kVectorsPerRow = kColumns / kVectorBytes;
  std::uint32_t addresses[kChunk];
  computeAddresses(chunk, addresses);
  const std::ptrdiff_t row_stride = chunk.level->rowStride();
  std::int32_t largest = 0;
  for (int top = 0; top < tileRows(kShape); top += kRows) {
    const std::uint8_t* values = chunk.level->data() + top * row_stride;
    Vector sums[kRows][kVectorsPerRow] = {};
    for (std::size_t k = 0; k < chunk.size; ++k) {
      const std::uint8_t* tile = values + addresses[k];
      for (int row = 0; row < kRows; ++row) {
        for (int v = 0; v < kVectorsPerRow; ++v) {
          Vector bytes;
          std::memcpy(&bytes, tile + row * row_stride + v * kVectorBytes, sizeof(bytes));
          sums[row][v] += bytes;
        }
      }
    }
    std::uint8_t narrow[kRows * kColumns];
    std::memcpy(narrow, sums, sizeof(narrow));
    for (int i = 0; i < kRows * kColumns; ++i) {
      const std::int32_t count = counts[top * kColumns + i] + chunk.weight * narrow[i];
      counts[top * kColumns + i] = count;
      largest = count > largest ? count : largest;
    }
  }
  return largest;
}

/// Adds two rows of two translations to `counts` and returns the largest of them: each load brings two neighbours as
/// the bytes of one number, which at most kChunk additions keep from running into each other.
MAP_MATCHER_INLINE std::int32_t addChildren(const Chunk& chunk, std::int32_t* counts) {
  std::uint32_t addresses[kChunk];
  computeAddresses(chunk, addresses);
  const std::uint8_t* lower = chunk.level->data();
  const std::uint8_t* upper = lower + chunk.level->rowStride();
  std::uint32_t sums[2] = {0, 0};
  for (std::size_t k = 0; k < chunk.size; ++k) {
    std::uint16_t pairs[2];
    std::memcpy(&pairs[0], lower + addresses[k], sizeof(pairs[0]));
    std::memcpy(&pairs[1], upper + addresses[k], sizeof(pairs[1]));
    sums[0] += pairs[0];
    sums[1] += pairs[1];
  }
  for (int row = 0; row < 2; ++row) {
    const auto pair = static_cast<std::uint16_t>(sums[row]);
    std::uint8_t bytes[2];
    std::memcpy(bytes, &pair, sizeof(bytes));
    counts[2 * row] += chunk.weight * bytes[0];
    counts[2 * row + 1] += chunk.weight * bytes[1];
  }
  return std::max({counts[0], counts[1], counts[2], counts[3]});
}

// The same three functions for each instruction set.
#define MAP_MATCHER_KERNEL(SUFFIX, TARGET, WIDE_BYTES, WIDE_ROWS)                        \
  TARGET std::int32_t addWideTiles##SUFFIX(const Chunk& chunk, std::int32_t* counts) {   \
    return addTiles<TileShape::kWide, WIDE_BYTES, WIDE_ROWS>(chunk, counts);             \
  }                                                                                      \
  TARGET std::int32_t addNarrowTiles##SUFFIX(const Chunk& chunk, std::int32_t* counts) { \
    return addTiles<TileShape::kNarrow, 16, kMaxTileRows>(chunk, counts);                \
  }                                                                                      \
  TARGET std::int32_t addChildren##SUFFIX(const Chunk& chunk, std::int32_t* counts) {    \
    return addChildren(chunk, counts);                                                   \
  }

MAP_MATCHER_KERNEL(Baseline, , 16, 2)
#if MAP_MATCHER_X86
MAP_MATCHER_KERNEL(Avx2, __attribute__((target("avx2"))), 32, 4)
MAP_MATCHER_KERNEL(Avx512, __attribute__((target("avx512bw"))), 64, 8)
#endif

using AddFunction = std::int32_t (*)(const Chunk&, std::int32_t*);

/// Counts of some translations, as far as the cells are counted.
struct Progress {
  std::int32_t* counts;
  std::int32_t rest;       // weight of the cells to come
  std::int32_t min_count;  // that one of the translations has to reach
};

/// Counts cells of one weight, chunk by chunk, until `min_count` is out of reach for each of the translations.
bool countCells(AddFunction add, Chunk cells, Progress& progress) {
  for (std::size_t left = cells.size; left > 0;) {
    cells.size = std::min(kChunk, left);
    const std::int32_t largest = add(cells, progress.counts);
    progress.rest -= static_cast<std::int32_t>(cells.size) * cells.weight;
    if (largest + progress.rest < progress.min_count) {
      return false;
    }
    left -= cells.size;
    cells.x += cells.size;
    cells.y += cells.size;
  }
  return true;
}

bool countAll(AddFunction add, const PooledLevel& level, const RotatedCells& cells, const Cell& first,
              Progress progress) {
  progress.rest = static_cast<std::int32_t>(cells.x.size());
  return countCells(add, {&level, cells.x.data(), cells.y.data(), cells.x.size(), first, 1}, progress);
}

bool countAll(AddFunction add, const PooledLevel& level, const WeightedCells& weighted, const Cell& first,
              Progress progress) {
  progress.rest = weighted.total;
  std::size_t begin = 0;
  for (const WeightedCells::Run& run : weighted.runs) {
    const RotatedCells& cells = weighted.cells;
    if (!countCells(add, {&level, &cells.x[begin], &cells.y[begin], run.size, first, run.weight}, progress)) {
      return false;
    }
    begin += run.size;
  }
  return true;
}

}  // namespace

/// The kernel's functions for one instruction set.
struct ScoreKernel::Functions {
  AddFunction add_wide_tiles;
  AddFunction add_narrow_tiles;
  AddFunction add_children;

  AddFunction addTiles(TileShape shape) const { return shape == TileShape::kWide ? add_wide_tiles : add_narrow_tiles; }
};

namespace {

constexpr ScoreKernel::Functions kBaselineFunctions{addWideTilesBaseline, addNarrowTilesBaseline, addChildrenBaseline};
#if MAP_MATCHER_X86
constexpr ScoreKernel::Functions kAvx2Functions{addWideTilesAvx2, addNarrowTilesAvx2, addChildrenAvx2};
constexpr ScoreKernel::Functions kAvx512Functions{addWideTilesAvx512, addNarrowTilesAvx512, addChildrenAvx512};
#endif

const ScoreKernel::Functions* functionsOf(KernelVariant variant) {
#if MAP_MATCHER_X86
  switch (variant) {
    case KernelVariant::kAvx512:
      return &kAvx512Functions;
    case KernelVariant::kAvx2:
      return &kAvx2Functions;
    case KernelVariant::kBaseline:
      break;
  }
#else
  static_cast<void>(variant);
#endif
  return &kBaselineFunctions;
}

}  // namespace

std::vector<KernelVariant> availableKernelVariants() {
  std::vector<KernelVariant> variants{KernelVariant::kBaseline};
#if MAP_MATCHER_X86
  if (__builtin_cpu_supports("avx2")) {
    variants.push_back(KernelVariant::kAvx2);
  }
  if (__builtin_cpu_supports("avx512bw")) {
    variants.push_back(KernelVariant::kAvx512);
  }
#endif
  return variants;
}

ScoreKernel::ScoreKernel(KernelVariant variant) : functions_(functionsOf(variant)) {}

bool ScoreKernel::scoreTile(TileShape shape, const PooledLevel& level, const RotatedCells& cells, const Cell& first,
                            std::int32_t min_count, TileCounts& counts) const {
  counts.fill(0);
  return countAll(functions_->addTiles(shape), level, cells, first, {counts.data(), 0, min_count});
}

bool ScoreKernel::scoreTile(TileShape shape, const PooledLevel& level, const WeightedCells& cells, const Cell& first,
                            std::int32_t min_count, TileCounts& counts) const {
  counts.fill(0);
  return countAll(functions_->addTiles(shape), level, cells, first, {counts.data(), 0, min_count});
}

bool ScoreKernel::scoreChildren(const PooledLevel& level, const RotatedCells& cells, const Cell& first,
                                std::int32_t min_count, std::array<std::int32_t, 4>& counts) const {
  counts.fill(0);
  return countAll(functions_->add_children, level, cells, first, {counts.data(), 0, min_count});
}

bool ScoreKernel::scoreChildren(const PooledLevel& level, const WeightedCells& cells, const Cell& first,
                                std::int32_t min_count, std::array<std::int32_t, 4>& counts) const {
  counts.fill(0);
  return countAll(functions_->add_children, level, cells, first, {counts.data(), 0, min_count});
}

}  // namespace map_matcher
