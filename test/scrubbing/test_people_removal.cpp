#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>

#include "map_matcher/scrubbing/people_removal.hpp"

namespace map_matcher::scrubbing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kBeams = 90;
constexpr float kInf = std::numeric_limits<float>::infinity();

std::vector<float> rangesOfARoundRoom() {
  std::vector<float> ranges(kBeams, 3.0F);
  ranges[5] = std::numeric_limits<float>::quiet_NaN();
  ranges[6] = kInf;
  return ranges;
}

RawScan scanAt(double stamp, const std::string& frame = "laser") {
  return {frame,
          fromSeconds(stamp),
          {0.0, 2.0 * M_PI / kBeams, 0.0, 20.0},
          std::make_shared<const std::vector<float>>(rangesOfARoundRoom())};
}

DetectionSet personAt(double stamp, double x, double y, const std::string& frame = "laser") {
  return {"detector", frame, fromSeconds(stamp), {{{x, y, 0.0}, 1.0}}};
}

/// Two lasers that see the same; another frame is unknown, and one fails.
DetectionPose poseOf(const FrameAt& set, const FrameAt& /*scan*/) {
  if (set.frame == "broken") {
    throw std::runtime_error("no memory for a pose");
  }
  return set.frame == "unheard_of" ? DetectionPose{}
                                   : DetectionPose{PosePath::kFixedFrame, Eigen::Isometry3d::Identity()};
}

class Removal : public testing::Test {
 protected:
  /// Takes a scan that need not wait.
  ScrubbedScan scrub(const RawScan& scan) {
    std::optional<ScrubbedScan> result;
    removal.onScan(scan);
    removal.scrub(scan, Stamp(0), [&result](const ScrubbedScan& scrubbed) { result = scrubbed; });
    return result.value();
  }

  ScrubbingOptions options;
  PeopleRemoval removal{options, poseOf};
};

TEST_F(Removal, TakesNothingFromAScanWithoutPeople) {
  removal.add(personAt(10.0, 8.0, 0.0));

  const ScrubbedScan scrubbed = scrub(scanAt(10.0));

  EXPECT_THAT(scrubbed.removal.removed, IsEmpty());
  EXPECT_EQ(scrubbed.removal.points, static_cast<int>(kBeams) - 2);
  EXPECT_EQ(scrubbed.failure, "");
}

TEST_F(Removal, ChangesTheRangesNearPeopleAndNotABitElse) {
  removal.add(personAt(10.0, 3.0, 0.0));

  const RangeRemoval result = scrub(scanAt(10.0)).removal;

  ASSERT_THAT(result.removed, ElementsAre(0U, 1U, kBeams - 1));
  const std::vector<float> before = rangesOfARoundRoom();
  std::vector<float> restored = result.ranges;
  for (const std::uint32_t beam : result.removed) {
    EXPECT_EQ(restored[beam], kInf);
    restored[beam] = before[beam];
  }
  EXPECT_EQ(std::memcmp(restored.data(), before.data(), kBeams * sizeof(float)), 0);
}

TEST_F(Removal, LeavesAScanAsItIsThatWouldLoseTooMuch) {
  for (int i = 0; i < 63; ++i) {
    removal.add(personAt(10.0, 3.0 * std::cos(0.1 * i), 3.0 * std::sin(0.1 * i)));
  }

  const ScrubbedScan scrubbed = scrub(scanAt(10.0));

  EXPECT_TRUE(scrubbed.tooMany());
  EXPECT_THAT(scrubbed.removal.removed, IsEmpty());
  EXPECT_EQ(scrubbed.removal.near_people, static_cast<std::size_t>(kBeams - 2));
}

TEST_F(Removal, ForgetsWhenTimeGoesBackOrTheLaserIsAnother) {
  EXPECT_FALSE(removal.onScan(scanAt(10.0)));
  EXPECT_FALSE(removal.onScan(scanAt(9.9)));  // a scan that came late
  removal.add(personAt(9.0, 3.0, 0.0));

  const auto went_back = removal.onScan(scanAt(9.0));
  ASSERT_TRUE(went_back);
  EXPECT_THAT(*went_back, HasSubstr("went back by 1.0"));
  EXPECT_THAT(scrub(scanAt(9.0)).removal.removed, IsEmpty());

  removal.add(personAt(9.1, 3.0, 0.0));
  const auto other_laser = removal.onScan(scanAt(9.1, "rear_laser"));
  ASSERT_TRUE(other_laser);
  EXPECT_THAT(*other_laser, HasSubstr("is now rear_laser instead of laser"));
}

