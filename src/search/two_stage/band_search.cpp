#include "band_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace map_matcher::search {
namespace {

/// Levels that one expansion goes down: counting the 16 children of two levels takes as long as the 4 of one.
constexpr int kLevelsAtOnce = 2;

/// Levels above the initial nodes at which empty parts of a map are passed over.
constexpr int kSieveLevels = 2;

/// Tiles of a window that are scored without a look at which of them can hold anything.
constexpr std::int64_t kFewTiles = 24;

/// Tiles of nodes with a stride that a window takes.
std::int64_t numTiles(const SearchWindow& window, int stride) {
  const std::int64_t columns = (window.last.x - window.first.x) / (stride * kTileColumns) + 1;
  const std::int64_t rows = (window.last.y - window.first.y) / (stride * kTileRows) + 1;
  return columns * rows;
}

/// The smallest window that holds a translation of each score; `first` is that of their tile.
SearchWindow windowAround(const std::vector<TileScore>& scores, const grid::Cell& first, int stride) {
  SearchWindow window{everywhere().last, everywhere().first};
  for (const TileScore& score : scores) {
    const grid::Cell node{first.x + score.column * stride, first.y + score.row * stride};
    window = hull(window, {node, {node.x + stride - 1, node.y + stride - 1}});
  }
  return window;
}

}  // namespace

bool searchedAfter(const SearchProblem& problem, const SearchNode& a, const SearchNode& b) {
  const auto rank = [&problem](const SearchNode& node) {
    return problem.order.empty() ? 0 : problem.order[static_cast<std::size_t>(node.rotation)];
  };
  return std::make_tuple(-rank(a), a.bound, -a.rotation, -a.first.y, -a.first.x) <
         std::make_tuple(-rank(b), b.bound, -b.rotation, -b.first.y, -b.first.x);
}

bool BandSearch::stopped() {
  stopped_ = stopped_ || deadline_.passed();
  return stopped_;
}

/// Whether a node may be expanded; one that may not is left out.
bool BandSearch::mayExpand() {
  const bool enough = problem_.most_expansions && nodes_expanded_ >= *problem_.most_expansions / problem_.threads;
  gave_up_ = gave_up_ || enough;
  return !enough;
}

const RotatedCells& BandSearch::cellsOf(int rotation) {
  RotatedCells& cells = rotated_[static_cast<std::size_t>(rotation)];
  if (cells.x.empty()) {
    cells = problem_.cells(rotation);
  }
  return cells;
}

/// Calls work(first, size) for each tile of nodes with a stride, until the deadline passes.
template <typename Work>
void BandSearch::forEachTile(const SearchWindow& window, int stride, const Work& work) {
  for (int y = window.first.y; y <= window.last.y; y += stride * kTileRows) {
    for (int x = window.first.x; x <= window.last.x && !stopped(); x += stride * kTileColumns) {
      work(grid::Cell{x, y}, tileWithin(window.last, {x, y}, stride));
    }
  }
}

bool BandSearch::scoreBand(const RotationBand& band) {
  const auto first_new = static_cast<std::ptrdiff_t>(initial_nodes_.size());
  if (problem_.reference.topBandLevel() >= problem_.root_level && !problem_.bands.empty()) {
    scoreTogether(band);
  } else {
    for (const int rotation : band.rotations) {
      scoreRotation(rotation, reachable(windowOf(rotation), cellsOf(rotation), 0));
    }
  }
  searchBestOf(first_new);
  return !stopped();
}

/// The part of a window where enough cells can match; all of a small one, for counting takes no longer than a look.
SearchWindow BandSearch::reachable(const SearchWindow& window, const RotatedCells& cells, int reach) const {
  if (window.empty() || numTiles(window, 1 << problem_.root_level) <= kFewTiles) {
    return window;
  }
  return intersection(window, reachableWindow(problem_.reference, cells, incumbent_.threshold(), reach));
}

/// Lines 4 to 10: the rotations of a band, all translations on the stride of the root level.
void BandSearch::scoreTogether(const RotationBand& band) {
  SearchWindow window{everywhere().last, everywhere().first};
  for (const int rotation : band.rotations) {
    window = hull(window, windowOf(rotation));
  }
  band_cells_ = problem_.turned(band.middle);
  window = reachable(window, band_cells_, kBandReach);
  if (window.empty()) {
    return;
  }
  const int sieve = std::min(problem_.root_level + kSieveLevels, problem_.reference.topBandLevel());
  if (sieve > problem_.root_level && numTiles(window, 1 << problem_.root_level) > kFewTiles) {
    scoreWhereAnythingIs(band, window, sieve);
  } else {
    scoreBandWindow(band, window);
  }
}

