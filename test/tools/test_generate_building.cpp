#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;

ProgramRun generateBuilding(const std::string& arguments) { return test::runProgram(GENERATE_BUILDING, arguments); }

TEST(GenerateBuilding, writesTheMapOfTheSeed) {
  const test::TemporaryDir dir;
  const ProgramRun run = generateBuilding("--seed 3 --resolution 0.05 --output " + dir / "office.yaml");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_NE(run.output.find("1120 x 320 cells of 0.05 m, seed 3"), std::string::npos) << run.output;
  simulation::OfficeBuildingOptions options;
  options.seed = 3;
  options.resolution = 0.05;
  EXPECT_EQ(grid::loadMap(dir / "office.yaml").values(), simulation::officeBuilding(options).values());
}

TEST(GenerateBuilding, writesAFloorThatHasChangedAndFloorsWithOnePlan) {
  const test::TemporaryDir dir;
  const ProgramRun run = generateBuilding(
      "--resolution 0.1 --moved-furniture 0.3 --shut-doors 0.2 --change-seed 5 --furniture-seed 9 --floors 2 "
      "--output " +
      dir / "office.yaml");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  simulation::OfficeBuildingOptions options;
  options.resolution = 0.1;
  options.moved_furniture = 0.3;
  options.shut_doors = 0.2;
  options.change_seed = 5;
  options.furniture_seed = 9;
  EXPECT_EQ(grid::loadMap(dir / "office.yaml").values(), simulation::officeFloors(options, 2).values());
}

TEST(GenerateBuilding, tellsItsOptionsWithTheirRangesAndDefaults) {
  const ProgramRun run = generateBuilding("--help");
  EXPECT_EQ(run.exit_status, 0);
  for (const char* text : {"--output", "--seed", "--resolution", "[0.01 to 0.1 m]", "--length", "55", "--furnished"}) {
    EXPECT_NE(run.output.find(text), std::string::npos) << text << " is not in: " << run.output;
  }
}

TEST(GenerateBuilding, refusesBadArgumentsAndWritesNothing) {
  struct Case {
    const char* arguments;
    const char* complaint;
  };
  const test::TemporaryDir dir;
  const std::string output = " --output " + dir / "office.yaml";
  for (const Case& bad : {Case{"--resolution 5", "resolution is 5, expected 0.01 to 0.1 m"},
                          Case{"--length 3 --width 3", "length is 3, expected 40 to 200 m; width is 3"},
                          Case{"--width nan", "--width is nan, expected a number"}, Case{"--resolution fine", "fine"},
                          Case{"--seed -1", "-1"}, Case{"--sede 1", "--sede"}}) {
    const ProgramRun run = generateBuilding(bad.arguments + output);
    EXPECT_EQ(run.exit_status, 2) << bad.arguments;
    EXPECT_NE(run.output.find(bad.complaint), std::string::npos) << bad.arguments << ": " << run.output;
    EXPECT_FALSE(std::filesystem::exists(dir / "office.yaml"));
  }
}

TEST(GenerateBuilding, needsToBeToldWhereToWrite) {
  const ProgramRun run = generateBuilding("--seed 1");
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.output.find("--output"), std::string::npos) << run.output;
}

TEST(GenerateBuilding, namesAFileThatCannotBeWritten) {
  const test::TemporaryDir dir;
  const std::string path = dir / "missing/office.yaml";
  const ProgramRun run = generateBuilding("--resolution 0.1 --output " + path);
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.output.find(dir / "missing/office"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace map_matcher
