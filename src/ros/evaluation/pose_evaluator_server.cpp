#include "map_matcher/ros/evaluation/pose_evaluator_server.hpp"

#include <ros/console.h>

#include <iostream>
#include <sstream>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_evaluation {
namespace {

constexpr std::uint32_t kTruthQueue = 1000;
constexpr double kWarningPeriod = 5.0;      // [s]
const ros::WallDuration kTickPeriod(0.05);  // between two looks for transforms

void writeFigures(std::ostream& out, const char* name, const evaluation::ErrorStatistics& error, const char* unit) {
  out << name << " error: mean " << error.mean << ", median " << error.median << ", rms " << error.rms << ", worst "
      << error.worst << ' ' << unit << '\n';
}

std::string summaryText(const evaluation::TrajectoryError& error) {
  std::ostringstream text;
  text << "pose known in " << error.estimates << " of " << error.samples << " moments";
  if (error.translation) {
    text << ", first after " << *error.time_to_first_estimate << " s\n";
    writeFigures(text, "translation", *error.translation, "m");
    writeFigures(text, "rotation", *error.rotation, "rad");
    return text.str();
  }
  return text.str() + '\n';
}

}  // namespace

parameters::ParameterList parametersOf(PoseEvaluatorOptions& options) {
  return {
      {"map_frame", "", "tf frame of the reference map, whose coordinates the truth has.", &options.map_frame},
      {"session_frame", "", "tf frame of the session map.", &options.session_frame},
      {"base_frame", "", "tf frame of the robot.", &options.base_frame},
      {"truth_frame", "", "Frame that true poses must have in their header; empty: any.", &options.truth_frame},
      {"transform_timeout", "s", "How long after a true pose its transform may come.", &options.transform_timeout, 0.0,
       10.0},
      {"csv_file", "", "Path for a row for each true pose; empty: none.", &options.csv_file},
      {"summary_file", "", "Path for the figures as JSON, at the end; empty: none.", &options.summary_file},
  };
}

PoseEvaluatorServer::PoseEvaluatorServer(ros::NodeHandle node, const ros::NodeHandle& /*private_node*/,
                                         const PoseEvaluatorOptions& options)
    : options_(options), record_(options.csv_file), tf_listener_(tf_) {
  truth_subscriber_ = node.subscribe("ground_truth", kTruthQueue, &PoseEvaluatorServer::onTruth, this);
  match_subscriber_ = node.subscribe("map_match", 1, &PoseEvaluatorServer::onMatch, this);
  tick_timer_ = node.createWallTimer(kTickPeriod, [this](const ros::WallTimerEvent& /*event*/) { onTick(); });
}

PoseEvaluatorServer::~PoseEvaluatorServer() {
  try {
    sumUp();
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM(error.what());
  }
}

void PoseEvaluatorServer::onTruth(const geometry_msgs::PoseStampedConstPtr& message) {
  try {
    const std::string& frame = message->header.frame_id;
    if (!options_.truth_frame.empty() && frame != options_.truth_frame) {
      throw ros_common::MessageError("the frame is \"" + frame + "\", expected ~truth_frame = \"" +
                                     options_.truth_frame + "\"");
    }
    geometry_msgs::Transform transform;
    transform.translation.x = message->pose.position.x;
    transform.translation.y = message->pose.position.y;
    transform.rotation = message->pose.orientation;
    queue_.push_back({message->header.stamp, ros_common::projectToPlane(transform, "the true pose"), ratio_});
  } catch (const ros_common::MessageError& error) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "true pose dropped: " << error.what());
  }
}

void PoseEvaluatorServer::onMatch(const MapMatchConstPtr& message) {
  if (message->status == MapMatch::MATCHED) {
    ratio_ = message->ratio;
  }
}

void PoseEvaluatorServer::onTick() {
  const ros::Time now = ros::Time::now();
  if (clock_.tick(now) == ros_common::RisingClock::Tick::kWentBack) {
    ROS_WARN("time went back: the evaluation begins anew");
    sumUp();
    queue_.clear();
    ratio_.reset();
    record_ = evaluation::RunRecord(options_.csv_file);
  }
  drainQueue(now);
}

void PoseEvaluatorServer::drainQueue(const ros::Time& now) {
  for (; !queue_.empty(); queue_.pop_front()) {
    const WaitingTruth& truth = queue_.front();
    const std::optional<grid::Rigid2> estimate = lookUp(options_.base_frame, truth.stamp);
    if (!estimate && ros_common::secondsBetween(truth.stamp, now) < options_.transform_timeout) {
      return;
    }
    record_.add(
        {{truth.stamp.toSec(), truth.pose, estimate}, lookUp(options_.session_frame, truth.stamp), truth.ratio});
  }
}

std::optional<grid::Rigid2> PoseEvaluatorServer::lookUp(const std::string& child, const ros::Time& stamp) const {
  try {
    return ros_common::projectToPlane(tf_.lookupTransform(options_.map_frame, child, stamp).transform, child);
  } catch (const std::runtime_error&) {  // MessageError and tf2::TransformException: there is no estimate
    return std::nullopt;
  }
}

void PoseEvaluatorServer::sumUp() {
  const evaluation::TrajectoryError error = evaluation::evaluateTrajectory(record_.samples());
  std::cout << summaryText(error) << std::flush;  // rosconsole is closed when the node ends
  record_.complete();
  if (!options_.summary_file.empty()) {
    evaluation::writeSummary(error, options_.summary_file);
  }
}

}  // namespace map_matcher::ros_evaluation
