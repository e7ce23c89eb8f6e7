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

/// Cells that fit into 8-bit counters before they must be widened.
constexpr std::size_t kChunk = 255;

/// Vector types of GCC and clang: portable, and split by the compiler where the processor's registers are narrower.
template <int kBytes>
struct ByteVector {
  typedef std::uint8_t type __attribute__((vector_size(kBytes)));
};

/// Adds the bytes of the tiles at `addresses` (at most kChunk) to the 32-bit counts. Eight-bit counters in registers,
/// so that one addition serves as many translations as a register has bytes; benchmark: BM_TileScorer.
template <int kVectorBytes>
__attribute__((always_inline)) inline void addTiles(const std::uint8_t* values, std::ptrdiff_t row_stride,
                                                    const std::uint32_t* addresses, std::size_t num_addresses,
                                                    std::int32_t* counts) {
  using Vector = typename ByteVector<kVectorBytes>::type;
  constexpr int kVectorsPerRow = kTileColumns / kVectorBytes;
  Vector sums[kTileRows][kVectorsPerRow] = {};
  for (std::size_t k = 0; k < num_addresses; ++k) {
    const std::uint8_t* tile = values + addresses[k];
    for (int row = 0; row < kTileRows; ++row) {
      for (int v = 0; v < kVectorsPerRow; ++v) {
        Vector bytes;
        std::memcpy(&bytes, tile + row * row_stride + v * kVectorBytes, sizeof(bytes));
        sums[row][v] += bytes;
      }
    }
  }
  std::uint8_t narrow[kTileRows * kTileColumns];
  std::memcpy(narrow, sums, sizeof(narrow));
  for (int i = 0; i < kTileRows * kTileColumns; ++i) {
    counts[i] += narrow[i];
  }
}

using AddTiles = void (*)(const std::uint8_t*, std::ptrdiff_t, const std::uint32_t*, std::size_t, std::int32_t*);

void addTilesBaseline(const std::uint8_t* values, std::ptrdiff_t row_stride, const std::uint32_t* addresses,
                      std::size_t num_addresses, std::int32_t* counts) {
  addTiles<16>(values, row_stride, addresses, num_addresses, counts);
}

#if MAP_MATCHER_X86
__attribute__((target("avx2"))) void addTilesAvx2(const std::uint8_t* values, std::ptrdiff_t row_stride,
                                                  const std::uint32_t* addresses, std::size_t num_addresses,
                                                  std::int32_t* counts) {
  addTiles<32>(values, row_stride, addresses, num_addresses, counts);
}

__attribute__((target("avx512bw"))) void addTilesAvx512(const std::uint8_t* values, std::ptrdiff_t row_stride,
                                                        const std::uint32_t* addresses, std::size_t num_addresses,
                                                        std::int32_t* counts) {
  addTiles<64>(values, row_stride, addresses, num_addresses, counts);
}
#endif

AddTiles kernelFor(KernelVariant variant) {
#if MAP_MATCHER_X86
  switch (variant) {
    case KernelVariant::kAvx512:
      return addTilesAvx512;
    case KernelVariant::kAvx2:
      return addTilesAvx2;
    case KernelVariant::kBaseline:
      break;
  }
#else
  static_cast<void>(variant);
#endif
  return addTilesBaseline;
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

TileScorer::TileScorer(KernelVariant variant) : variant_(variant) {}

bool TileScorer::score(const PooledLevel& level, const RotatedCells& cells, const Cell& first, std::int32_t min_count,
                       TileCounts& counts) {
  const AddTiles add_tiles = kernelFor(variant_);
  const std::size_t num_cells = cells.x.size();
  addresses_.resize(kChunk);
  counts.fill(0);
  for (std::size_t begin = 0; begin < num_cells; begin += kChunk) {
    const std::size_t size = std::min(kChunk, num_cells - begin);
    for (std::size_t k = 0; k < size; ++k) {
      addresses_[k] = level.address(cells.x[begin + k] + first.x, cells.y[begin + k] + first.y);
    }
    add_tiles(level.data(), level.rowStride(), addresses_.data(), size, counts.data());
    const auto rest = static_cast<std::int32_t>(num_cells - begin - size);
    if (*std::max_element(counts.begin(), counts.end()) + rest < min_count) {
      return false;
    }
  }
  return true;
}

bool scoreChildren(const PooledLevel& level, const RotatedCells& cells, const Cell& first, std::int32_t min_count,
                   std::array<std::int32_t, 4>& counts) {
  const std::size_t num_cells = cells.x.size();
  counts.fill(0);
  for (std::size_t begin = 0; begin < num_cells; begin += kChunk) {
    const std::size_t end = std::min(begin + kChunk, num_cells);
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint8_t* tile = level.data() + level.address(cells.x[k] + first.x, cells.y[k] + first.y);
      counts[0] += tile[0];
      counts[1] += tile[1];
      counts[2] += tile[level.rowStride()];
      counts[3] += tile[level.rowStride() + 1];
    }
    if (*std::max_element(counts.begin(), counts.end()) + static_cast<std::int32_t>(num_cells - end) < min_count) {
      return false;
    }
  }
  return true;
}

}  // namespace map_matcher
