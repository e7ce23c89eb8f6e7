#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "map_matcher/search/counting/rotations.hpp"
#include "map_matcher/search/two_stage/rotation_bands.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

SessionCells randomSession(std::mt19937& random, double resolution) {
  const int size = test::randomInt(random, 1, 150);
  const std::vector<grid::Cell> cells = test::randomCells(random, size, size, test::randomInt(random, 1, 200));
  return prepareSessionCells(cells, 0.05, resolution, CellMerging::kMerge, 0);
}

TEST(RotationBands, HoldEveryRotationOnceAndItsCellsWithinTheirReach) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const SessionCells session = randomSession(random, 0.1);
    std::vector<double> angles = allRotations(test::randomReal(random, 0.5, 4.0), session.diagonal);
    std::shuffle(angles.begin(), angles.end(), random);

    const std::vector<RotationBand> bands = rotationBands(session, angles);

    std::vector<int> seen(angles.size(), 0);
    for (const RotationBand& band : bands) {
      const RotatedCells middle = rotate(session, band.middle);
      for (const int n : band.rotations) {
        ++seen[static_cast<std::size_t>(n)];
        const RotatedCells cells = rotate(session, angles[static_cast<std::size_t>(n)]);
        for (std::size_t k = 0; k < cells.x.size(); ++k) {
          ASSERT_LE(std::abs(cells.x[k] - middle.x[k]), kBandReach);
          ASSERT_LE(std::abs(cells.y[k] - middle.y[k]), kBandReach);
        }
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(angles.size()));
  }
}

TEST(RotationBands, OfTheCoarseStageHoldThreeRotations) {
  std::mt19937 random(1);
  const SessionCells session =
      prepareSessionCells(test::randomCells(random, 100, 100, 1000), 0.05, 0.05, CellMerging::kNone, 0);
  const std::vector<double> angles = allRotations(2.0, session.diagonal);

  const std::vector<RotationBand> bands = rotationBands(session, angles);

  EXPECT_EQ(bands.size(), (angles.size() + 2) / 3);
}

TEST(RotationBands, AreNoneWithoutRotations) {
  std::mt19937 random(1);

  EXPECT_TRUE(rotationBands(randomSession(random, 0.05), {}).empty());
}

}  // namespace
}  // namespace map_matcher::search
