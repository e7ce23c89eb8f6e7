#include "map_matcher/ros/matching/map_matcher_server.hpp"

#include <ros/console.h>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kWaitingPeriod = 10.0;  // between two lines about what the node waits for [s]
constexpr double kWarningPeriod = 10.0;  // between two warnings of the same kind [s]

}  // namespace

MapMatcherServer::MapMatcherServer(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const MapMatcherServerOptions& options)
    : map_match_publisher_(node.advertise<MapMatch>(ros_common::names::kMapMatch, 1, true)),
      broadcaster_(node, tfModeOf(options.tf_mode), options.transform_tolerance),
      robot_(tf_, options.base_frame),
      pose_publisher_(node, robot_),
      overlay_publisher_(node),
      reference_source_(node, private_node, options.match.occupied_threshold,
                        [this](const ReferenceMapPtr& reference) { onReference(reference); }),
      session_subscriber_(node.subscribe(ros_common::names::kSessionMap, 1, &MapMatcherServer::onSessionMap, this)),
      matcher_(options.match),
      worker_([](const std::string& what) { ROS_ERROR_STREAM("a search failed: " << what); }) {
  if (!options.reference_map_file.empty()) {
    reference_source_.load(options.reference_map_file, options.reference_frame);
  }
  services_.emplace(node, private_node, options.match, serviceActions());
  diagnostics_.emplace(
      node, private_node, [this] { return diagnosticState(); }, session_subscriber_.getTopic(),
      reference_source_.topic());
  tick_timer_ = node.createTimer(ros::Duration(1.0 / options.tf_rate), [this](const ros::TimerEvent&) { onTick(); });
  waiting_timer_ = node.createWallTimer(ros::WallDuration(kWaitingPeriod),
                                        [this](const ros::WallTimerEvent&) { tellWhatIsMissing(); });
  tellWhatIsMissing();
}

void MapMatcherServer::onSessionMap(const nav_msgs::OccupancyGridConstPtr& message) {
  followClock(ros::Time::now());
  const std::lock_guard<std::mutex> lock(mutex_);
  session_ = message;
  ++record_.session_maps;
  record_.last_session_map = ros::Time::now();
  submitMatch(nullptr);
}

void MapMatcherServer::onReference(const ReferenceMapPtr& reference) {
  const std::lock_guard<std::mutex> lock(mutex_);
  dropAlignment();
  reference_ = reference;
  if (session_) {
    submitMatch(nullptr);
  }
}

void MapMatcherServer::onTick() {
  const ros::Time now = ros::Time::now();
  if (followClock(now)) {
    broadcaster_.broadcast(now);
  }
  pose_publisher_.publishPending(now);
}

void MapMatcherServer::tellWhatIsMissing() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) {
    ROS_INFO_STREAM("waiting for the time on /clock, as use_sim_time is true");
  }
  if (!reference_) {
    ROS_INFO_STREAM("waiting for a reference map on " << reference_source_.topic());
  }
  if (!session_) {
    ROS_INFO_STREAM("waiting for a session map on " << session_subscriber_.getTopic());
  }
}

MatchServices::Actions MapMatcherServer::serviceActions() {
  MatchServices::Actions actions;
  actions.reference = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reference_;
  };
  actions.set_reference = [this](const nav_msgs::OccupancyGrid& map) { reference_source_.take(map); };
  actions.match_session = [this] { return matchSession(); };
  actions.complete = [this](MapMatch& report) { complete(report); };
  return actions;
}

MatchDiagnostics::State MapMatcherServer::diagnosticState() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {record_, reference_, broadcaster_.isContested(), dropped_session_maps_, reference_source_.dropped()};
}

std::optional<std::future<MapMatch>> MapMatcherServer::matchSession() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!session_) {
    return std::nullopt;
  }
  const auto answer = std::make_shared<std::promise<MapMatch>>();
  std::future<MapMatch> future = answer->get_future();
  submitMatch(answer);
  return future;
}

void MapMatcherServer::submitMatch(const Answer& answer) {
  worker_.submit([this, session = session_, reference = reference_, answer](const work::StopToken& stop) {
    SessionMatch match = matchForBroadcast(matcher_, reference, *session, priorFor(*session), stop);
    conclude(session, match, stop);
    if (answer) {
      answer->set_value(match.report);
    }
  });
}

