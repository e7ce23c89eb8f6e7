/// \file
/// The part of a branch and bound that one thread does.
#pragma once

#include <cstdint>
#include <vector>

#include "../exact/incumbent.hpp"
#include "map_matcher/search/counting/score_kernel.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"

namespace map_matcher::search {

/// Whether `a` is searched after `b`: by rank, then by bound. Total, so that one thread searches in the same order on
/// every run.
bool searchedAfter(const SearchProblem& problem, const SearchNode& a, const SearchNode& b);

/// Work of one thread: scores initial nodes, band by band, and searches below them.
class BandSearch {
 public:
  BandSearch(const SearchProblem& problem, const work::Deadline& deadline, Incumbent& incumbent)
      : problem_(problem), deadline_(deadline), incumbent_(incumbent), rotated_(problem.windows.size()) {}

  /// Scores the initial nodes of a band, and searches at once below the best of them if none before was as good: a high
  /// threshold early on keeps most nodes out of the list. (The report sorts the complete list first.) False when the
  /// deadline passed before the end.
  bool scoreBand(const RotationBand& band);

  /// Lines 12 to 27 of algorithm 1 for one initial node. False when the deadline passed before the end.
  bool searchBelow(const SearchNode& root);

  /// Whether this thread has done its share of SearchProblem::most_expansions and left nodes out since.
  bool gaveUp() const { return gave_up_; }

  /// Those that reached the threshold and were not searched yet.
  const std::vector<SearchNode>& initialNodes() const { return initial_nodes_; }

  std::int64_t nodesScored() const { return nodes_scored_; }
  std::int64_t nodesExpanded() const { return nodes_expanded_; }

 private:
  bool stopped();
  bool mayExpand();
  const RotatedCells& cellsOf(int rotation);
  const SearchWindow& windowOf(int rotation) const { return problem_.windows[static_cast<std::size_t>(rotation)]; }
  SearchWindow reachable(const SearchWindow& window, const RotatedCells& cells, int reach) const;
  void scoreTogether(const RotationBand& band);
  void scoreWhereAnythingIs(const RotationBand& band, const SearchWindow& window, int sieve);
  void scoreBandWindow(const RotationBand& band, const SearchWindow& window);
  void scoreRotation(int rotation, const SearchWindow& window);
  void scoreTile(const PooledLevel& level, const RotatedCells& cells, const grid::Cell& first, const TileSize& size);
  void searchBestOf(std::ptrdiff_t first_new);
  void expand(const SearchNode& node);

  template <typename Work>
  void forEachTile(const SearchWindow& window, int stride, const Work& work);

  const SearchProblem& problem_;
  const work::Deadline& deadline_;
  Incumbent& incumbent_;
  ScoreKernel kernel_;
  std::vector<RotatedCells> rotated_;  // the cells under each rotation; empty until they are needed
  RotatedCells band_cells_;            // the same at the middle of the band
  std::vector<SearchNode> initial_nodes_;
  std::vector<SearchNode> nodes_;
  std::vector<TileScore> scores_;  // of the last tile
  std::int32_t best_initial_bound_ = 0;
  bool stopped_ = false;
  bool gave_up_ = false;
  std::int64_t nodes_scored_ = 0;
  std::int64_t nodes_expanded_ = 0;
};

}  // namespace map_matcher::search
