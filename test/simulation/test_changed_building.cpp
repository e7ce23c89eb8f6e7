#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/simulation/floor_plan.hpp"
#include "map_matcher/simulation/furnishing.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/world.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::thrownText;

OfficeBuildingOptions optionsOf(std::uint64_t seed) {
  OfficeBuildingOptions options;
  options.seed = seed;
  options.resolution = 0.05;
  return options;
}

/// The pieces that can be moved: all but door leaves, which alone stand within reach of a door, pillars and the like.
int numMovable(const std::vector<FurnishedSpace>& spaces, const FloorPlan& plan) {
  int count = 0;
  for (const FurnishedSpace& space : spaces) {
    for (const Furniture& piece : space.pieces) {
      const bool is_leaf = std::any_of(plan.doors.begin(), plan.doors.end(), [&piece](const Door& door) {
        return separation(piece.footprint, door.approach()) < -0.01;
      });
      count += piece.is_fixed || is_leaf ? 0 : 1;
    }
  }
  return count;
}

/// How many pieces of `before` have none at their place in `after`.
int numGone(const std::vector<FurnishedSpace>& before, const std::vector<FurnishedSpace>& after) {
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (const Furniture& piece : before[i].pieces) {
      const std::vector<Furniture>& now = after[i].pieces;
      count += std::none_of(now.begin(), now.end(), [&piece](const Furniture& other) {
        return (other.footprint.centre() - piece.footprint.centre()).norm() < 0.01;
      });
    }
  }
  return count;
}

int countOf(const std::vector<FurnishedSpace>& spaces) {
  int count = 0;
  for (const FurnishedSpace& space : spaces) {
    count += static_cast<int>(space.pieces.size());
  }
  return count;
}

class ChangedBuildings : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ChangedBuildings, haveTheAskedShareOfTheirFurnitureElsewhere) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  const FloorPlan plan = drawFloorPlan(options);
  const std::vector<FurnishedSpace> before = furnish(plan, options);
  options.moved_furniture = 0.333;
  const std::vector<FurnishedSpace> after = furnish(plan, options);

  const double share = static_cast<double>(numGone(before, after)) / numMovable(before, plan);

  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.5);
  EXPECT_GT(countOf(after), 0.85 * countOf(before));  // most of it stands elsewhere
}

TEST_P(ChangedBuildings, leavePassagesBetweenAllTheirFurniture) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  options.moved_furniture = 0.8;
  for (const FurnishedSpace& space : furnish(drawFloorPlan(options), options)) {
    for (std::size_t i = 0; i < space.pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(separation(space.pieces[i].footprint, space.pieces[j].footprint), 0.85);
      }
    }
  }
}

TEST_P(ChangedBuildings, haveNoLeafWhereADoorIsShutAndNoWayThrough) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  options.shut_doors = 1.0;
  const FloorPlan plan = drawFloorPlan(options);
  const grid::OccupancyGrid building = officeBuilding(options);
  int num_shut = 0;
  for (const Door& door : plan.doors) {
    EXPECT_EQ(door.is_shut, door.width < 1.2);
    num_shut += door.is_shut ? 1 : 0;
    const grid::Cell cell = building.geometry().cellAt(door.centre);
    EXPECT_EQ(building.at(cell.x, cell.y) == grid::kOccupied, door.is_shut) << door.centre.transpose();
    const Eigen::Vector2d aside = door.in_wall_along_x ? Eigen::Vector2d(0.0, 0.5) : Eigen::Vector2d(0.5, 0.0);
    for (const double side : {-1.0, 1.0}) {  // the floor before it is free of everything
      const grid::Cell before = building.geometry().cellAt(door.centre + side * aside);
      EXPECT_EQ(building.at(before.x, before.y), grid::kFree) << door.centre.transpose();
    }
  }
  EXPECT_GT(num_shut, 5);
}

TEST_P(ChangedBuildings, differInTheDoorsAndFurnitureOfAnotherChangeOnly) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  const grid::OccupancyGrid unchanged = officeBuilding(options);
  options.change_seed = 2;
  EXPECT_EQ(officeBuilding(options).values(), unchanged.values());
  options.shut_doors = 0.25;
  const std::vector<std::int8_t> other_doors = officeBuilding(options).values();
  options.change_seed = 1;
  EXPECT_NE(officeBuilding(options).values(), other_doors);
  EXPECT_NE(unchanged.values(), other_doors);
}

