#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/search/search_frames.hpp"

namespace map_matcher::search {
namespace {

TEST(SearchFrames, HoldThePriorsBoxInTheirWindow) {
  const SearchFrames frames({1.0, 2.0, 0.0}, {});

  const SearchWindow window = frames.window(WindowPrior{{2.0, 2.5}, {0.5, 0.25}}, {0.0, 0.0}, 0.5, 0.0);

  EXPECT_EQ(window.first, (grid::Cell{1, 0}));
  EXPECT_EQ(window.last, (grid::Cell{3, 2}));
}

TEST(SearchFrames, LeaveNothingOutOfABoxWithoutEnd) {
  const SearchFrames frames({3.0, 4.0, 0.5}, {});

  for (const double size : {1e12, 1e300, 1.7e308}) {
    const SearchWindow window =
        frames.window(WindowPrior{{0.9 * size, -0.9 * size}, {size, size}}, {1.0, 2.0}, 0.1, 0.7);

    EXPECT_EQ(window.first, everywhere().first) << size;
    EXPECT_EQ(window.last, everywhere().last) << size;
  }
}

}  // namespace
}  // namespace map_matcher::search
