#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "map_matcher/grid/map_file.hpp"
#include "support/ascii_map.hpp"
#include "support/program.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher {
namespace {

using test::ProgramRun;

class SimulateDrive : public testing::Test {
 protected:
  void SetUp() override {
    grid::saveMap(test::asciiMap({"##########",  //
                                  "#........#",  //
                                  "#........#",  //
                                  "#........#",  //
                                  "##########"},
                                 0.5),
                  map_);
  }

  static ProgramRun run(const std::string& arguments) { return test::runProgram(SIMULATE_DRIVE, arguments); }

  static std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  sensor_msgs::LaserScan::ConstPtr firstScan(std::size_t& count) const {
    rosbag::Bag bag(bag_, rosbag::bagmode::Read);
    rosbag::View scans(bag, rosbag::TopicQuery("/scan"));
    count = scans.size();
    return scans.begin()->instantiate<sensor_msgs::LaserScan>();
  }

  const test::TemporaryDir dir_;
  const std::string map_ = dir_ / "room.yaml";
  const std::string bag_ = dir_ / "drive.bag";
};

TEST_F(SimulateDrive, writesABagOfADriveThroughAMap) {
  const ProgramRun drive =
      run("--map " + map_ + " --bag " + bag_ +
          " --radius 0.2 --duration 2 --rate 10 --beams 51 --sigma 0 --start 1.2 1.2 0 --waypoints 3 1.2");
  ASSERT_EQ(drive.exit_status, 0) << drive.output;
  EXPECT_NE(drive.output.find(bag_ + ": 21 scans in 2 s"), std::string::npos) << drive.output;
  std::size_t num_scans = 0;
  const auto scan = firstScan(num_scans);
  EXPECT_EQ(num_scans, 21U);
  ASSERT_EQ(scan->ranges.size(), 51U);
  EXPECT_NEAR(scan->ranges[25], 4.5 - 1.2 - 0.15, 1e-5);
}

TEST_F(SimulateDrive, drivesThroughTheBuildingOfASeed) {
  const ProgramRun drive = run("--building-seed 2 --seed 4 --duration 3 --beams 11 --bag " + bag_);
  ASSERT_EQ(drive.exit_status, 0) << drive.output;
  std::size_t num_scans = 0;
  EXPECT_EQ(firstScan(num_scans)->ranges.size(), 11U);
  EXPECT_EQ(num_scans, 46U);
}

TEST_F(SimulateDrive, drivesAPepperAmongPeopleTheSameWayEachTime) {
  const std::string drive_among =
      "--building-seed 2 --seed 4 --duration 3 --robot pepper --people 30 --beams 211 "
      "--standing-share 0.5 --detector-recall 0.9 --bag ";
  const ProgramRun drive = run(drive_among + bag_);
  ASSERT_EQ(drive.exit_status, 0) << drive.output;
  EXPECT_NE(drive.output.find("92 scans in 3 s"), std::string::npos) << drive.output;
  EXPECT_NE(drive.output.find("30 people"), std::string::npos) << drive.output;
  std::map<std::string, std::size_t> counts;
  rosbag::Bag bag(bag_, rosbag::bagmode::Read);
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    ++counts[instance.getTopic()];
  }
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{{"/dr_spaam_detections/front", 46},
                                                        {"/dr_spaam_detections/rear", 46},
                                                        {"/ground_truth", 46},
                                                        {"/odom", 46},
                                                        {"/people_truth", 46},
                                                        {"/person_detections/front", 46},
                                                        {"/person_detections/rear", 46},
                                                        {"/sick_laser_front/scan", 46},
                                                        {"/sick_laser_rear/scan", 46},
                                                        {"/tf", 46}}));
  const std::string again = dir_ / "again.bag";
  ASSERT_EQ(run(drive_among + again).exit_status, 0);
  EXPECT_TRUE(contentOf(bag_) == contentOf(again));
}

TEST_F(SimulateDrive, exploresARoomAndEnds) {
  const ProgramRun drive =
      run("--map " + map_ + " --bag " + bag_ + " --radius 0.2 --duration 100 --start 1.2 1.2 0 --itinerary explore");
  ASSERT_EQ(drive.exit_status, 0) << drive.output;
  std::size_t num_scans = 0;
  firstScan(num_scans);
  EXPECT_LT(num_scans, 600U);
}

TEST_F(SimulateDrive, tellsItsOptionsWithTheirRangesAndDefaults) {
  const ProgramRun help = run("--help");
  EXPECT_EQ(help.exit_status, 0);
  for (const char* text :
       {"--map", "--building-seed", "--seed", "--duration", "--sigma", "--beams", "--rate", "--waypoints", "--bag",
        "--people", "--density", "--robot", "--detector-precision", "[0 to 1 m]", "--alpha1", "Exit status"}) {
    EXPECT_NE(help.output.find(text), std::string::npos) << text << " is not in: " << help.output;
  }
}

TEST_F(SimulateDrive, refusesBadArgumentsAndWritesNothing) {
  struct Case {
    std::string arguments;
    const char* complaint;
  };
  for (const Case& bad :
       {Case{"--map " + map_ + " --rate 0 --sigma 2", "rate is 0, expected 0.5 to 200 Hz; sigma is 2"},
        Case{"--map " + map_ + " --radius 0.2 --waypoints 1 2 3", "--waypoints has 3 numbers"},
        Case{"--map " + map_ + " --radius 0.2 --waypoints 1.2 1.2 9 9", "waypoint 2 is (9, 9) m"},
        Case{"--map " + map_ + " --start 0.1 0.1 0", "start is (0.1, 0.1) m"},
        Case{"--map " + map_ + " --start 1 2", "--start"},
        Case{"--map " + map_ + " --building-seed 1", "--building-seed"},
        Case{"--map " + dir_ / "nowhere.yaml", "nowhere.yaml' does not exist"}, Case{"--robot spot", "spot"},
        Case{"--density 5", "density is 5, expected 0 to 3 1/m^2"}, Case{"--map " + map_ + " --beams many", "many"},
        Case{"--building-seed -3", "-3"}}) {
    const ProgramRun drive = run(bad.arguments + " --bag " + bag_);
    EXPECT_EQ(drive.exit_status, 2) << bad.arguments;
    EXPECT_NE(drive.output.find(bad.complaint), std::string::npos) << bad.arguments << ": " << drive.output;
    EXPECT_FALSE(std::filesystem::exists(bag_)) << bad.arguments;
  }
}

TEST_F(SimulateDrive, namesABagThatCannotBeWritten) {
  const std::string path = dir_ / "missing/drive.bag";
  const ProgramRun drive = run("--map " + map_ + " --radius 0.2 --duration 1 --bag " + path);
  EXPECT_EQ(drive.exit_status, 2);
  EXPECT_NE(drive.output.find("bag '" + path + "' cannot be written"), std::string::npos) << drive.output;
}

}  // namespace
}  // namespace map_matcher
