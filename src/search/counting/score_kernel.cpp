#include "map_matcher/search/counting/score_kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "bit_adders.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define MAP_MATCHER_X86 1
#else
#define MAP_MATCHER_X86 0
#endif

namespace map_matcher::search {
namespace {

/// Cells that are counted before a hopeless tile is given up.
constexpr std::size_t kChunk = 128;

/// Digits of a large tree of carry-save adders, for most of a chunk, and of a small one, for the rest. Beyond its own
/// digits a tree carries through those in memory, which a large one does seldom.
constexpr int kLargeTree = 6;
constexpr int kSmallTree = 4;

/// Binary digits of a count.
constexpr int kMaxDigits = 32;

/// Counts of all translations of a tile, one binary digit after the other.
struct TileCounts {
  std::array<TileBits, kMaxDigits> digits;
  int size = 0;  // digits in use; those above, as many as a tree has, are zero
};

/// Up to kChunk cells and where their first translation lies.
struct Chunk {
  const PooledLevel* level;
  const std::int16_t* x;
  const std::int16_t* y;
  std::size_t size;
  grid::Cell first;
  int digit;  // each cell counts 2^digit times
};

/// Where the chunk's tiles begin, filled up to whole small trees. Inlined into each variant, so that its vector
/// instructions compute them. Returns how many there are.
MAP_MATCHER_INLINE std::size_t computeAddresses(const Chunk& chunk, std::uint32_t* addresses) {
  const PooledLevel& level = *chunk.level;
  for (std::size_t k = 0; k < chunk.size; ++k) {
    addresses[k] = level.address(chunk.x[k] + chunk.first.x, chunk.y[k] + chunk.first.y);
  }
  std::size_t size = chunk.size;
  for (; size % AdderTree<kSmallTree>::kTiles != 0; ++size) {
    addresses[size] = PooledLevel::emptyAddress();
  }
  return size;
}

/// Adds the tiles of a chunk to the counts: each bit of a register is one translation (benchmark: BM_ScoreTile).
template <int kVectorBytes>
MAP_MATCHER_INLINE void addTiles(const Chunk& chunk, TileCounts& counts) {
  using Vector = typename BitVector<kVectorBytes>::type;
  std::uint32_t addresses[kChunk];
  const std::size_t size = computeAddresses(chunk, addresses);
  const std::size_t large_trees = size / AdderTree<kLargeTree>::kTiles;
  const std::size_t rest = large_trees * AdderTree<kLargeTree>::kTiles;
  const std::size_t small_trees = (size - rest) / AdderTree<kSmallTree>::kTiles;
  const TileWord* words = chunk.level->words();
  TileBits* digits = &counts.digits[static_cast<std::size_t>(chunk.digit)];
  const int num_digits = counts.size - chunk.digit;
  for (std::size_t part = 0; part < kTileBytes; part += kVectorBytes) {
    addTrees<kLargeTree, Vector>(words, addresses, large_trees, part, digits, num_digits);
    addTrees<kSmallTree, Vector>(words, addresses + rest, small_trees, part, digits, num_digits);
  }
}

/// Adds counts, `times` over.
template <int kVectorBytes>
MAP_MATCHER_INLINE void addTimes(const TileCounts& part_counts, std::uint32_t times, TileCounts& counts) {
  using Vector = typename BitVector<kVectorBytes>::type;
  for (std::size_t part = 0; part < kTileBytes; part += kVectorBytes) {
    for (int shift = 0; (times >> shift) != 0; ++shift) {
      if ((times >> shift & 1U) == 0) {
        continue;
      }
      Vector carry = {};
      for (int digit = shift; digit < counts.size; ++digit) {
        Vector sum;
        load(counts.digits[static_cast<std::size_t>(digit)].data(), part, sum);
        Vector more = {};
        if (digit - shift < part_counts.size) {
          load(part_counts.digits[static_cast<std::size_t>(digit - shift)].data(), part, more);
        }
        Vector next;
        addDigits(sum, next, more, carry);
        carry = next;
        store(sum, part, counts.digits[static_cast<std::size_t>(digit)].data());
      }
    }
  }
}

/// Which translations reach a number: from the highest digit on, a count is larger at its first digit that is.
template <int kVectorBytes>
MAP_MATCHER_INLINE void findReaching(const TileCounts& counts, std::uint32_t number, TileBits& reaching) {
  using Vector = typename BitVector<kVectorBytes>::type;
  for (std::size_t part = 0; part < kTileBytes; part += kVectorBytes) {
    Vector larger = {};
    Vector equal = ~larger;
    for (int digit = counts.size - 1; digit >= 0; --digit) {
      Vector bits;
      load(counts.digits[static_cast<std::size_t>(digit)].data(), part, bits);
      if ((number >> digit & 1U) != 0) {
        equal &= bits;
      } else {
        larger |= equal & bits;
        equal &= ~bits;
      }
    }
    store(larger | equal, part, reaching.data());
  }
}

/// The counts of a column of a tile.
using ColumnCounts = std::array<std::int32_t, kTileRows>;

MAP_MATCHER_INLINE void readColumn(const TileCounts& counts, int column, ColumnCounts& result) {
  result = {};
  for (int digit = 0; digit < counts.size; ++digit) {
    const unsigned bits = counts.digits[static_cast<std::size_t>(digit)][static_cast<std::size_t>(column)];
    for (unsigned row = 0; row < kTileRows; ++row) {
      result[row] |= static_cast<std::int32_t>((bits >> row & 1U) << digit);
    }
  }
}

// The same functions for each instruction set.
// NOLINTBEGIN(bugprone-macro-parentheses): an attribute cannot stand in parentheses.
#define MAP_MATCHER_KERNEL(SUFFIX, TARGET, BYTES)                                                          \
  TARGET void addTiles##SUFFIX(const Chunk& chunk, TileCounts& counts) { addTiles<BYTES>(chunk, counts); } \
  TARGET void addTimes##SUFFIX(const TileCounts& part, std::uint32_t times, TileCounts& counts) {          \
    addTimes<BYTES>(part, times, counts);                                                                  \
  }                                                                                                        \
  TARGET void findReaching##SUFFIX(const TileCounts& counts, std::uint32_t number, TileBits& reaching) {   \
    findReaching<BYTES>(counts, number, reaching);                                                         \
  }                                                                                                        \
  TARGET void readColumn##SUFFIX(const TileCounts& counts, int column, ColumnCounts& result) {             \
    readColumn(counts, column, result);                                                                    \
  }

