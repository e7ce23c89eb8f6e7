#include "map_matcher/ros/localization_recorder.hpp"

#include <ros/console.h>

#include <filesystem>
#include <stdexcept>

#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/names.hpp"

namespace map_matcher {
namespace {

constexpr std::uint32_t kTruthQueue = 1000;  // a replay may be faster than this node for a moment
constexpr double kWarningPeriod = 10.0;      // [s]

}  // namespace

ParameterList parametersOf(LocalizationRecorderOptions& options) {
  return {
      {"directory", "", "Existing directory that the record is written into.", &options.directory},
      {"reference_frame", "", "Frame of the reference map.", &options.reference_frame},
      {"base_frame", "", "Frame of the robot.", &options.base_frame},
      {"patience", "s", "How long a true pose waits for tf before the robot counts as not localized.",
       &options.patience, 0.0, 60.0},
  };
}

LocalizationRecorder::LocalizationRecorder(ros::NodeHandle node, const ros::NodeHandle& /*private_node*/,
                                           const LocalizationRecorderOptions& options)
    : options_(options) {
  std::error_code unreadable;
  if (!std::filesystem::is_directory(options_.directory, unreadable)) {
    throw std::invalid_argument("~directory is \"" + options_.directory + "\", expected an existing directory");
  }
  truth_subscriber_ = node.subscribe("ground_truth", kTruthQueue, &LocalizationRecorder::onTruth, this);
  match_subscriber_ = node.subscribe(names::kMapMatch, 1, &LocalizationRecorder::onMatch, this);
  session_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
      names::kSessionMap, 1, [this](const nav_msgs::OccupancyGridConstPtr& map) { session_map_ = map; });
  reference_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
      names::kReferenceMap, 1, [this](const nav_msgs::OccupancyGridConstPtr& map) { reference_map_ = map; });
}

LocalizationRecorder::~LocalizationRecorder() {
  try {
    write();
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("the record of the run is not complete: " << error.what());
  }
}

void LocalizationRecorder::onTruth(const geometry_msgs::PoseStampedConstPtr& message) {
  if (!pending_.empty() && message->header.stamp < pending_.back().header.stamp) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "ground truth dropped: its stamp " << message->header.stamp
                                                                                << " is before the last one, "
                                                                                << pending_.back().header.stamp);
    return;
  }
  pending_.push_back(*message);
  comparePending();
}

void LocalizationRecorder::onMatch(const MapMatchConstPtr& message) {
  if (message->status == MapMatch::MATCHED) {
    run_.T_reference_session = Rigid2{message->x, message->y, message->yaw};
    run_.ratio = message->ratio;
  }
}

void LocalizationRecorder::comparePending() {
  const ros::Time newest = pending_.back().header.stamp;
  while (!pending_.empty()) {
    const ros::Time stamp = pending_.front().header.stamp;
    const std::optional<Rigid2> estimate = estimateAt(stamp);
    if (!estimate && (newest - stamp).toSec() < options_.patience) {
      return;  // those behind it are younger
    }
    try {
      const Rigid2 truth = fromMessage(pending_.front().pose, "the ground truth");
      run_.samples.push_back({stamp.toSec(), truth, estimate});
    } catch (const MessageError& error) {
      ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "ground truth dropped: " << error.what());
    }
    pending_.pop_front();
  }
}

std::optional<Rigid2> LocalizationRecorder::estimateAt(const ros::Time& stamp) const {
  try {
    const auto transform = tf_.lookupTransform(options_.reference_frame, options_.base_frame, stamp);
    return fromMessage(transform.transform, "the robot's pose on tf");
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

void LocalizationRecorder::write() const {
  const std::string directory = options_.directory + "/";
  writeErrors(run_, directory + "errors.csv");
  writeSummary(run_, directory + "summary.json");
  if (run_.T_reference_session && session_map_ && reference_map_) {
    writeMaps();
  }
  ROS_INFO_STREAM(run_.samples.size() << " true poses compared; the record is in " << options_.directory);
}

void LocalizationRecorder::writeMaps() const {
  const OccupancyGrid session = fromMessage(*session_map_);
  const OccupancyGrid reference = fromMessage(*reference_map_);
  saveMap(session, options_.directory + "/session_map.yaml");
  writeOverlayImage(options_.directory + "/overlay.png", reference, session, run_.T_reference_session);
}

}  // namespace map_matcher
