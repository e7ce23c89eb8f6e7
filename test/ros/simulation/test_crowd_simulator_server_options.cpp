#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/simulation/crowd_simulator_server_options.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "support/source_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_simulation {
namespace {

using Options = CrowdSimulatorServerOptions;

TEST(CrowdSimulatorServerOptions, giveADriveAmongPeople) {
  Options options;
  options.seed = 7;
  options.start = "1.5 2, -0.5";
  options.waypoints = "3 4 5.5 6";
  const simulation::DriveOptions drive = driveOf(options);
  EXPECT_EQ(drive.seed, 7U);
  EXPECT_EQ(drive.pedestrians.density, 0.3);
  ASSERT_TRUE(drive.start);
  EXPECT_EQ(drive.start->y, 2.0);
  EXPECT_EQ(drive.start->yaw, -0.5);
  EXPECT_EQ(drive.waypoints, (std::vector<Eigen::Vector2d>{{3.0, 4.0}, {5.5, 6.0}}));
  EXPECT_TRUE(drive.more_lidars.empty());
  EXPECT_FALSE(drive.explore);
}

TEST(CrowdSimulatorServerOptions, withoutAStartGiveARandomOne) {
  Options options;
  options.itinerary = "explore";
  const simulation::DriveOptions drive = driveOf(options);
  EXPECT_FALSE(drive.start);
  EXPECT_TRUE(drive.waypoints.empty());
  EXPECT_TRUE(drive.explore);
}

/// The parameters that launch/crowd_simulator.launch robot:=pepper adds are those of the simulated Pepper elsewhere.
TEST(CrowdSimulatorServerOptions, ofAPepperAreThoseOfEveryOtherProgram) {
  Options options;
  parameters::loadYamlParameters(test::sourceFile("config/crowd_simulator_pepper.yaml"), parametersOf(options));
  simulation::DriveOptions actual = driveOf(options);
  simulation::DriveOptions expected = Options().drive;
  simulation::equipAsPepper(expected);
  const parameters::ParameterList actual_parameters = parametersOf(actual);
  const parameters::ParameterList expected_parameters = parametersOf(expected);
  for (std::size_t i = 0; i < expected_parameters.size(); ++i) {
    EXPECT_EQ(parameters::valueText(actual_parameters[i]), parameters::valueText(expected_parameters[i]))
        << expected_parameters[i].name;
  }
  ASSERT_EQ(actual.more_lidars.size(), 1U);
  EXPECT_NEAR(actual.more_lidars[0].x, expected.more_lidars[0].x, 1e-9);
  EXPECT_NEAR(actual.more_lidars[0].y, expected.more_lidars[0].y, 1e-9);
  EXPECT_NEAR(grid::normalizeAngle(actual.more_lidars[0].yaw - expected.more_lidars[0].yaw), 0.0, 1e-9);
}

TEST(CrowdSimulatorServerOptions, nameTextsThatAreNotTheNumbersExpected) {
  struct Case {
    const char* start;
    const char* waypoints;
    const char* complaint;
  };
  for (const Case& bad :
       {Case{"1 2", "", "~start is \"1 2\", expected three numbers, x y yaw [m m rad]"},
        Case{"here", "", "~start is \"here\", expected three numbers"}, Case{"1 2 3 m", "", "~start is \"1 2 3 m\""},
        Case{"", "1 2 3", "~waypoints has 3 numbers, expected an x and a y for each place [m]"},
        Case{"", "1 2; 3 4", "~waypoints is \"1 2; 3 4\", expected an x and a y"}}) {
    Options options;
    options.start = bad.start;
    options.waypoints = bad.waypoints;
    const std::string text = test::thrownText<std::invalid_argument>([&] { driveOf(options); });
    EXPECT_NE(text.find(bad.complaint), std::string::npos) << bad.complaint << " is not in: " << text;
  }
}

TEST(CrowdSimulatorServerOptions, nameTheBuildingToDriveIn) {
  Options options;
  options.building_seed = 3;
  simulation::OfficeBuildingOptions building;
  building.seed = 3;
  building.resolution = 0.05;
  EXPECT_EQ(mapOf(options).values(), simulation::officeBuilding(building).values());
  options.map_file = "nowhere.yaml";
  const std::string text = test::thrownText<std::runtime_error>([&] { mapOf(options); });
  EXPECT_NE(text.find("nowhere.yaml"), std::string::npos) << text;
}

}  // namespace
}  // namespace map_matcher::ros_simulation
