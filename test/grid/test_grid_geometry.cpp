#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include "map_matcher/grid/grid_geometry.hpp"

namespace map_matcher::grid {
namespace {

TEST(GridGeometry, PutsTheFirstCellsCornerAtTheOrigin) {
  const GridGeometry geometry{0.5, 4, 3, {10.0, -5.0, 0.0}};

  EXPECT_TRUE(geometry.cellCentre({0, 0}).isApprox(Eigen::Vector2d(10.25, -4.75)));
  EXPECT_EQ(geometry.cellAt({10.0, -5.0}), (Cell{0, 0}));
  EXPECT_EQ(geometry.cellAt({10.499, -4.501}), (Cell{0, 0}));
  EXPECT_EQ(geometry.cellAt({10.5, -4.5}), (Cell{1, 1}));
}

TEST(GridGeometry, FloorsBelowTheOrigin) {
  const GridGeometry geometry{1.0, 2, 2, {}};

  EXPECT_EQ(geometry.cellAt({-0.001, -1.001}), (Cell{-1, -2}));
}

TEST(GridGeometry, TurnsTheCellsWithTheOriginsYaw) {
  const GridGeometry geometry{1.0, 5, 5, {2.0, 3.0, M_PI / 2.0}};  // columns run along +y, rows along -x

  EXPECT_TRUE(geometry.cellCentre({3, 0}).isApprox(Eigen::Vector2d(1.5, 6.5)));
  EXPECT_TRUE(geometry.cellCentre({0, 3}).isApprox(Eigen::Vector2d(-1.5, 3.5)));
}

TEST(GridGeometry, FindsEveryCellByItsCentreForAnyOrigin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-50.0, 50.0);
  std::uniform_int_distribution<int> index(-2000, 2000);
  for (int trial = 0; trial < 1000; ++trial) {
    const GridGeometry geometry{0.02, 100, 100, {number(random), number(random), number(random)}};
    const Cell cell{index(random), index(random)};

    EXPECT_EQ(geometry.cellAt(geometry.cellCentre(cell)), cell) << "trial " << trial;
  }
}

TEST(GridGeometry, PutsAPointThatIsTooFarOffForACellOnItsSide) {
  const GridGeometry geometry{0.05, 100, 100, {}};

  EXPECT_EQ(geometry.cellAt({1e300, -1e300}), (Cell{kFarthestCell, -kFarthestCell}));
  EXPECT_EQ(geometry.cellAt({-1e9, 2.01}), (Cell{-kFarthestCell, 40}));
  EXPECT_FALSE(geometry.contains(geometry.cellAt({std::nan(""), 2.0})));
}

TEST(GridGeometry, ContainsExactlyItsCells) {
  const GridGeometry geometry{1.0, 3, 2, {}};

  EXPECT_TRUE(geometry.contains({0, 0}));
  EXPECT_TRUE(geometry.contains({2, 1}));
  EXPECT_FALSE(geometry.contains({3, 1}));
  EXPECT_FALSE(geometry.contains({2, 2}));
  EXPECT_FALSE(geometry.contains({-1, 0}));
  EXPECT_FALSE(geometry.contains({0, -1}));
}

/// Expects that a geometry is refused with a message that holds `named`.
void expectRefused(const GridGeometry& geometry, const std::string& named) {
  try {
    geometry.validate();
    FAIL() << "accepted; expected a message with '" << named << "'";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
  }
}

TEST(GridGeometry, AcceptsTheSmallestAndTheLargestGrid) {
  EXPECT_NO_THROW((GridGeometry{1e-6, 1, 1, {}}.validate()));
  EXPECT_NO_THROW((GridGeometry{0.05, std::numeric_limits<int>::max(), 1, {}}.validate()));
}

TEST(GridGeometry, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expectRefused({0.0, 1, 1, {}}, "resolution is 0");
  expectRefused({-1e-9, 1, 1, {}}, "resolution is -1e-09");
  expectRefused({nan, 1, 1, {}}, "resolution is nan");
  expectRefused({infinity, 1, 1, {}}, "resolution is inf");
  expectRefused({1.0, 0, 7, {}}, "0 x 7");
  expectRefused({1.0, 7, -1, {}}, "7 x -1");
  expectRefused({1.0, 50000, 50000, {}}, "50000 x 50000");
  expectRefused({1.0, 1, 1, {nan, 0.0, 0.0}}, "origin is (nan, 0, 0)");
  expectRefused({1.0, 1, 1, {0.0, infinity, 0.0}}, "origin is (0, inf, 0)");
  expectRefused({1.0, 1, 1, {0.0, 0.0, nan}}, "origin is (0, 0, nan)");
}

}  // namespace
}  // namespace map_matcher::grid