// NOLINTEND(bugprone-macro-parentheses)
MAP_MATCHER_KERNEL(Baseline, , 16)
#if MAP_MATCHER_X86
MAP_MATCHER_KERNEL(Avx2, __attribute__((target("avx2"))), 32)
MAP_MATCHER_KERNEL(Avx512, __attribute__((target("avx512bw"))), 64)
#endif

}  // namespace

/// The kernel's functions for one instruction set.
struct ScoreKernel::Functions {
  void (*add_tiles)(const Chunk&, TileCounts&);
  void (*add_times)(const TileCounts&, std::uint32_t, TileCounts&);
  void (*find_reaching)(const TileCounts&, std::uint32_t, TileBits&);
  void (*read_column)(const TileCounts&, int, ColumnCounts&);
};

namespace {

constexpr ScoreKernel::Functions kBaselineFunctions{addTilesBaseline, addTimesBaseline, findReachingBaseline,
                                                    readColumnBaseline};
#if MAP_MATCHER_X86
constexpr ScoreKernel::Functions kAvx2Functions{addTilesAvx2, addTimesAvx2, findReachingAvx2, readColumnAvx2};
constexpr ScoreKernel::Functions kAvx512Functions{addTilesAvx512, addTimesAvx512, findReachingAvx512, readColumnAvx512};
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

int numDigits(std::uint32_t number) {
  int digits = 0;
  for (; number > 0; number >>= 1U) {
    ++digits;
  }
  return digits;
}

TileMask maskOf(const TileSize& size) {
  TileMask mask{};
  std::fill_n(mask.begin(), size.columns, static_cast<TileWord>((1U << static_cast<unsigned>(size.rows)) - 1U));
  return mask;
}

/// Counting one tile.
class TileCounting {
 public:
  TileCounting(const ScoreKernel::Functions& functions, const PooledLevel& level, const grid::Cell& first,
               const TileMask& wanted, std::int32_t total, std::int32_t min_count)
      : functions_(functions),
        level_(level),
        first_(first),
        total_(total),
        rest_(total),
        min_count_(std::max(0, min_count)),
        wanted_(wanted) {
    counts_.size = numDigits(static_cast<std::uint32_t>(total));
    std::fill_n(counts_.digits.begin(), std::min(kMaxDigits, counts_.size + kLargeTree), TileBits{});
  }

  /// Counts cells that count `weight` times each, until min_count is out of reach.
  bool add(const std::int16_t* x, const std::int16_t* y, std::size_t size, std::int32_t weight) {
    const int digit = numDigits(static_cast<std::uint32_t>(weight)) - 1;
    for (std::size_t begin = 0; begin < size; begin += kChunk) {
      const std::size_t chunk_size = std::min(kChunk, size - begin);
      if (weight == 1 << digit) {
        functions_.add_tiles({&level_, x + begin, y + begin, chunk_size, first_, digit}, counts_);
      } else {
        addTimes({&level_, x + begin, y + begin, chunk_size, first_, 0}, weight);
      }
      rest_ -= static_cast<std::int32_t>(chunk_size) * weight;
      if (rest_ < min_count_ && !anyReaches(min_count_ - rest_)) {
        return false;
      }
    }
    return true;
  }

