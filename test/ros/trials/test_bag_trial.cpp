#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/simulation/drive_bag.hpp"
#include "map_matcher/ros/trials/bag_trial.hpp"
#include "map_matcher/trials/trial_table.hpp"
#include "support/drives.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_trials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Six seconds in two rooms, with people and what a detector makes of them.
const simulation::Drive& smallDrive() {
  static const simulation::Drive drive = [] {
    simulation::DriveOptions options = test::shortDrive(1);
    options.duration = 6.0;
    options.rate = 5.0;
    options.pedestrians.people = 1;
    return simulation::simulateDrive(test::twoRooms(), options);
  }();
  return drive;
}

class RecordedTrial : public testing::Test {
 protected:
  RecordedTrial() {
    request.bag = dir / "drive.bag";
    request.truth_topic = "ground_truth";
    ros_simulation::writeDriveBag(smallDrive(), request.bag);
  }

  BagTrialResult play(simulation::InsertedCrowd* crowd = nullptr) {
    trial_options.map_update_interval = 1.0;
    trial_options.scrub = scrub;
    trial.emplace(test::twoRooms(), trial_options);
    scans.clear();
    trial->onMoment([this](const trials::TrialMoment& moment) { scans.push_back(moment.scans.front().scan); });
    return playBag(request, *trial, crowd);
  }

  std::string errorText() {
    return test::thrownText<ros_bags::BagError>([this] { play(); });
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
  bool scrub = true;
  trials::TrialOptions trial_options;
  std::optional<trials::Trial> trial;
  std::vector<scan::PlanarScan> scans;  // as the mapper got them
};

TEST_F(RecordedTrial, TakesEveryScanWithItsTruth) {
  const BagTrialResult result = play();

  EXPECT_EQ(result.scans, 31);
  EXPECT_EQ(result.scans_left_out, 0) << result.last_problem;
  ASSERT_FALSE(trial->matching().queries().empty());
  for (const trials::TrialQuery& query : trial->matching().queries()) {
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

TEST_F(RecordedTrial, RefusesTopicsOfTwoTypes) {
  request.scan_topic = "/scan";
  request.detection_topics = {"dr_spaam_detections"};
  for (const char* topic : {"/dr_spaam_detections", "/scan", "/ground_truth"}) {
    ros_simulation::writeDriveBag(smallDrive(), request.bag);
    append(topic, std_msgs::String());

    EXPECT_THAT(errorText(), AllOf(HasSubstr(std::string("'") + topic + "' of bag '" + request.bag + "'"),
                                   HasSubstr("_msgs/"), HasSubstr("std_msgs/String")));
  }
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
  ros_simulation::DriveMessageOptions options;
  options.map_frame = "odom";
  ros_simulation::writeDriveBag(smallDrive(), request.bag, options);

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

/// A recorded drive into whose scans people are put, all of whom are detected.
class CrowdInARecordedDrive : public RecordedTrial {
 protected:
  CrowdInARecordedDrive() {
    simulation::DriveOptions options = test::shortDrive(1);
    options.duration = 6.0;
    options.rate = 5.0;
    ros_simulation::writeDriveBag(simulation::simulateDrive(test::twoRooms(), options), request.bag);
    crowd_options.pedestrians.people = 3;
    crowd_options.detector.recall = 0.99;
    crowd_options.detector.latency = 0.0;
    scrub = false;
  }

  BagTrialResult playAmongPeople() {
    simulation::InsertedCrowd crowd(test::twoRooms(), crowd_options);
    return play(&crowd);
  }

  simulation::InsertedCrowdOptions crowd_options;
};

/// Ranges of one drive that differ from those of another.
int numDifferent(const std::vector<scan::PlanarScan>& a, const std::vector<scan::PlanarScan>& b,
                 bool (*is_due)(float, float)) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].ranges.size(); ++k) {
      count += a[i].ranges[k] != b[i].ranges[k] && is_due(a[i].ranges[k], b[i].ranges[k]) ? 1 : 0;
    }
  }
  return count;
}

