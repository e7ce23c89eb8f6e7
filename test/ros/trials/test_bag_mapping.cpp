#include <geometry_msgs/PoseStamped.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/trials/bag_mapping.hpp"
#include "support/data_dir.hpp"
#include "support/room.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_trials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kBegin = 1000.0;  // [s] stamp of the first message
constexpr double kPeriod = 0.2;    // [s] between two scans
constexpr int kNumScans = 50;
const scan::LaserMount kMount{{0.25, 0.0, 0.1}, false};

/// What the bag of a drive through the room is like.
struct BagOptions {
  bool with_tf = true;
  bool static_mount = true;  ///< base_link -> laser on /tf_static, once, or on /tf with each scan.
  double tf_delay = 0.0;     ///< [s] How much later than its scan a transform is recorded.
  std::string scan_topic = "/scan";
  std::string laser_frame = "laser";
};

grid::Rigid2 poseAt(int i) { return {-1.0 + 0.04 * i, 0.2 * std::sin(0.1 * i), 0.02 * i}; }

geometry_msgs::TransformStamped stamped(const std::string& parent, const std::string& child, const grid::Rigid2& pose,
                                        const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.header.stamp = stamp;
  message.child_frame_id = child;
  message.transform = ros_common::toTransformMessage(pose);
  return message;
}

sensor_msgs::LaserScan scanMessage(int i, const ros::Time& stamp, const std::string& frame) {
  const scan::PlanarScan scan = test::scanFrom({}, poseAt(i), kMount);
  sensor_msgs::LaserScan message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  return message;
}

void writeTransforms(rosbag::Bag& bag, int i, const ros::Time& stamp, const BagOptions& options) {
  tf2_msgs::TFMessage odometry;
  odometry.transforms.push_back(stamped("odom", "base_link", poseAt(i), stamp));
  const auto mount = stamped("base_link", "laser", kMount.T_base_laser, stamp);
  if (!options.static_mount) {
    odometry.transforms.push_back(mount);
  } else if (i == 0) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(mount);
    bag.write("/tf_static", stamp, message);
  }
  bag.write("/tf", stamp + ros::Duration(options.tf_delay), odometry);
}

void writeBag(const std::string& path, const BagOptions& options) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (int i = 0; i < kNumScans; ++i) {
    const ros::Time stamp(kBegin + kPeriod * i);
    bag.write(options.scan_topic, stamp, scanMessage(i, stamp, options.laser_frame));
    if (options.with_tf) {
      writeTransforms(bag, i, stamp, options);
    }
    nav_msgs::Odometry odometry;
    bag.write("/odom", stamp, odometry);
  }
}

class BagMapping : public testing::Test {
 protected:
  BagMappingResult map(const BagOptions& options) {
    writeBag(request.bag, options);
    return mapAgain();
  }

  BagMappingResult mapAgain() {
    snapshots.clear();
    return mapBag(request, [this](const ros_mapping::SessionSnapshot& snapshot) { snapshots.push_back(snapshot); });
  }

  /// The text of the BagError that mapping gives.
  std::string errorOf(const BagOptions& options) {
    try {
      map(options);
    } catch (const ros_bags::BagError& error) {
      return error.what();
    }
    return "no error";
  }

  void expectWallsOfTheRoom(const grid::OccupancyGrid& map) {
    const std::vector<grid::Cell> walls = grid::occupiedCells(map);
    EXPECT_GT(walls.size(), 400U);
    for (const grid::Cell& wall : walls) {
      EXPECT_LT(test::distanceToWall({}, map.geometry().cellCentre(wall)), 0.07);
    }
  }

  test::TemporaryDir dir;
  BagMappingRequest request{dir / "drive.bag", {}, 0.0, std::nullopt, {}};
  std::vector<ros_mapping::SessionSnapshot> snapshots;
};

TEST_F(BagMapping, DrawsTheRoomThatWasDrivenThrough) {
  const BagMappingResult result = map({});

  EXPECT_EQ(result.scan_topics, std::vector<std::string>{"/scan"});
  EXPECT_EQ(result.scans, kNumScans);
  EXPECT_EQ(result.scans_without_tf, 0);
  EXPECT_EQ(result.path.size(), static_cast<std::size_t>(kNumScans));
  ASSERT_FALSE(snapshots.empty());
  expectWallsOfTheRoom(snapshots.back().map);
}

TEST_F(BagMapping, TakesAMountThatComesWithEachScanAndFramesWithALeadingSlash) {
  BagOptions options;
  options.static_mount = false;
  options.laser_frame = "/laser";

  EXPECT_EQ(map(options).scans_without_tf, 0);
  expectWallsOfTheRoom(snapshots.back().map);
}