  /// The translations that reach min_count, when all cells were counted.
  void collect(std::vector<TileScore>& scores) {
    if (!anyReaches(min_count_)) {
      return;
    }
    for (int column = 0; column < kTileColumns; ++column) {
      const TileWord rows = reaching_[static_cast<std::size_t>(column)];
      if (rows == 0) {
        continue;
      }
      ColumnCounts column_counts;
      functions_.read_column(counts_, column, column_counts);
      for (int row = 0; row < kTileRows; ++row) {
        if ((rows >> row & 1) != 0) {
          scores.push_back({column, row, column_counts[static_cast<std::size_t>(row)]});
        }
      }
    }
  }

  /// The largest count: from the highest digit on, those translations stay in the running that have it, if any has.
  std::int32_t best() const {
    TileBits candidates = wanted_;
    std::int32_t count = 0;
    for (int digit = counts_.size - 1; digit >= 0; --digit) {
      TileBits with = counts_.digits[static_cast<std::size_t>(digit)];
      if (keep(candidates, with)) {
        candidates = with;
        count |= 1 << digit;
      }
    }
    return count;
  }

 private:
  /// Counts a chunk once and adds it so many times.
  void addTimes(const Chunk& chunk, std::int32_t weight) {
    TileCounts once;
    once.size = numDigits(static_cast<std::uint32_t>(chunk.size));
    std::fill_n(once.digits.begin(), once.size + kLargeTree, TileBits{});
    functions_.add_tiles(chunk, once);
    functions_.add_times(once, static_cast<std::uint32_t>(weight), counts_);
  }

  /// Whether any wanted translation has that many already.
  bool anyReaches(std::int32_t number) {
    if (number > total_) {
      return false;
    }
    functions_.find_reaching(counts_, static_cast<std::uint32_t>(number), reaching_);
    return keep(wanted_, reaching_);
  }

  /// Keeps of `bits` what is wanted as well; whether anything is.
  static bool keep(const TileBits& wanted, TileBits& bits) {
    unsigned any = 0;
    for (std::size_t column = 0; column < bits.size(); ++column) {
      bits[column] = static_cast<TileWord>(bits[column] & wanted[column]);
      any |= bits[column];
    }
    return any != 0;
  }

  const ScoreKernel::Functions& functions_;
  const PooledLevel& level_;
  grid::Cell first_;
  std::int32_t total_;  // of all cells
  std::int32_t rest_;   // that the cells to come add at most
  std::int32_t min_count_;
  TileCounts counts_;
  TileMask wanted_;
  TileBits reaching_{};
};

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

void ScoreKernel::scoreTile(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first,
                            const TileSize& size, std::int32_t min_count, std::vector<TileScore>& scores) const {
  scores.clear();
  const auto total = static_cast<std::int32_t>(cells.x.size());
  TileCounting counting(*functions_, level, first, maskOf(size), total, min_count);
  if (counting.add(cells.x.data(), cells.y.data(), cells.x.size(), 1)) {
    counting.collect(scores);
  }
}

void ScoreKernel::scoreTile(const PooledLevel& level, const WeightedCells& cells, const grid::Cell& first,
                            const TileSize& size, std::int32_t min_count, std::vector<TileScore>& scores) const {
  scorePart(level, cells, first, maskOf(size), min_count, scores);
}

void ScoreKernel::scorePart(const PooledLevel& level, const WeightedCells& cells, const grid::Cell& first,
                            const TileMask& wanted, std::int32_t min_count, std::vector<TileScore>& scores) const {
  scores.clear();
  TileCounting counting(*functions_, level, first, wanted, cells.total, min_count);
  std::size_t begin = 0;
  for (const WeightedCells::Run& run : cells.runs) {
    if (!counting.add(&cells.cells.x[begin], &cells.cells.y[begin], run.size, run.weight)) {
      return;
    }
    begin += run.size;
  }
  counting.collect(scores);
}

std::int32_t ScoreKernel::bestCount(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first,
                                    const TileSize& size) const {
  TileCounting counting(*functions_, level, first, maskOf(size), static_cast<std::int32_t>(cells.x.size()), 0);
  counting.add(cells.x.data(), cells.y.data(), cells.x.size(), 1);
  return counting.best();
}

}  // namespace map_matcher::search
