#include <gtest/gtest.h>

#include <system_error>

#include "map_matcher/search/reference.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "support/ascii_map.hpp"
#include "support/cut.hpp"
#include "support/no_threads.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.05;

grid::OccupancyGrid smallMap() { return test::asciiMap({"####..#", "#.....#", "#..#..#", "#######"}, kResolution); }

TEST(SearchReference, IsGivenUpAtEveryLookAtItsDeadlineOrWhole) {
  const grid::OccupancyGrid map = smallMap();
  const SearchOptions options;
  for (const double resolution : {kResolution, 0.08}) {
    long look = 0;
    for (bool whole = false; !whole;) {
      const test::Cut cut(++look);
      try {
        const SearchReference reference(map, resolution, options, cut.deadline());
        whole = true;
        EXPECT_TRUE(reference.hasWalls());
      } catch (const work::DeadlinePassed&) {
        EXPECT_TRUE(cut.reached());
      }
    }
    EXPECT_GT(look, 50);
  }
}

TEST(Reference, IsBuiltOnceForSessionMapsThatAreNotCoarser) {
  const Reference reference(smallMap(), {});

  const Reference::Prepared first = reference.at(kResolution);
  const Reference::Prepared finer = reference.at(0.02);

  EXPECT_EQ(first.map, finer.map);
  EXPECT_EQ(first.map->resolution(), kResolution);
  EXPECT_GT(first.time, 0.0);
}

TEST(Reference, IsBuiltAgainForCoarserOnes) {
  const Reference reference(smallMap(), {});

  EXPECT_EQ(reference.at(0.1).map->resolution(), 0.1);
  EXPECT_EQ(reference.at(kResolution).map->resolution(), kResolution);
}

TEST(Reference, KeepsWhatItHasWhenItIsStopped) {
  const Reference reference(smallMap(), {});
  work::StopToken stop;
  stop.requestStop();
  EXPECT_FALSE(reference.at(kResolution, stop).map);
  const Reference::Prepared before = reference.at(kResolution);

  EXPECT_FALSE(reference.at(0.1, stop).map);
  EXPECT_EQ(reference.at(kResolution, stop).map, before.map);
}

TEST(Reference, KeepsWhatItHasWhenBuildingThrows) {
  const Reference reference(smallMap(), {});
  {
    const test::NoThreads no_threads;
    EXPECT_THROW(reference.at(kResolution), std::system_error);
  }
  const Reference::Prepared before = reference.at(kResolution);
  {
    const test::NoThreads no_threads;
    EXPECT_THROW(reference.at(0.1), std::system_error);
  }

  EXPECT_EQ(reference.at(kResolution).map, before.map);
}

}  // namespace
}  // namespace map_matcher::search