TEST_F(BagMapping, WaitsForTransformsThatComeAfterTheirScan) {
  BagOptions options;
  options.tf_delay = 0.9;

  const BagMappingResult result = map(options);

  EXPECT_EQ(result.path.size(), static_cast<std::size_t>(kNumScans));
}

TEST_F(BagMapping, GivesUpTransformsThatComeMuchLaterThanTheirScan) {
  BagOptions options;
  options.tf_delay = 5.0;

  EXPECT_THAT(errorOf(options), AllOf(HasSubstr("none of the 50 scans"), HasSubstr("extrapolation")));
}

TEST_F(BagMapping, GivesTheMapsThatAreDueInTheOrderOfTime) {
  request.options.map_update_interval = 2.0;

  map({});

  ASSERT_GE(snapshots.size(), 4U);
  EXPECT_DOUBLE_EQ(snapshots.front().stamp.toSec(), kBegin);
  for (std::size_t i = 1; i < snapshots.size(); ++i) {
    EXPECT_GT(snapshots[i].stamp, snapshots[i - 1].stamp);
  }
  for (std::size_t i = 1; i + 1 < snapshots.size(); ++i) {
    EXPECT_GT((snapshots[i].stamp - snapshots[i - 1].stamp).toSec(), 2.0);
  }
}

TEST_F(BagMapping, TakesThePartOfTheBagThatWasAskedFor) {
  request.from = 2.0;
  request.until = 4.0;

  const BagMappingResult result = map({});

  EXPECT_EQ(result.scans, 11);
  EXPECT_NEAR(result.path.front().time, kBegin + 2.0, 1e-6);
  EXPECT_NEAR(result.path.back().time, kBegin + 4.0, 1e-6);
  EXPECT_NEAR(result.path.front().pose.x, poseAt(10).x, 1e-6) << "the session frame is the odometry frame at first";
}

TEST_F(BagMapping, ThrottlesAlsoScansThatHadToWaitForTheirTransforms) {
  request.options.throttle_scans = 5;
  request.options.mapper.linear_update = 0.0;
  BagOptions options;
  options.tf_delay = 0.5;

  EXPECT_EQ(map(options).scans_drawn, kNumScans / 5);
}

TEST_F(BagMapping, ThrottlesLessWhenNotAskedTo) {
  request.options.mapper.linear_update = 0.0;

  EXPECT_EQ(map({}).scans_drawn, kNumScans);
}

TEST_F(BagMapping, OfABagThatIsNotThereNamesIt) {
  request.bag = dir / "missing.bag";
  EXPECT_THROW(mapAgain(), ros_bags::BagError);
}

TEST_F(BagMapping, OfAFileThatIsNoBagNamesIt) {
  request.bag = dir.write("text.bag", "not a bag");
  try {
    mapAgain();
    FAIL();
  } catch (const ros_bags::BagError& error) {
    EXPECT_THAT(error.what(), HasSubstr(request.bag));
  }
}

TEST_F(BagMapping, OfAnUnknownTopicTellsWhatIsThere) {
  request.scan_topics = {"/base_scan"};
  EXPECT_THAT(errorOf({}), AllOf(HasSubstr("no topic '/base_scan'"), HasSubstr("/scan (sensor_msgs/LaserScan)")));
}

TEST_F(BagMapping, OfATopicOfAnotherTypeTellsWhichItIs) {
  request.scan_topics = {"odom"};
  EXPECT_THAT(errorOf({}), HasSubstr("'/odom' of bag '" + request.bag + "' is nav_msgs/Odometry, expected"));
}

TEST_F(BagMapping, OfATopicOfTwoTypesTellsBoth) {
  writeBag(request.bag, {});
  {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
    bag.write("/scan", ros::Time(kBegin), nav_msgs::Odometry());
  }
  request.scan_topics = {"/scan"};
  EXPECT_THAT(test::thrownText<ros_bags::BagError>([this] { mapAgain(); }),
              AllOf(HasSubstr("'/scan' of bag '" + request.bag + "'"), HasSubstr("sensor_msgs/LaserScan"),
                    HasSubstr("nav_msgs/Odometry")));
}

TEST_F(BagMapping, OfABagWithoutTfTellsWhatIsThere) {
  BagOptions options;
  options.with_tf = false;
  EXPECT_THAT(errorOf(options), AllOf(HasSubstr("no /tf"), HasSubstr("/odom (nav_msgs/Odometry)")));
}

TEST_F(BagMapping, OfABagWithoutScansTellsWhatIsThere) {
  {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Write);
    bag.write("/odom", ros::Time(kBegin), nav_msgs::Odometry());
  }
  try {
    mapAgain();
    FAIL();
  } catch (const ros_bags::BagError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no topic of sensor_msgs/LaserScan"), HasSubstr("/odom")));
  }
}

