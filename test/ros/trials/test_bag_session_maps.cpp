#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/simulation/drive_bag.hpp"
#include "map_matcher/ros/trials/bag_mapping.hpp"
#include "map_matcher/ros/trials/bag_session_maps.hpp"
#include "map_matcher/ros/trials/bag_trial.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_trials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kInterval = 1.0;  // [s] between two maps

grid::OccupancyGrid office() {
  simulation::OfficeBuildingOptions options;
  options.resolution = 0.05;
  return simulation::officeBuilding(options);
}

/// A drive through an office, long enough to be localized.
class RecordedSessionMaps : public testing::Test {
 protected:
  RecordedSessionMaps() {
    simulation::DriveOptions options;
    options.duration = 8.0;
    options.rate = 5.0;
    options.lidar.beams = 271;
    request.bag = dir / "drive.bag";
    request.map_topic = "map";
    request.truth_topic = "ground_truth";
    ros_simulation::writeDriveBag(simulation::simulateDrive(office(), options), request.bag);
  }

  /// Draws the session maps of the bag and adds them to it, with the mapper's transform.
  void recordMaps() {
    BagMappingRequest mapping;
    mapping.bag = request.bag;
    mapping.options.map_update_interval = kInterval;
    std::vector<ros_mapping::SessionSnapshot> snapshots;
    mapBag(mapping, [&snapshots](const ros_mapping::SessionSnapshot& snapshot) { snapshots.push_back(snapshot); });
    for (const ros_mapping::SessionSnapshot& snapshot : snapshots) {
      record(snapshot.stamp, snapshot.T_session_odom,
             ros_common::toMessage(snapshot.map, "session_map", snapshot.stamp));
    }
  }

  void record(const ros::Time& stamp, const grid::Rigid2& T_session_odom, const nav_msgs::OccupancyGrid& map) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = stamp;
    transform.header.frame_id = "session_map";
    transform.child_frame_id = "odom";
    transform.transform = ros_common::toTransformMessage(T_session_odom);
    tf2_msgs::TFMessage transforms;
    transforms.transforms.push_back(transform);
    rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
    bag.write("/map", stamp, map);
    bag.write("/tf", stamp, transforms);
  }

  BagSessionMapsResult match() { return matchSessionMaps(request, matching); }

  std::string errorText() {
    return test::thrownText<ros_bags::BagError>([this] { match(); });
  }

  const test::TemporaryDir dir;
  BagSessionMapsRequest request;
  trials::SessionMatching matching{office(), {}};
};

TEST_F(RecordedSessionMaps, AreMatchedAsThoseThatATrialDraws) {
  recordMaps();
  trials::TrialOptions options;
  options.map_update_interval = kInterval;
  trials::Trial trial(office(), options);
  BagTrialRequest drive;
  drive.bag = request.bag;
  drive.truth_topic = request.truth_topic;
  playBag(drive, trial);
  const std::vector<trials::TrialQuery>& drawn = trial.matching().queries();

  const BagSessionMapsResult result = match();

  EXPECT_EQ(result.maps_left_out, 0) << result.last_problem;
  ASSERT_GE(result.maps, static_cast<int>(drawn.size()));
  ASSERT_GE(drawn.size(), 4U);
  ASSERT_TRUE(drawn.back().answer.matched()) << drawn.back().answer.reason;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const trials::TrialQuery& recorded = matching.queries()[i];
    EXPECT_NEAR(recorded.time, drawn[i].time, 1e-6);
    EXPECT_NEAR(recorded.session_age, drawn[i].session_age, 1e-6);
    EXPECT_NEAR(recorded.travelled, drawn[i].travelled, 1e-6);
    EXPECT_EQ(recorded.answer.status, drawn[i].answer.status);
    EXPECT_LT(
        evaluation::errorOf(recorded.answer.search.T_reference_session, drawn[i].answer.search.T_reference_session)
            .translation,
        1e-6);
    EXPECT_LT(evaluation::errorOf(recorded.T_session_base, drawn[i].T_session_base).translation, 1e-6);
    EXPECT_LT(evaluation::errorOf(*recorded.true_alignment, *drawn[i].true_alignment).translation, 1e-6);
    EXPECT_EQ(recorded.falsely_occupied, drawn[i].falsely_occupied);
  }
}

TEST_F(RecordedSessionMaps, NeedNoTruth) {
  recordMaps();
  request.truth_topic.clear();

  match();

  EXPECT_FALSE(matching.queries().back().truth.has_value());
  EXPECT_FALSE(matching.queries().back().true_alignment.has_value());
  EXPECT_TRUE(matching.queries().back().estimate().has_value());
}

TEST_F(RecordedSessionMaps, ThatCannotBeUsedAreCounted) {
  recordMaps();
  nav_msgs::OccupancyGrid broken = ros_common::toMessage(office(), "session_map", ros::Time(1005.0));
  broken.info.resolution = 0.0;
  record(ros::Time(1005.0), {}, broken);
  record(ros::Time(3000.0), {}, ros_common::toMessage(office(), "session_map", ros::Time(3000.0)));  // no odometry

  const BagSessionMapsResult result = match();

  EXPECT_EQ(result.maps_left_out, 2);
  EXPECT_EQ(matching.queries().size(), static_cast<std::size_t>(result.maps - 2));
  EXPECT_NE(result.last_problem, "");
}

TEST_F(RecordedSessionMaps, WithoutTransformsAreAnError) {
  rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
  bag.write("/map", ros::Time(1001.0), ros_common::toMessage(office(), "session_map", ros::Time(1001.0)));
  bag.close();

  EXPECT_THAT(errorText(), AllOf(HasSubstr("none of the 1 maps of /map could be used"), HasSubstr("session_map")));
}

TEST_F(RecordedSessionMaps, ThatAreNotThereAreAnError) {
  EXPECT_THAT(errorText(), AllOf(HasSubstr("has no topic 'map'"), HasSubstr("/scan (sensor_msgs/LaserScan)")));
}

TEST_F(RecordedSessionMaps, OfAnotherTypeAreAnError) {
  request.map_topic = "/scan";
  EXPECT_THAT(errorText(), HasSubstr("is sensor_msgs/LaserScan, expected nav_msgs/OccupancyGrid"));
}

TEST_F(RecordedSessionMaps, AmongMessagesOfAnotherTypeAreAnError) {
  recordMaps();
  rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
  bag.write("/map", ros::Time(1004.0), std_msgs::String());
  bag.close();

  EXPECT_THAT(errorText(), AllOf(HasSubstr("'/map' of bag '" + request.bag + "'"), HasSubstr("nav_msgs/OccupancyGrid"),
                                 HasSubstr("std_msgs/String")));
}

}  // namespace
}  // namespace map_matcher::ros_trials