/// What earlier maps of the same frame say, and where tf has the robot.
search::MatchPrior MapMatcherServer::priorFor(const nav_msgs::OccupancyGrid& session) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (memory_frame_ != session.header.frame_id) {
    memory_.clear();
    memory_frame_ = session.header.frame_id;
  }
  search::MatchPrior prior = memory_.prior();
  const RobotPose robot = robot_.atOrShortlyBefore(session.header.frame_id, session.header.stamp);
  if (robot.T_session_base) {
    prior.robot = robot.T_session_base->translation();
  }
  return prior;
}

void MapMatcherServer::conclude(const nav_msgs::OccupancyGridConstPtr& session, SessionMatch& match,
                                const work::StopToken& stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stop.stopRequested()) {
    return;
  }
  MapMatch& report = match.report;
  memory_.add(match.result);
  remember(session, report);
  dropped_session_maps_ += isUnusable(report) ? 1 : 0;
  complete(report);
  record_.add(report);
  map_match_publisher_.publish(report);
  if (report.status == MapMatch::MATCHED) {
    broadcaster_.set({report.reference_frame, report.session_frame, {report.x, report.y, report.yaw}});
    pose_publisher_.request(report, report.header.stamp);
    overlay_publisher_.publish(match);
  } else if (report.status == MapMatch::ROBOT_ASTRAY) {
    broadcaster_.clear();
    pose_publisher_.clear();
  }
  tell(report);
}

void MapMatcherServer::remember(const nav_msgs::OccupancyGridConstPtr& session, const MapMatch& report) {
  if (report.status != MapMatch::INVALID_MAP) {
    last_valid_session_ = session;
    alignment_dropped_ = false;
  } else if (session_ == session) {
    session_ = last_valid_session_;
    if (session_ && alignment_dropped_) {  // its match with the reference in use gave way to that of the invalid map
      submitMatch(nullptr);
    }
  }
}

void MapMatcherServer::tell(const MapMatch& report) {
  if (report.status == MapMatch::MATCHED) {
    ROS_INFO_STREAM_COND(last_status_ != MapMatch::MATCHED,
                         "localized: \"" << report.session_frame << "\" lies at (" << report.x << " m, " << report.y
                                         << " m, " << report.yaw << " rad) in \"" << report.reference_frame << "\"; "
                                         << report.reason);
  } else if (report.status == MapMatch::EQUAL_FRAMES && last_status_ != MapMatch::EQUAL_FRAMES) {
    ROS_ERROR_STREAM(report.reason);
  } else if (report.status == MapMatch::ROBOT_ASTRAY && last_status_ != MapMatch::ROBOT_ASTRAY) {
    ROS_ERROR_STREAM("the alignment is not broadcast: " << report.reason);
  } else if (isUnusable(report)) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "session map on " << session_subscriber_.getTopic() << " dropped ("
                                                               << report.dropped_session_maps
                                                               << " so far): " << report.reason);
  } else if (report.status != MapMatch::NO_REFERENCE) {  // which tellWhatIsMissing() tells
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "no match: " << report.reason);
  }
  last_status_ = report.status;
}

void MapMatcherServer::complete(MapMatch& report) const {
  report.header.stamp = ros::Time::now();
  report.dropped_session_maps = dropped_session_maps_;
  report.dropped_reference_maps = reference_source_.dropped();
}

bool MapMatcherServer::followClock(const ros::Time& now) {
  const ros_common::RisingClock::Tick tick = clock_.tick(now);
  if (tick == ros_common::RisingClock::Tick::kWentBack) {
    ROS_WARN_STREAM("time went back to " << now << " (a bag loops?): the alignment is dropped until a new session map"
                                         << " is matched");
    const std::lock_guard<std::mutex> lock(mutex_);
    session_.reset();
    last_valid_session_.reset();
    record_ = {};
    dropAlignment();
  }
  return tick != ros_common::RisingClock::Tick::kHeld;
}

void MapMatcherServer::dropAlignment() {
  alignment_dropped_ = true;
  memory_.clear();
  record_.forgetMatch();
  worker_.cancel();
  broadcaster_.clear();
  pose_publisher_.clear();
  overlay_publisher_.clear();
}

}  // namespace map_matcher::ros_matching