/// The table of a trial but for how long the searches took.
std::string tableWithoutTimes(const trials::Trial& trial) {
  std::vector<trials::TrialQuery> queries = trial.matching().queries();
  for (trials::TrialQuery& query : queries) {
    query.answer.search.search_time = 0.0;
    query.answer.search.reference_time = 0.0;
    for (search::StageReport& stage : query.answer.search.stages) {
      stage.initialization_time = 0.0;
      stage.rotation_expansion_time = 0.0;
      stage.depth_first_search_time = 0.0;
    }
  }
  return trials::toCsv(queries);
}

bool isAny(float /*a*/, float /*b*/) { return true; }
bool isNearerNow(float a, float b) { return b < a; }
bool isGone(float /*a*/, float b) { return std::isinf(b); }

TEST_F(CrowdInARecordedDrive, HidesWhatLiesBehindItsLegs) {
  play();
  const std::vector<scan::PlanarScan> recorded = scans;

  const BagTrialResult result = playAmongPeople();

  EXPECT_EQ(result.scans_without_people, 0);
  ASSERT_EQ(scans.size(), recorded.size());
  EXPECT_GT(numDifferent(recorded, scans, isAny), 50);
  // A leg may be so near to the robot that the lidar does not see it, and hide the wall nevertheless.
  EXPECT_EQ(numDifferent(recorded, scans, isAny),
            numDifferent(recorded, scans, isNearerNow) + numDifferent(recorded, scans, isGone));
}

TEST_F(CrowdInARecordedDrive, IsTakenOutByTheScrubber) {
  playAmongPeople();
  const std::vector<scan::PlanarScan> crowded = scans;
  play();
  const int on_legs = numDifferent(scans, crowded, isNearerNow);
  scrub = true;

  playAmongPeople();

  EXPECT_GT(numDifferent(crowded, scans, isGone), on_legs / 2);
}

TEST_F(CrowdInARecordedDrive, IsTakenOutOfTheVeryScansThatWaitForItsDetections) {
  crowd_options.detector.latency = 0.045;
  trial_options.scrubbing.cache.cache_duration = 0.0;  // detections apply to their own scan only
  playAmongPeople();
  const std::vector<scan::PlanarScan> crowded = scans;
  scrub = true;

  playAmongPeople();
  EXPECT_EQ(numDifferent(crowded, scans, isAny), 0) << "no scan waited";

  trial_options.detection_wait = 0.1;
  playAmongPeople();
  EXPECT_GT(numDifferent(crowded, scans, isGone), 20);
}

TEST_F(CrowdInARecordedDrive, IsTheSameForTheSameSeedOnly) {
  playAmongPeople();
  const std::vector<scan::PlanarScan> once = scans;
  const std::string table = tableWithoutTimes(*trial);
  playAmongPeople();
  EXPECT_EQ(numDifferent(once, scans, isAny), 0);
  EXPECT_EQ(tableWithoutTimes(*trial), table);

  crowd_options.seed = 2;
  playAmongPeople();
  EXPECT_GT(numDifferent(once, scans, isAny), 0);
}

TEST_F(CrowdInARecordedDrive, IsLeftOutWhereTheTruthIsNotKnown) {
  play();
  const std::vector<scan::PlanarScan> recorded = scans;
  rewrite([](const rosbag::MessageInstance& message) {
    return message.getTopic() != "/ground_truth" || message.getTime() < ros::Time(1003.1);
  });

  const BagTrialResult result = playAmongPeople();

  EXPECT_EQ(result.scans_without_people, 15);
  for (std::size_t i = 16; i < scans.size(); ++i) {
    EXPECT_EQ(scans[i].ranges, recorded[i].ranges) << i;
  }
}

TEST_F(CrowdInARecordedDrive, NeedsTheTruth) {
  request.truth_topic.clear();
  EXPECT_THAT(test::thrownText<ros_bags::BagError>([this] { playAmongPeople(); }),
              HasSubstr("takes its topic of true poses"));
}

}  // namespace
}  // namespace map_matcher::ros_trials
