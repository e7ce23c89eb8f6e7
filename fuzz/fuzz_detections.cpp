// A sequence of scans, geometry_msgs/PoseArray and map_matcher/PersonDetections as the scrubber takes them, at any
// stamps and in any frames: every scan that makes sense is handed on once, in the order in which they came.
#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/common/tf_transforms.hpp"
#include "map_matcher/scrubbing/detector_watch.hpp"
#include "map_matcher/scrubbing/people_removal.hpp"
#include "messages.hpp"

namespace map_matcher {
namespace {

constexpr const char* kSource = "people";
constexpr int kMostMessages = 40;

geometry_msgs::PoseArray takePoses(fuzz::Bytes& bytes) {
  geometry_msgs::PoseArray message;
  message.header = fuzz::takeHeader(bytes);
  message.poses.resize(static_cast<std::size_t>(bytes.choose(7)));
  for (geometry_msgs::Pose& pose : message.poses) {
    pose = fuzz::takePose(bytes);
  }
  return message;
}

PersonDetections takeScored(fuzz::Bytes& bytes) {
  PersonDetections message;
  message.header = fuzz::takeHeader(bytes);
  message.detections.resize(static_cast<std::size_t>(bytes.choose(7)));
  for (PersonDetection& detection : message.detections) {
    detection.position = fuzz::takeVector<geometry_msgs::Point>(bytes);
    detection.score = bytes.take<float>();
  }
  return message;
}

/// A scrubber without its topics.
class Scrubber {
 public:
  Scrubber(const tf2::BufferCore& tf, bool waits, int max_detections)
      : transforms_(tf),
        poses_(transforms_, "odom"),
        removal_(
            optionsWith(max_detections),
            [this](const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) { return poses_.lookUp(set, scan); },
            waits ? std::optional<double>(0.1) : std::nullopt),
        watch_({kSource}, {}) {}

  void onScan(const sensor_msgs::LaserScan& message) {
    const scrubbing::RawScan raw = ros_common::rawScanOf(boost::make_shared<const sensor_msgs::LaserScan>(message));
    if (removal_.onScan(raw)) {
      watch_.restart(now_);
    }
    removal_.scrub(raw, now_, [this, number = scans_++, raw](const scrubbing::ScrubbedScan& scan) {
      if (number != handed_on_++ || scan.removal.ranges.size() != raw.ranges->size() || !scan.failure.empty()) {
        __builtin_trap();
      }
      watch_.onScan(raw.stamp, now_);
    });
  }

  template <typename Message>
  void onDetections(const Message& message) {
    scrubbing::DetectionSet set = ros_common::fromMessage(message, kSource);
    watch_.onDetections(set, now_);
    removal_.pathFrom({set.frame, set.stamp});
    const std::size_t size = set.detections.size();
    const scrubbing::AddedDetections added = removal_.add(std::move(set));
    if (added.used + added.left_out.total() + added.vetoed != static_cast<std::int64_t>(size)) {
      __builtin_trap();
    }
    removal_.release(now_);
  }

  void passTime(scrubbing::Stamp duration) {
    now_ += duration;
    watch_.health(watch_.record(kSource), now_);
    watch_.uselessTopics(now_);
    removal_.release(now_);
  }

  bool hasHandedOnAll() const { return handed_on_ == scans_; }

 private:
  static scrubbing::ScrubbingOptions optionsWith(int max_detections) {
    scrubbing::ScrubbingOptions options;
    options.limits.max_detections = max_detections;
    options.cache.radius_growth = 0.5;
    return options;
  }

  ros_common::TfTransforms transforms_;
  scrubbing::DetectionPoses poses_;
  scrubbing::PeopleRemoval removal_;
  scrubbing::DetectorWatch watch_;
  scrubbing::Stamp now_ = std::chrono::seconds(100);
  int scans_ = 0;
  int handed_on_ = 0;
};

void takeMessage(fuzz::Bytes& bytes, Scrubber& scrubber) {
  try {
    switch (bytes.choose(2)) {
      case 0:
        scrubber.onScan(fuzz::takeScan(bytes));
        break;
      case 1:
        scrubber.onDetections(takePoses(bytes));
        break;
      default:
        scrubber.onDetections(takeScored(bytes));
    }
  } catch (const ros_common::MessageError&) {
    return;
  }
}

}  // namespace
}  // namespace map_matcher

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  fuzz::Bytes bytes(data, size);
  tf2::BufferCore tf;
  fuzz::takeTf(bytes, tf);
  const bool waits = bytes.choose(1) != 0;
  Scrubber scrubber(tf, waits, 1 + bytes.choose(9));
  for (int k = 0; k < kMostMessages && bytes.size() > 0; ++k) {
    takeMessage(bytes, scrubber);
    scrubber.passTime(std::chrono::milliseconds(bytes.take<std::uint8_t>()));
  }
  scrubber.passTime(std::chrono::seconds(1));
  if (!scrubber.hasHandedOnAll()) {
    __builtin_trap();
  }
  return 0;
}
