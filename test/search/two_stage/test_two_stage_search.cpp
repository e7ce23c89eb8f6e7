#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/counting/session_cells.hpp"
#include "map_matcher/search/two_stage/branch_and_bound.hpp"
#include "map_matcher/search/two_stage/two_stage_search.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

TEST(NearestHalving, IsTheDoublingOfTheResolutionNearestToTheCoarseResolution) {
  EXPECT_DOUBLE_EQ(nearestHalving(0.02, 0.2), 0.16);
  EXPECT_DOUBLE_EQ(nearestHalving(0.05, 0.2), 0.2);
  EXPECT_DOUBLE_EQ(nearestHalving(0.025, 0.2), 0.2);
  EXPECT_DOUBLE_EQ(nearestHalving(0.1, 0.2), 0.2);
  EXPECT_DOUBLE_EQ(nearestHalving(0.05, 0.05), 0.05);
  EXPECT_DOUBLE_EQ(nearestHalving(0.5, 0.2), 0.5);  // never finer than the map
}

TEST(FineWindow, CoversWhatACoarseCellAndAnAngularStepCanHide) {
  // 1 + sqrt(1/2) + 2/2 coarse cells of 8 cells each, and one angular step.
  const FineWindow window = fineWindow(8.0, 2.0, 0.01);

  EXPECT_EQ(window.half_width, 22);
  EXPECT_DOUBLE_EQ(window.rotation_half_width, 0.01);
}

/// Session cells of the fine stage under a pose, as whole cells of the reference: those that the coarse stage sees on a
/// wall of the same coarse cell must have the fine answer within the derived window.
TEST(FineWindow, HoldsTheTruePoseOfEveryCellThatTheCoarseStageMatched) {
  constexpr int kCellsPerCoarseCell = 4;
  constexpr double kDownsampling = 2.0;
  std::mt19937 random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    // A session cell at p (fine cells from the centre, on a lattice), the point of its coarse cell (anywhere in it),
    // and a true pose.
    const double half_diagonal = 100.0;  // in coarse cells: 25
    const double step = kDownsampling / (2.0 * half_diagonal / kCellsPerCoarseCell);
    const Eigen::Vector2d p(test::randomReal(random, -70.0, 70.0), test::randomReal(random, -70.0, 70.0));
    const Eigen::Vector2d point =
        p + Eigen::Vector2d(test::randomReal(random, -2.0, 2.0), test::randomReal(random, -2.0, 2.0));
    const double true_yaw = test::randomReal(random, -3.0, 3.0);
    const double coarse_yaw = true_yaw + test::randomReal(random, -step, step);
    const Eigen::Vector2d t(test::randomReal(random, 0.0, 4.0), test::randomReal(random, 0.0, 4.0));
    const Eigen::Vector2d wall = grid::Rigid2{t.x(), t.y(), true_yaw} * p;  // where the true pose puts the cell

    // Every coarse translation, in fine cells, that puts the coarse cell's point into the wall's coarse cell:
    const Eigen::Vector2d wall_cell = (wall / kCellsPerCoarseCell).array().floor();
    const Eigen::Vector2d rotated = grid::Rigid2{0.0, 0.0, coarse_yaw} * point / kCellsPerCoarseCell;
    const Eigen::Vector2d coarse_t = (wall_cell - Eigen::Vector2d(rotated.array().floor())) * kCellsPerCoarseCell;

    const FineWindow window = fineWindow(kCellsPerCoarseCell, kDownsampling, step);
    ASSERT_LE((coarse_t - t).cwiseAbs().maxCoeff(), window.half_width) << "trial " << trial;
  }
}

TEST(TwoStageSearch, FineStageIsAsGoodAsASearchOfAMuchLargerWindow) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const grid::OccupancyGrid map = test::randomBuilding(random, 16.0, 10.0, 0.05);
    const grid::Rigid2 truth{1.0, 2.0, test::randomReal(random, -3.0, 3.0)};
    const grid::OccupancyGrid session = test::cutSession(map, {8.0, 5.0}, 6.0, truth, 0.05);
    const SearchOptions options;
    const SearchReference reference(map, 0.05, options);

    const SearchResult result = twoStageSearch(reference, searchSession(session, reference.resolution(), options),
                                               options, {}, work::Deadline());

    ASSERT_TRUE(result.found);
    // All translations of the whole map, within three coarse steps of the answer's rotation.
    const SessionCells cells = prepareSessionCells(grid::occupiedCells(session), 0.05, 0.05, CellMerging::kNone, 0);
    SearchProblem problem{reference.fine(), {}, {}, {}, 1, SearchReference::kFineRootLevel};
    const double step = rotationStep(1.0, cells.diagonal);
    const std::vector<double> angles = rotationsAround(result.T_reference_session.yaw, 24.0 * step, step);
    problem.cells = [&](int n) { return rotate(cells, angles[static_cast<std::size_t>(n)]); };
    problem.windows.assign(angles.size(), {{-400, -400}, {800, 800}});
    EXPECT_EQ(branchAndBound(problem).best->count, result.matched_cells);
  }
}

}  // namespace
}  // namespace map_matcher::search
