/// \file
/// The reference map, pooled at each level of the search (report section 3.1, figure 6; algorithm 1 line 2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/grid/grid_geometry.hpp"
#include "map_matcher/work/deadline.hpp"

namespace map_matcher::search {

/// A tile: the translations that the scoring kernel counts at once, 64 columns of 8 rows.
constexpr int kTileColumns = 64;
constexpr int kTileRows = 8;

/// A column of a tile, a bit for each row, the lowest for the first.
using TileWord = std::uint8_t;

/// Cells of a map as bytes, 1 for a wall, row-major, with room around it.
class WallArray {
 public:
  /// `margin` zeros on every side of width x height cells.
  WallArray(int width, int height, int margin);

  /// Draws a wall, in or beside the map; one beyond the margin is ignored.
  void draw(int x, int y);

  /// Lets every value stand for the cells [x, x + window) x [y, y + window), from the `old_window` it stands for.
  /// Values whose window would leave the array keep a smaller one; they lie in the margin beyond all walls. Throws
  /// DeadlinePassed when that comes before the end.
  void growWindow(int old_window, int window, const work::Deadline& deadline = work::Deadline());

  /// The row of values from x = 0 on; negative x reach into the margin.
  const std::uint8_t* row(int y) const { return values_.data() + index(0, y); }

  int margin() const { return margin_; }                                     ///< [cells]
  int width() const { return static_cast<int>(row_length_) - 2 * margin_; }  ///< Without margin [cells].
  int height() const { return static_cast<int>(num_rows_) - 2 * margin_; }   ///< Without margin [cells].

 private:
  std::ptrdiff_t index(int x, int y) const {
    return static_cast<std::ptrdiff_t>(y + margin_) * row_length_ + x + margin_;
  }
  void mergeShifted(std::ptrdiff_t shift, const work::Deadline& deadline);

  int margin_;
  std::ptrdiff_t row_length_;
  std::ptrdiff_t num_rows_;
  std::vector<std::uint8_t> values_;
};

/// One level of the pooled reference map. The value at (x, y) is 1 when a wall lies in the window
/// [x, x + 2^level) x [y, y + 2^level) and 0 otherwise: a sliding window at full resolution, so that a node's score is
/// a true upper bound for all translations it stands for.
///
/// The values are stored split into 2^level x 2^level phases. A phase holds every 2^level-th column of every 2^level-th
/// row, so that translations which are neighbours on the stride of the level are neighbours in memory. Each position
/// has a word with the values of kTileRows rows, its own and those above, so that a tile is 64 bytes in a row. Around
/// each phase lies a border of zeros as wide as a tile; positions beyond it are clamped into it, so that a tile needs
/// no range check.
class PooledLevel {
 public:
  /// Takes the values for x in [1 - 2^level, width), y alike, from `pooled`: every grain-th one along both axes, of
  /// which number (-shift, -shift) becomes (0, 0); those beyond its margin are zero. Throws std::invalid_argument for a
  /// level of more than 2 GiB, and DeadlinePassed when that comes before the end.
  PooledLevel(int level, int width, int height, const WallArray& pooled, int shift = 0, int grain = 1,
              const work::Deadline& deadline = work::Deadline());

  int level() const { return level_; }
  int stride() const { return 1 << level_; }  ///< Translations a node of this level stands for, along an axis [cells].

  /// Value at a position [cells], which may lie outside the map.
  int at(int x, int y) const { return words_[address(x, y)] & 1U; }

  /// Index of the first of the kTileColumns words of a tile: its first value is that of the position, further ones lie
  /// one stride further along x or y each.
  std::uint32_t address(int x, int y) const {
    const int mask = (1 << level_) - 1;
    const int i = clampTo(x >> level_, -kTileColumns - 1, columns_);
    const int j = clampTo(y >> level_, -kTileRows - 1, rows_);
    const int phase = ((y & mask) << level_) + (x & mask);
    return static_cast<std::uint32_t>(origin_ + phase * phase_size_ + j * row_length_ + i);
  }

  /// Index of the words of a tile without walls.
  static constexpr std::uint32_t emptyAddress() { return 0; }

  const TileWord* words() const { return words_.data(); }
  std::size_t bytes() const { return words_.size() * sizeof(TileWord); }  ///< Memory taken [bytes].

 private:
  static int clampTo(int value, int low, int high) { return value < low ? low : (value > high ? high : value); }
  void spreadRows(std::ptrdiff_t phase, const work::Deadline& deadline);

  int level_;
  int columns_;     // of a phase, without its border
  int rows_;        // of a phase, without its border
  int row_length_;  // [words]
  int phase_size_;  // [words]
  int origin_;      // address of (0, 0) in the first phase
  std::vector<TileWord> words_;
};

/// How far a session cell may lie, along an axis, from the cell that stands for it in a band of rotations [cells].
constexpr int kBandReach = 1;

/// All levels of a reference map of one resolution. Immutable, hence thread-safe.
class PrecomputedGrids {
 public:
  /// Pools the walls of a grid of width x height cells for the levels 0 to `top_level`, and for bands of rotations for
  /// the levels 0 to `top_band_level`, if that is not negative. Walls outside the grid are ignored. Throws
  /// std::invalid_argument for a size below 1 x 1, a level above 15, a negative top_level, or a map whose levels would
  /// take more than 2 GiB each, and DeadlinePassed when that comes before the end.
  PrecomputedGrids(int width, int height, const std::vector<grid::Cell>& walls, int top_level, int top_band_level = -1,
                   const work::Deadline& deadline = work::Deadline());

  int width() const { return width_; }    ///< [cells]
  int height() const { return height_; }  ///< [cells]
  int topLevel() const { return static_cast<int>(levels_.size()) - 1; }
  const PooledLevel& level(int level) const { return levels_[static_cast<std::size_t>(level)]; }

  /// Like level(), but windows reach kBandReach cells farther on all sides. The value at bandPosition({x, y}) tells
  /// whether a wall lies in [x - kBandReach, x + 2^level + kBandReach), y alike.
  const PooledLevel& bandLevel(int level) const { return band_levels_[static_cast<std::size_t>(level)]; }
  int topBandLevel() const { return static_cast<int>(band_levels_.size()) - 1; }
  static grid::Cell bandPosition(const grid::Cell& first) { return {first.x + kBandReach, first.y + kBandReach}; }

  /// Smallest box of cells that holds all walls; without walls it is empty: last < first.
  const grid::Cell& firstWall() const { return first_wall_; }  ///< Lower left cell of the box.
  const grid::Cell& lastWall() const { return last_wall_; }    ///< Upper right cell of the box.
  std::size_t bytes() const;                                   ///< Memory taken [bytes].

 private:
  int width_;
  int height_;
  grid::Cell first_wall_;
  grid::Cell last_wall_;
  std::vector<PooledLevel> levels_;
  std::vector<PooledLevel> band_levels_;
};

}  // namespace map_matcher::search