/// Scores only tiles that hold a node of the level `sieve` which reaches the threshold: most of a large map is empty.
void BandSearch::scoreWhereAnythingIs(const RotationBand& band, const SearchWindow& window, int sieve) {
  const int finer = 1 << (sieve - problem_.root_level);
  const grid::Cell tile{kTileColumns << problem_.root_level,
                        kTileRows << problem_.root_level};  // of initial nodes [cells]
  forEachTile(window, 1 << sieve, [&](const grid::Cell& first, const TileSize& size) {
    scoreTile(problem_.reference.bandLevel(sieve), band_cells_, PrecomputedGrids::bandPosition(first), size);
    std::array<bool, 1 << (2 * kSieveLevels)> anything{};
    for (const TileScore& score : scores_) {
      const int column = score.column * finer / kTileColumns;
      const int row = score.row * finer / kTileRows;
      anything[static_cast<std::size_t>(row * finer + column)] = true;
    }
    for (int k = 0; k < finer * finer; ++k) {
      if (anything[static_cast<std::size_t>(k)]) {
        const grid::Cell part{first.x + k % finer * tile.x, first.y + k / finer * tile.y};
        scoreBandWindow(band, intersection({part, {part.x + tile.x - 1, part.y + tile.y - 1}}, window));
      }
    }
  });
}

/// Scores the rotations of a band one by one where the band reaches the threshold.
void BandSearch::scoreBandWindow(const RotationBand& band, const SearchWindow& window) {
  const int stride = 1 << problem_.root_level;
  forEachTile(window, stride, [&](const grid::Cell& first, const TileSize& size) {
    scoreTile(problem_.reference.bandLevel(problem_.root_level), band_cells_, PrecomputedGrids::bandPosition(first),
              size);
    const SearchWindow promising = windowAround(scores_, first, stride);
    for (const int rotation : band.rotations) {
      if (!promising.empty()) {
        scoreRotation(rotation, intersection(promising, windowOf(rotation)));
      }
    }
  });
}

/// Adds the initial nodes of a window that reach the threshold to the list.
void BandSearch::scoreRotation(int rotation, const SearchWindow& window) {
  const int stride = 1 << problem_.root_level;
  forEachTile(window, stride, [&](const grid::Cell& first, const TileSize& size) {
    scoreTile(problem_.reference.level(problem_.root_level), cellsOf(rotation), first, size);
    for (const TileScore& score : scores_) {
      const grid::Cell node{first.x + score.column * stride, first.y + score.row * stride};
      initial_nodes_.push_back({score.count, rotation, node, problem_.root_level});
    }
  });
}

/// Scores a tile of nodes of a level.
void BandSearch::scoreTile(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first,
                           const TileSize& size) {
  nodes_scored_ += static_cast<std::int64_t>(size.columns) * size.rows;
  kernel_.scoreTile(level, cells, first, size, incumbent_.threshold(), scores_);
}

void BandSearch::searchBestOf(std::ptrdiff_t first_new) {
  const auto best =
      std::max_element(initial_nodes_.begin() + first_new, initial_nodes_.end(),
                       [this](const SearchNode& a, const SearchNode& b) { return searchedAfter(problem_, a, b); });
  if (best == initial_nodes_.end() || best->bound <= best_initial_bound_) {
    return;
  }
  const SearchNode node = *best;
  best_initial_bound_ = node.bound;
  initial_nodes_.erase(best);
  searchBelow(node);
}

bool BandSearch::searchBelow(const SearchNode& root) {
  nodes_.assign(1, root);
  while (!nodes_.empty() && !stopped()) {
    const SearchNode node = nodes_.back();
    nodes_.pop_back();
    if (incumbent_.prunes(node)) {  // line 14
      continue;
    }
    if (node.level == 0) {  // lines 17 to 19
      incumbent_.offer({node.rotation, node.first, node.bound});
    } else if (mayExpand()) {
      expand(node);
    }
  }
  return nodes_.empty();
}

/// Lines 20 to 25, kLevelsAtOnce levels at once. The best child is searched first, hence pushed last.
void BandSearch::expand(const SearchNode& node) {
  ++nodes_expanded_;
  const int level = std::max(0, node.level - kLevelsAtOnce);
  const int stride = 1 << level;
  const int children = 1 << (node.level - level);  // along an axis
  TileSize size = tileWithin(windowOf(node.rotation).last, node.first, stride);
  size = {std::min(size.columns, children), std::min(size.rows, children)};
  scoreTile(problem_.reference.level(level), cellsOf(node.rotation), node.first, size);
  const auto first_child = static_cast<std::ptrdiff_t>(nodes_.size());
  for (const TileScore& score : scores_) {
    const grid::Cell first{node.first.x + score.column * stride, node.first.y + score.row * stride};
    nodes_.push_back({score.count, node.rotation, first, level});
  }
  std::sort(nodes_.begin() + first_child, nodes_.end(),
            [this](const SearchNode& a, const SearchNode& b) { return searchedAfter(problem_, a, b); });
}

}  // namespace map_matcher::search
