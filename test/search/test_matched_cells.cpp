#include <gtest/gtest.h>

#include <string>

#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/matched_cells.hpp"
#include "support/ascii_map.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.05;

grid::OccupancyGrid withOrigin(const grid::OccupancyGrid& map, const grid::Rigid2& origin) {
  grid::GridGeometry geometry = map.geometry();
  geometry.T_map_grid = origin * geometry.T_map_grid;
  return {geometry, map.values()};
}

TEST(SplitByMatch, ShowsTheCellsAsMatchedThatTheSearchCounted) {
  const double offsets[] = {0.0, 0.5, -0.5, 1.0};
  int differs = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    SearchOptions options;
    options.min_session_cells = 50;
    options.session_map_cell_offset = offsets[seed % 4];
    options.reference_map_cell_offset = offsets[(seed + seed / 4 + 1) % 4];
    const grid::OccupancyGrid reference =
        test::randomBuilding(random, 30.0, 14.0, kResolution, {3.0, -2.0, test::randomReal(random, -3.0, 3.0)});
    const Eigen::Vector2d centre = reference.geometry().T_map_grid * Eigen::Vector2d(14.0, 7.0);
    const grid::Rigid2 truth{test::randomReal(random, -9.0, 9.0), 1.0, test::randomReal(random, -3.0, 3.0)};
    const double session_resolution = seed % 3 == 2 ? 2.0 * kResolution : kResolution;
    const grid::OccupancyGrid session = withOrigin(test::cutSession(reference, centre, 8.0, truth, session_resolution),
                                                   {0.3, -1.0, seed % 2 == 0 ? 0.4 : -2.0});
    const SearchResult result = MapMatcher(options).match(Reference(reference, options), session);
    ASSERT_TRUE(result.found) << result.reason;

    const MatchedCells cells = splitByMatch(reference, session, result.T_reference_session, options);

    EXPECT_EQ(static_cast<int>(cells.matched.size()), result.matched_cells);
    EXPECT_EQ(static_cast<int>(cells.matched.size() + cells.unmatched.size()), result.total_cells);
    const MatchedCells without = splitByMatch(reference, session, result.T_reference_session);
    differs += without.matched.size() != cells.matched.size() ? 1 : 0;
  }
  EXPECT_GT(differs, 4);
}

TEST(SplitByMatch, TellsWhereTheCellsAreAndNotWhereTheyWereDrawn) {
  const grid::OccupancyGrid map = test::asciiMap({"..", "#."}, 0.1);
  SearchOptions options;
  options.session_map_cell_offset = 0.5;
  options.reference_map_cell_offset = 0.5;

  const MatchedCells cells = splitByMatch(map, map, {}, options);

  ASSERT_EQ(cells.matched.size(), 1U);
  EXPECT_LT((cells.matched[0] - Eigen::Vector2d(0.0, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace map_matcher::search