TEST_F(Removal, RefusesScansThatMakeNoSenseAndStaysAsItWas) {
  removal.onScan(scanAt(10.0));
  RawScan empty = scanAt(5.0);
  empty.ranges = std::make_shared<const std::vector<float>>();
  RawScan absurd = scanAt(5.0);
  absurd.layout.angle_increment = 1e8;

  EXPECT_THROW(removal.onScan(empty), std::invalid_argument);
  EXPECT_THROW(removal.onScan(absurd), std::invalid_argument);
  EXPECT_EQ(removal.newestScan(), fromSeconds(10.0));
}

TEST_F(Removal, TellsWhatBecameOfDetections) {
  DetectionSet people = personAt(10.0, 3.0, 0.0);
  people.detections.push_back({{0.0, 3.0, 0.0}, 1.0});
  people.detections.push_back({{-3.0, 0.0, 0.0}, 0.1});

  const AddedDetections added = removal.add(people, [](const Detection& person) { return person.position.y() > 1.0; });

  EXPECT_EQ(added.left_out.low_score, 1);
  EXPECT_EQ(added.vetoed, 1);
  EXPECT_EQ(added.used, 1);
  EXPECT_THAT(scrub(scanAt(10.0)).removal.removed, ElementsAre(0U, 1U, kBeams - 1));
}

TEST_F(Removal, KnowsTheWayOfASetEvenWhenNobodyIsInIt) {
  EXPECT_FALSE(removal.pathFrom({"laser", fromSeconds(10.0)}));
  removal.onScan(scanAt(10.0));

  EXPECT_EQ(removal.pathFrom({"laser", fromSeconds(10.0)}), PosePath::kFixedFrame);
  EXPECT_EQ(removal.pathFrom({"unheard_of", fromSeconds(10.0)}), PosePath::kNone);
}

TEST_F(Removal, CountsTheWaysOfSetsAndNamesTheFrameOfThoseThatHaveNone) {
  removal.add(personAt(10.0, 3.0, 0.0));
  removal.add(personAt(10.0, 3.0, 0.0, "unheard_of"));

  scrub(scanAt(10.0));

  EXPECT_EQ(removal.paths()[static_cast<std::size_t>(PosePath::kFixedFrame)], 1);
  EXPECT_EQ(removal.paths()[static_cast<std::size_t>(PosePath::kNone)], 1);
  EXPECT_EQ(removal.unknownFrame(), "unheard_of");
}

TEST_F(Removal, HandsAScanOnThatItCannotScrubAndSaysWhy) {
  removal.add(personAt(10.0, 3.0, 0.0, "broken"));

  const ScrubbedScan scrubbed = scrub(scanAt(10.0));

  EXPECT_EQ(scrubbed.failure, "no memory for a pose");
  EXPECT_THAT(scrubbed.removal.removed, IsEmpty());
  EXPECT_EQ(scrubbed.removal.ranges.size(), kBeams);
  EXPECT_EQ(scrub(scanAt(11.0)).failure, "");
}

/// Scans that wait for up to 0.1 s.
class WaitingRemoval : public testing::Test {
 protected:
  void take(double stamp, double now) {
    const RawScan scan = scanAt(stamp);
    removal.onScan(scan);
    removal.scrub(scan, fromSeconds(now), [this](const ScrubbedScan& scrubbed) { out.push_back(scrubbed); });
  }

  PeopleRemoval removal{ScrubbingOptions(), poseOf, 0.1};
  std::vector<ScrubbedScan> out;
};

TEST_F(WaitingRemoval, HandsAScanOnWhenItsDetectionsAreThere) {
  take(10.0, 50.0);
  EXPECT_THAT(out, IsEmpty());

  removal.add(personAt(10.0, 3.0, 0.0));
  removal.release(fromSeconds(50.05));

  ASSERT_EQ(out.size(), 1U);
  EXPECT_TRUE(out[0].answered);
  EXPECT_EQ(out[0].removal.removed.size(), 3U);
}

TEST_F(WaitingRemoval, HandsAScanOnThatWaitedInVainAndSaysSo) {
  take(10.0, 50.0);

  removal.release(fromSeconds(50.1));

  ASSERT_EQ(out.size(), 1U);
  EXPECT_FALSE(out[0].answered);
}

TEST_F(WaitingRemoval, LetsTheNextScanGoWhenTheTakerOfOneFails) {
  const RawScan scan = scanAt(10.0);
  removal.onScan(scan);
  removal.scrub(scan, fromSeconds(50.0), [](const ScrubbedScan&) { throw std::runtime_error("full disk"); });
  take(10.1, 50.0);

  EXPECT_THROW(removal.release(fromSeconds(50.1)), std::runtime_error);
  removal.release(fromSeconds(50.1));

  EXPECT_EQ(out.size(), 1U);
}

}  // namespace
}  // namespace map_matcher::scrubbing
