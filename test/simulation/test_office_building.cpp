#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <stdexcept>
#include <vector>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/simulation/floor_plan.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/world.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::thrownText;

OfficeBuildingOptions withSeed(std::uint64_t seed, double resolution = 0.02) {
  OfficeBuildingOptions options;
  options.seed = seed;
  options.resolution = resolution;
  return options;
}

/// Which cells a robot of this radius [m] can get to from `start` [m].
std::vector<bool> reachable(const grid::OccupancyGrid& grid, const Eigen::Vector2d& start, double radius) {
  const World world(grid);
  const grid::GridGeometry& geometry = grid.geometry();
  const auto index = [&](const grid::Cell& cell) { return static_cast<std::size_t>(cell.y * grid.width() + cell.x); };
  std::vector<bool> reached(grid.values().size(), false);
  std::queue<grid::Cell> open;
  open.push(geometry.cellAt(start));
  while (!open.empty()) {
    const grid::Cell cell = open.front();
    open.pop();
    if (!geometry.contains(cell) || reached[index(cell)] || world.clearance(geometry.cellCentre(cell)) < radius) {
      continue;
    }
    reached[index(cell)] = true;
    open.push({cell.x + 1, cell.y});
    open.push({cell.x - 1, cell.y});
    open.push({cell.x, cell.y + 1});
    open.push({cell.x, cell.y - 1});
  }
  return reached;
}

int countIn(const Rectangle& area, const grid::OccupancyGrid& grid, const std::vector<bool>& cells) {
  const grid::Cell first = grid.geometry().cellAt({area.x_min, area.y_min});
  const grid::Cell last = grid.geometry().cellAt({area.x_max, area.y_max});
  int count = 0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      count += cells[static_cast<std::size_t>(y * grid.width() + x)] ? 1 : 0;
    }
  }
  return count;
}

class OfficeBuildings : public testing::TestWithParam<std::uint64_t> {};

TEST_P(OfficeBuildings, letARobotIntoEveryRoom) {
  const OfficeBuildingOptions options = withSeed(GetParam());
  const FloorPlan plan = drawFloorPlan(options);
  const grid::OccupancyGrid building = officeBuilding(options);
  const std::vector<bool> reached = reachable(building, plan.passages.front().centre(), 0.3);
  for (const Space& space : plan.spaces) {
    const double floor = countIn(space.walls, building, reached) * options.resolution * options.resolution;
    EXPECT_GT(floor, 0.1 * space.walls.area()) << "space at " << space.walls.centre().transpose();
  }
  for (const Door& door : plan.doors) {
    EXPECT_GT(countIn(door.approach(), building, reached), 0) << "door at " << door.centre.transpose();
  }
}

TEST_P(OfficeBuildings, letNoRayOut) {
  for (const double resolution : {0.02, 0.1}) {
    const grid::OccupancyGrid building = officeBuilding(withSeed(GetParam(), resolution));
    const World world(building);
    RandomNumbers random(GetParam());
    for (int i = 0; i < 20000; ++i) {
      const Eigen::Vector2d p(random.uniform(0.2, 54.8), random.uniform(0.2, 14.8));
      const double heading = random.uniform(-M_PI, M_PI);
      ASSERT_TRUE(std::isfinite(world.castRay(p, heading, 100.0))) << p.transpose() << " heading " << heading;
    }
  }
}

TEST_P(OfficeBuildings, areFreeInsideAndUnknownOutside) {
  const grid::OccupancyGrid building = officeBuilding(withSeed(GetParam()));
  for (int y = 0; y < building.height(); ++y) {
    for (int x = 0; x < building.width(); ++x) {
      const Eigen::Vector2d p = building.geometry().cellCentre({x, y});
      const bool inside = p.x() > 0.0 && p.x() < 55.0 && p.y() > 0.0 && p.y() < 15.0;
      ASSERT_EQ(building.at(x, y) != grid::kUnknown, inside) << p.transpose();
    }
  }
}

