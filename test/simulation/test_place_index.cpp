#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "map_matcher/simulation/place_index.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {
namespace {

TEST(PlaceIndex, findsEverybodyNearEvenBeyondTheBox) {
  PlaceIndex index({-2.0, 1.0}, {3.0, 4.0}, 0.7);
  RandomNumbers random(3);
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < 200; ++i) {
    points.emplace_back(random.uniform(-4.0, 5.0), random.uniform(-1.0, 6.0));
    index.insert(i, points.back());
  }
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(0.0, 2.0), Eigen::Vector2d(-3.0, 5.0), points[7]}) {
    std::multiset<std::size_t> found;
    index.visitNear(place, 1.5, [&](std::size_t number) { found.insert(number); });
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(found.count(i), 1U);
      EXPECT_TRUE(found.count(i) == 1 || (points[i] - place).norm() > 1.5) << i;
    }
    EXPECT_LT(found.size(), points.size());
  }
}

TEST(PlaceIndex, forgetsEverybody) {
  PlaceIndex index({0.0, 0.0}, {1.0, 1.0}, 0.5);
  index.insert(1, {0.5, 0.5});
  index.clear();
  index.visitNear({0.5, 0.5}, 2.0, [](std::size_t number) { FAIL() << number; });
}

}  // namespace
}  // namespace map_matcher::simulation
