#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include <functional>
#include <string>

#include "map_matcher/ros/bag_trial.hpp"
#include "map_matcher/ros/drive_bag.hpp"
#include "support/drives.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Six seconds in two rooms, with people and what a detector makes of them.
const Drive& smallDrive() {
  static const Drive drive = [] {
    DriveOptions options = test::shortDrive(1);
    options.duration = 6.0;
    options.rate = 5.0;
    options.pedestrians.people = 1;
    return simulateDrive(test::twoRooms(), options);
  }();
  return drive;
}

class RecordedTrial : public testing::Test {
 protected:
  RecordedTrial() {
    request.bag = dir / "drive.bag";
    request.truth_topic = "ground_truth";
    writeDriveBag(smallDrive(), request.bag);
  }

  BagTrialResult play() {
    TrialOptions options;
    options.map_update_interval = 1.0;
    options.scrub = true;
    trial.emplace(test::twoRooms(), options);
    return playBag(request, *trial);
  }

  std::string errorText() {
    return test::thrownText<BagError>([this] { play(); });
  }

  /// Writes the bag again without some of its messages.
  void rewrite(const std::function<bool(const rosbag::MessageInstance&)>& keep) {
    {
      const rosbag::Bag from(request.bag, rosbag::bagmode::Read);
      rosbag::Bag to(dir / "rewritten.bag", rosbag::bagmode::Write);
      for (const rosbag::MessageInstance& message : rosbag::View(from)) {
        if (keep(message)) {
          to.write(message.getTopic(), message.getTime(), message);
        }
      }
    }
    request.bag = dir / "rewritten.bag";
  }

  void without(const std::string& topic) {
    rewrite([&topic](const rosbag::MessageInstance& message) { return message.getTopic() != topic; });
  }

  /// Adds a message at the end.
  template <typename Message>
  void append(const std::string& topic, const Message& message) const {
    rosbag::Bag bag(request.bag, rosbag::bagmode::Append);
    bag.write(topic, ros::Time(1006.5), message);
  }

  const test::TemporaryDir dir;
  BagTrialRequest request;
  std::optional<Trial> trial;
};

TEST_F(RecordedTrial, TakesEveryScanWithItsTruth) {
  const BagTrialResult result = play();

  EXPECT_EQ(result.scans, 31);
  EXPECT_EQ(result.scans_left_out, 0) << result.last_problem;
  ASSERT_FALSE(trial->queries().empty());
  for (const TrialQuery& query : trial->queries()) {
    ASSERT_TRUE(query.truth.has_value());
    const auto step = static_cast<std::size_t>(std::lround((query.time - 1000.0) * 5.0));
    EXPECT_NEAR(query.truth->x, smallDrive().steps[step].T_map_base.x, 1e-9);
  }
}

TEST_F(RecordedTrial, RefusesDetectionsOfAnotherType) {
  append("/words", std_msgs::String());
  request.detection_topics = {"words"};

  EXPECT_THAT(errorText(),
              AllOf(HasSubstr("topic '/words'"),
                    HasSubstr("is std_msgs/String, expected geometry_msgs/PoseArray or map_matcher/PersonDetections")));
}

TEST_F(RecordedTrial, CountsDetectionsThatMakeNoSense) {
  append("/dr_spaam_detections", geometry_msgs::PoseArray());  // without a frame
  request.detection_topics = {"dr_spaam_detections"};

  const BagTrialResult result = play();

  EXPECT_EQ(result.detections_left_out, 1);
  EXPECT_THAT(result.last_problem, HasSubstr("frame"));
}

TEST_F(RecordedTrial, OfABagWithoutScansTellsWhatIsThere) {
  without("/scan");
  EXPECT_THAT(errorText(), AllOf(HasSubstr("has no topic of sensor_msgs/LaserScan"), HasSubstr("/odom (")));
}

TEST_F(RecordedTrial, OfABagWithoutTransformsTellsWhatIsThere) {
  without("/tf");
  EXPECT_THAT(errorText(), AllOf(HasSubstr("has no /tf"), HasSubstr("from odom to the laser"), HasSubstr("/odom (")));
}

TEST_F(RecordedTrial, OfABagWithOtherFramesTellsWhichAreMissing) {
  request.odom_frame = "wheel_odometry";
  EXPECT_THAT(errorText(), AllOf(HasSubstr("none of the 31 scans"), HasSubstr("wheel_odometry")));
}

TEST_F(RecordedTrial, OfABagWithoutTheTruthAskedForTellsWhatIsThere) {
  request.truth_topic = "/amcl_pose";
  EXPECT_THAT(errorText(), AllOf(HasSubstr("has no topic '/amcl_pose'"), HasSubstr("/ground_truth (")));
}

TEST_F(RecordedTrial, RefusesATruthOfAnotherType) {
  request.truth_topic = "/odom";
  EXPECT_THAT(errorText(), HasSubstr("is nav_msgs/Odometry, expected geometry_msgs/PoseStamped"));
}

TEST_F(RecordedTrial, RefusesATruthInTheFrameOfTheOdometry) {
  DriveBagOptions options;
  options.map_frame = "odom";
  writeDriveBag(smallDrive(), request.bag, options);

  EXPECT_THAT(errorText(), AllOf(HasSubstr("are in frame 'odom'"), HasSubstr("the frame of the reference map")));
}

TEST_F(RecordedTrial, RefusesATruthInAnotherFrameThanTheOneAskedFor) {
  request.truth_frame = "building";
  EXPECT_THAT(errorText(), HasSubstr("are in frame 'map', expected 'building'"));
}

TEST_F(RecordedTrial, RefusesATruthThatChangesItsFrame) {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = "elsewhere";
  pose.pose.orientation.w = 1.0;
  append("/ground_truth", pose);

  EXPECT_THAT(errorText(), HasSubstr("in the frames 'map' and 'elsewhere', expected one frame"));
}

}  // namespace
}  // namespace map_matcher