TEST_F(BagMapping, OfSeveralScanTopicsAsksForOne) {
  writeBag(request.bag, {});
  {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
    bag.write("/rear/scan", ros::Time(kBegin), scanMessage(0, ros::Time(kBegin), "laser"));
  }
  try {
    mapAgain();
    FAIL();
  } catch (const ros_bags::BagError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("several"), HasSubstr("/scan"), HasSubstr("/rear/scan")));
  }
  request.scan_topics = {"/scan"};
  EXPECT_EQ(mapAgain().scans, kNumScans);
}

TEST_F(BagMapping, DrawsTheScansOfBothLasers) {
  writeBag(request.bag, {});
  {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
    for (int i = 0; i < kNumScans; ++i) {
      const ros::Time stamp(kBegin + kPeriod * i);
      bag.write("/rear/scan", stamp, scanMessage(i, stamp, "laser"));
    }
  }
  request.scan_topics = {"/scan", "rear/scan"};

  const BagMappingResult result = mapAgain();

  EXPECT_EQ(result.scan_topics, (std::vector<std::string>{"/scan", "/rear/scan"}));
  EXPECT_EQ(result.scans, 2 * kNumScans);
  EXPECT_EQ(result.path.size(), 2U * kNumScans);
  expectWallsOfTheRoom(snapshots.back().map);
}

TEST_F(BagMapping, OfATopicThatIsGivenTwiceNamesIt) {
  request.scan_topics = {"/scan", "scan"};
  EXPECT_THAT(errorOf({}), HasSubstr("the topic of scans /scan is given twice"));
}

TEST_F(BagMapping, WithAFrameThatIsNotInTheBagNamesIt) {
  request.options.odom_frame = "odometry";
  EXPECT_THAT(errorOf({}), AllOf(HasSubstr("none of the 50 scans"), HasSubstr("odometry")));
}

TEST_F(BagMapping, OfAPartThatIsNotInTheBagTellsHowLongItIs) {
  request.from = 500.0;
  EXPECT_THAT(errorOf({}), HasSubstr("expected 0 to 9.8"));
  request.from = 5.0;
  request.until = 5.0;
  EXPECT_THAT(errorOf({}), HasSubstr("the end is 5"));
}

TEST_F(BagMapping, RefusesOptionsOutOfRange) {
  request.options.throttle_scans = 0;
  EXPECT_THROW(map({}), std::invalid_argument);
}

/// The true poses in a bag, by their stamps [s].
std::map<double, grid::Rigid2> truthOf(const std::string& path) {
  rosbag::Bag bag(path);
  std::map<double, grid::Rigid2> truth;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery(std::string("/ground_truth")))) {
    const auto pose = message.instantiate<geometry_msgs::PoseStamped>();
    truth[pose->header.stamp.toSec()] = ros_common::fromMessage(pose->pose, "the truth");
  }
  return truth;
}

/// Root mean square distance [m] of a path from the true one, after the rigid motion that brings them closest.
double rmsAfterAlignment(const std::vector<evaluation::StampedPose>& path,
                         const std::map<double, grid::Rigid2>& truth) {
  Eigen::MatrixXd estimates(2, path.size());
  Eigen::MatrixXd true_positions(2, path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    estimates.col(static_cast<Eigen::Index>(i)) = path[i].pose.translation();
    true_positions.col(static_cast<Eigen::Index>(i)) = truth.at(path[i].time).translation();
  }
  const Eigen::MatrixXd motion = Eigen::umeyama(estimates, true_positions, false);
  const Eigen::MatrixXd aligned =
      (motion.topLeftCorner(2, 2) * estimates).colwise() + Eigen::Vector2d(motion.topRightCorner(2, 1));
  return std::sqrt((aligned - true_positions).squaredNorm() / static_cast<double>(path.size()));
}

TEST_F(BagMapping, FollowsTheTruePathOfARealLog) {
  const auto data = test::dataDir();
  if (!data) {
    GTEST_SKIP() << "the evaluation data is not there";
  }
  request.bag = (*data / "bags" / "intel_raw_fullrate_first1088s.bag").string();
  request.until = 120.0;

  const BagMappingResult result = mapAgain();

  EXPECT_EQ(result.scans_without_tf, 0);
  EXPECT_EQ(result.scans_not_fitting, 0);
  EXPECT_LT(rmsAfterAlignment(result.path, truthOf(request.bag)), 0.15);
}

}  // namespace
}  // namespace map_matcher::ros_trials