/// A robot that sees the map must be able to tell where it is: moved by a metre or more, or turned by half a turn, the
/// building does not look like itself.
TEST_P(OfficeBuildings, doNotRepeatThemselves) {
  const grid::OccupancyGrid building = officeBuilding(withSeed(GetParam(), 0.1));
  const std::vector<grid::Cell> occupied = grid::occupiedCells(building);
  const auto share = [&](auto&& moved) {
    const auto hits = std::count_if(occupied.begin(), occupied.end(), [&](const grid::Cell& cell) {
      const grid::Cell other = moved(cell);
      return building.geometry().contains(other) && building.at(other.x, other.y) == grid::kOccupied;
    });
    return static_cast<double>(hits) / static_cast<double>(occupied.size());
  };
  ASSERT_EQ(share([](const grid::Cell& cell) { return cell; }), 1.0);
  double most = 0.0;
  for (int dy = -10; dy <= 10; ++dy) {
    for (int dx = 10; dx <= 250; ++dx) {
      most = std::max(most, share([&](const grid::Cell& cell) { return grid::Cell{cell.x + dx, cell.y + dy}; }));
    }
  }
  for (int dy = -20; dy <= 20; ++dy) {
    for (int dx = -20; dx <= 20; ++dx) {
      most = std::max(most, share([&](const grid::Cell& cell) {
                        return grid::Cell{building.width() - 1 - cell.x + dx, building.height() - 1 - cell.y + dy};
                      }));
    }
  }
  EXPECT_LT(most, 0.4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OfficeBuildings, testing::Values(0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 1234567U));

TEST(OfficeBuilding, hasTheSizeThatIsAskedFor) {
  OfficeBuildingOptions options = withSeed(1, 0.05);
  options.length = 70.0;
  options.width = 18.0;
  const grid::OccupancyGrid building = officeBuilding(options);
  EXPECT_EQ(building.width(), 1400 + 20);  // half a metre around it
  EXPECT_EQ(building.height(), 360 + 20);
  EXPECT_NEAR(building.geometry().T_map_grid.x, -0.5, 1e-12);
  EXPECT_NEAR(building.geometry().T_map_grid.y, -0.5, 1e-12);
}

TEST(OfficeBuilding, isTheSameForTheSameSeedOnly) {
  EXPECT_EQ(officeBuilding(withSeed(3, 0.05)).values(), officeBuilding(withSeed(3, 0.05)).values());
  EXPECT_NE(officeBuilding(withSeed(3, 0.05)).values(), officeBuilding(withSeed(4, 0.05)).values());
}

TEST(OfficeBuilding, isTheSameAtEveryResolution) {
  const World fine(officeBuilding(withSeed(5, 0.02)));
  const World coarse(officeBuilding(withSeed(5, 0.05)));
  RandomNumbers random(5);
  int equal = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(random.uniform(0.2, 54.8), random.uniform(0.2, 14.8));
    const double heading = random.uniform(-M_PI, M_PI);
    const double difference = fine.castRay(p, heading, 100.0) - coarse.castRay(p, heading, 100.0);
    equal += std::abs(difference) < 0.15 ? 1 : 0;
  }
  EXPECT_GT(equal, 1700);  // the others pass a corner on different sides
}

TEST(OfficeBuilding, hasNothingButWallsWhenItIsNotFurnished) {
  OfficeBuildingOptions options = withSeed(2);
  const std::size_t furnished = grid::occupiedCells(officeBuilding(options)).size();
  options.furnished = false;
  const std::size_t bare = grid::occupiedCells(officeBuilding(options)).size();
  EXPECT_LT(bare, furnished);
  EXPECT_GT(bare, 2U * (2750U + 750U) * 6U);  // more than the outer walls
}

TEST(OfficeBuilding, canBeBuiltAtTheLimitsOfItsOptions) {
  for (const double length : {40.0, 200.0}) {
    for (const double width : {13.0, 30.0}) {
      for (const double thickness : {0.01, 0.4}) {
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
          OfficeBuildingOptions options = withSeed(seed, 0.1);
          options.length = length;
          options.width = width;
          options.wall_thickness = thickness;
          options.outer_wall_thickness = thickness;
          options.door_width = 1.2;
          const FloorPlan plan = drawFloorPlan(options);
          options.furnished = false;
          const grid::OccupancyGrid building = officeBuilding(options);
          const std::vector<bool> reached = reachable(building, plan.passages.front().centre(), 0.25);
          for (const Space& space : plan.spaces) {
            EXPECT_GT(countIn(space.walls, building, reached), 0)
                << "length " << length << " width " << width << " walls " << thickness << " seed " << seed
                << ", space at " << space.walls.centre().transpose();
          }
        }
      }
    }
  }
}

TEST(OfficeBuilding, namesEveryOptionOutOfItsRange) {
  OfficeBuildingOptions options;
  options.resolution = 0.0;
  options.length = 10.0;
  options.width = std::nan("");
  options.door_width = 3.0;
  const std::string text = thrownText<std::invalid_argument>([&] { officeBuilding(options); });
  for (const char* problem : {"resolution is 0, expected 0.01 to 0.1 m", "length is 10, expected 40 to 200 m",
                              "width is nan, expected 13 to 30 m", "door_width is 3, expected 0.9 to 1.2 m"}) {
    EXPECT_NE(text.find(problem), std::string::npos) << problem << " is not in: " << text;
  }
}

}  // namespace
}  // namespace map_matcher::simulation