TEST_P(ChangedBuildings, haveRoomsThatAreCopiesOfEachOther) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  options.copied_rooms = 4.0;
  const FloorPlan plan = drawFloorPlan(options);
  const grid::OccupancyGrid building = officeBuilding(options);
  int num_copies = 0;
  for (const Space& space : plan.spaces) {
    if (!space.copy_of) {
      continue;
    }
    ++num_copies;
    const Rectangle& original = plan.spaces[*space.copy_of].walls;
    const auto moved = std::lround((space.walls.x_min - original.x_min) / options.resolution);
    const grid::Cell low = building.geometry().cellAt({original.x_min + 0.2, original.y_min + 0.2});
    const grid::Cell high = building.geometry().cellAt({original.x_max - 0.2, original.y_max - 0.2});
    int num_different = 0;
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        num_different += building.at(x, y) != building.at(x + static_cast<int>(moved), y) ? 1 : 0;
      }
    }
    EXPECT_LE(num_different, 20) << "room at " << space.walls.centre().transpose();  // cells that are half a cell off
  }
  EXPECT_GT(num_copies, 8);
}

TEST_P(ChangedBuildings, letARobotIntoCopiedRooms) {
  OfficeBuildingOptions options = optionsOf(GetParam());
  options.copied_rooms = 4.0;
  const FloorPlan plan = drawFloorPlan(options);
  const World world(officeBuilding(options));
  const PathPlanner planner(world, 0.3);
  for (const Space& space : plan.spaces) {
    EXPECT_TRUE(std::any_of(planner.places().begin(), planner.places().end(),
                            [&space](const Eigen::Vector2d& place) { return contains(space.walls, place); }))
        << "space at " << space.walls.centre().transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ChangedBuildings, testing::Range<std::uint64_t>(1, 6));

TEST(ChangedBuilding, mayHaveCopiedRoomsWithFurnitureOfTheirOwn) {
  OfficeBuildingOptions options = optionsOf(1);
  options.copied_rooms = 4.0;
  const std::vector<std::int8_t> copied = officeBuilding(options).values();
  options.copied_furniture = false;
  EXPECT_NE(officeBuilding(options).values(), copied);
}

TEST(ChangedBuilding, refusesCopiedRoomsThatAreTooNarrow) {
  OfficeBuildingOptions options = optionsOf(1);
  options.copied_rooms = 1.0;
  EXPECT_EQ(thrownText<std::invalid_argument>([&] { officeBuilding(options); }),
            "copied_rooms is 1, expected 0 or at least 2.4 m");
}

TEST(OfficeFloors, haveOnePlanAndOtherFurniture) {
  const OfficeBuildingOptions options = optionsOf(3);
  const grid::OccupancyGrid one = officeBuilding(options);

  const grid::OccupancyGrid two = officeFloors(options, 2);

  ASSERT_EQ(two.width(), one.width());
  ASSERT_EQ(two.height(), 2 * one.height());
  OfficeBuildingOptions other = options;
  other.furniture_seed = 4;
  const grid::OccupancyGrid second = officeBuilding(other);
  int num_different = 0;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x) {
      ASSERT_EQ(two.at(x, y), one.at(x, y));
      ASSERT_EQ(two.at(x, y + one.height()), second.at(x, y));
      num_different += one.at(x, y) != second.at(x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(num_different, 1000);
  other.furnished = false;
  OfficeBuildingOptions bare = options;
  bare.furnished = false;
  EXPECT_EQ(officeBuilding(bare).values(), officeBuilding(other).values()) << "the plan is the same";
}

TEST(OfficeFloors, areAtLeastOne) {
  EXPECT_EQ(thrownText<std::invalid_argument>([] { officeFloors(optionsOf(1), 0); }),
            "there are 0 floors, expected at least 1");
}

}  // namespace
}  // namespace map_matcher::simulation
