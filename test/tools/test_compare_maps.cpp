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

class CompareMaps : public testing::Test {
 protected:
  void SetUp() override {
    simulation::OfficeBuildingOptions options;
    options.seed = 3;
    options.resolution = 0.1;
    grid::OccupancyGrid building = simulation::officeBuilding(options);
    grid::saveMap(building, dir_ / "before.yaml");
    for (int n = 0; n < 10; ++n) {  // a metre of new wall
      for (int side = -4; side <= 4; ++side) {
        building.at(building.width() / 2 + n, building.height() / 2 + side) = side == 0 ? grid::kOccupied : grid::kFree;
      }
    }
    grid::saveMap(building, dir_ / "after.yaml");
  }

  ProgramRun run(const std::string& arguments) const {
    return test::runProgram(COMPARE_MAPS,
                            "--before " + dir_ / "before.yaml" + " --after " + dir_ / "after.yaml " + arguments);
  }

  const test::TemporaryDir dir_;
};

TEST_F(CompareMaps, TellsHowMuchIsNewAndDrawsIt) {
  const ProgramRun compared = run("--pose 0 0 0 --output " + dir_ / "changes.png");

  EXPECT_EQ(compared.exit_status, 0) << compared.output;
  EXPECT_NE(compared.output.find("walls that are new                  1 m"), std::string::npos) << compared.output;
  EXPECT_TRUE(std::filesystem::exists(dir_ / "changes.png"));
}

TEST_F(CompareMaps, FindsHowTheMapsLieWithoutBeingTold) {
  const ProgramRun compared = run("");

  EXPECT_EQ(compared.exit_status, 0) << compared.output;
  EXPECT_NE(compared.output.find("walls that are new                  1 m"), std::string::npos) << compared.output;
}

TEST_F(CompareMaps, RefusesAMapThatIsNotThereAndAPictureInPlaceOfAMap) {
  const ProgramRun missing = test::runProgram(COMPARE_MAPS, "--before /nowhere.yaml --after " + dir_ / "after.yaml");
  const ProgramRun overwriting = run("--pose 0 0 0 --output " + dir_ / "after.yaml");

  EXPECT_EQ(missing.exit_status, 2);
  EXPECT_NE(missing.output.find("/nowhere.yaml"), std::string::npos) << missing.output;
  EXPECT_EQ(overwriting.exit_status, 2) << overwriting.output;
}

}  // namespace
}  // namespace map_matcher
