#include "map_matcher/ros/matching/map_matcher_server.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/matching/map_url.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"
#include "map_matcher/search/matched_cells.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kWaitingPeriod = 10.0;  // between two lines about what the node waits for [s]
constexpr double kWarningPeriod = 10.0;  // between two warnings of the same kind [s]

}  // namespace

MapMatcherServer::MapMatcherServer(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const MapMatcherServerOptions& options)
    : tracker_(options.match),
      map_match_publisher_(node.advertise<MapMatch>(ros_common::names::kMapMatch, 1, true)),
      broadcaster_(node, tfModeOf(options.tf_mode), options.transform_tolerance),
      robot_(tf_, options.base_frame),
      pose_publisher_(node, robot_),
      announcer_(node, robot_, options.robot),
      overlay_publisher_(node),
      speech_(node, options.publish_speech),
      reference_source_(node, options.match.search,
                        [this](const ReferenceMapList& references) { onReferences(references); }),
      session_subscriber_(node.subscribe(ros_common::names::kSessionMap, 1, &MapMatcherServer::onSessionMap, this)),
      map_serving_(node, private_node, options.serve_map, {session_subscriber_.getTopic(), reference_source_.topic()}),
      worker_([](const std::string& what) { ROS_ERROR_STREAM("a search failed: " << what); }),
      operator_(node, private_node, robot_,
                {[this] { return mapsInUse(); }, [this](const belief::Prior& prior) { suppose(prior); },
                 [this](const std::string& service) { forget(service); }}),
      frame_diagnostics_(node, private_node, [this] { return contestedFrames(); }),
      reconfiguration_(private_node, options, [this](const MapMatcherServerOptions& changed) { onOptions(changed); }) {
  loadReferences(options);
  services_.emplace(node, private_node, serviceActions());
  change_map_.emplace(node, [this, frame = options.reference_frame, root = options.map_root](const std::string& path) {
    requireMapBelow(root, path);
    return reference_source_.load(path, frame);
  });
  diagnostics_.emplace(
      node, private_node, [this] { return diagnosticState(); }, session_subscriber_.getTopic(),
      reference_source_.topic());
  tick_timer_ = node.createTimer(ros::Duration(1.0 / options.tf_rate), [this](const ros::TimerEvent&) { onTick(); });
  waiting_timer_ = node.createWallTimer(ros::WallDuration(kWaitingPeriod),
                                        [this](const ros::WallTimerEvent&) { tellWhatIsMissing(); });
  tellWhatIsMissing();
}

void MapMatcherServer::loadReferences(const MapMatcherServerOptions& options) {
  if (options.reference_maps.empty()) {
    if (!options.reference_map_file.empty()) {
      reference_source_.load(options.reference_map_file, options.reference_frame);
    }
    return;
  }
  if (!options.reference_map_file.empty()) {
    throw std::invalid_argument("~reference_map_file is \"" + options.reference_map_file +
                                "\", and ~reference_maps names maps, too: expected one of both");
  }
  reference_source_.loadAll(options.reference_maps);
}

void MapMatcherServer::onSessionMap(const MapEvent& event) {
  followClock(ros::Time::now());
  const nav_msgs::OccupancyGrid& message = *event.getConstMessage();
  SessionMapPtr session;
  std::string problem;
  try {
    session = sessionMapOf(message);
  } catch (const ros_common::MessageError& error) {
    problem = error.what();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  ++record_.session_maps;
  record_.last_session_map = ros::Time::now();
  if (!session) {
    MapMatch report = refusal(MapMatch::INVALID_MAP, problem);
    fillFrames(report, onlyOne(references_), ros_common::frameName(message.header.frame_id), message.header.stamp);
    tellReport(report);
    return;
  }
  if (findFrame(references_, session->frame) == references_.end()) {
    const std::string why = tracker_.arrive(traitsOf(*session, event.getPublisherName()));
    if (!why.empty()) {
      ROS_WARN_STREAM("a new session begins, and what was known of the last one is forgotten: the session map is "
                      << "another one than before, since " << why);
      withdraw();
      record_.new_session = why;
    }
  }
  session_ = session;
  submitMatch(nullptr);
}

void MapMatcherServer::onReferences(const ReferenceMapList& references) {
  const std::lock_guard<std::mutex> lock(mutex_);
  dropAlignment();
  references_ = references;
  if (const ReferenceMapPtr only = onlyOne(references)) {
    map_serving_.serve(only);
  }
  if (session_) {
    submitMatch(nullptr);
  }
}

void MapMatcherServer::onOptions(const MapMatcherServerOptions& options) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracker_.setOptions(options.match);
  worker_.cancel();  // it asks for proof of what counted before
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
  operator_.tick(now);
  if (const std::optional<belief::Prior> prior = announcer_.tick([this] { return mapsInUse(); }, now)) {
    suppose(*prior);
  }
}

void MapMatcherServer::tellWhatIsMissing() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) {
    ROS_INFO_STREAM("waiting for the time on /clock, as use_sim_time is true");
  }
  if (references_.empty()) {
    ROS_INFO_STREAM("waiting for a reference map on " << reference_source_.topic());
  }
  if (!session_) {
    ROS_INFO_STREAM("waiting for a session map on " << session_subscriber_.getTopic());
  }
}

MatchServices::Actions MapMatcherServer::serviceActions() {
  MatchServices::Actions actions;
  actions.references = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return references_;
  };
  actions.options = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return tracker_.options();
  };
  actions.set_reference = [this](const nav_msgs::OccupancyGrid& map) { reference_source_.take(map); };
  actions.match_session = [this] { return matchSession(); };
  actions.complete = [this](MapMatch& report) { complete(report); };
  return actions;
}

MatchDiagnostics::State MapMatcherServer::diagnosticState() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {record_, references_, broadcaster_.isContested(), dropped_session_maps_, reference_source_.dropped()};
}

std::vector<ros_common::ContestedFrame> MapMatcherServer::contestedFrames() {
  std::vector<ros_common::ContestedFrame> frames =
      broadcaster_.contestedAmong(robot_.framesUpwards(), ros::Time::now());
  if (const std::optional<ros_common::ContestedFrame> own = broadcaster_.contest()) {
    frames.push_back(*own);
  }
  return frames;
}

MapsInUse MapMatcherServer::mapsInUse() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {references_, session_ ? session_->frame : ""};
}

void MapMatcherServer::suppose(const belief::Prior& prior) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracker_.suppose(prior);
  if (session_) {
    submitMatch(nullptr);
  }
}

void MapMatcherServer::forget(const std::string& service) {
  ROS_INFO_STREAM(service << " was called: all that is believed is forgotten, and the session map at hand is matched");
  const std::lock_guard<std::mutex> lock(mutex_);
  dropAlignment();
  last_status_ = MapMatch::STOPPED;
  if (session_) {
    submitMatch(nullptr);
  }
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
  const auto finish = [this, answer](MapMatch& report) {
    tellReport(report);
    if (answer) {
      answer->set_value(report);
    }
  };
  worker_.submit(
      [this, finish, session = session_, references = references_, options = tracker_.options(),
       plan = tracker_.plan()](const work::StopToken& stop) {
        belief::Findings findings;
        std::optional<MapMatch> refused =
            references.empty() ? noReferenceReport() : refuseEqualFrames(references, *session);
        if (!refused) {
          findings = findPlaces(search::MapMatcher(options.search), searched(references), session->grid, options, plan,
                                {}, stop);
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        if (stop.stopRequested()) {
          return;
        }
        if (refused) {
          const auto equal = findFrame(references, session->frame);
          fillFrames(*refused, equal == references.end() ? onlyOne(references) : *equal, session->frame,
                     session->stamp);
          finish(*refused);
          return;
        }
        MapMatch report = conclude(*session, references, findings);
        finish(report);
      },
      [this, finish, session = session_, references = references_](const std::string& what,
                                                                   const work::StopToken& stop) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!stop.stopRequested()) {
          MapMatch report = refusal(MapMatch::FAILED, "the search failed: " + what);
          fillFrames(report, onlyOne(references), session->frame, session->stamp);
          finish(report);
        }
      });
}

/// What is believed after a search, and broadcast.
MapMatch MapMatcherServer::conclude(const SessionMap& session, const ReferenceMapList& references,
                                    const belief::Findings& findings) {
  const RobotPose robot = robot_.atOrShortlyBefore(session.frame, session.stamp);
  record_.robot_unknown = robot.reason;
  const auto place =
      robot.T_session_base ? std::optional<Eigen::Vector2d>(robot.T_session_base->translation()) : std::nullopt;
  const belief::Decision decision = tracker_.conclude(findings, searched(references), session.grid, place);
  MapMatch report = toMessage(decision);
  fillFrames(report, referenceOf(decision.answer, references), session.frame, session.stamp);
  switch (decision.broadcast) {
    case belief::Broadcast::kReplace:
      announce(session, references.at(decision.answer.map), decision.answer.search, report);
      break;
    case belief::Broadcast::kWithdraw:
      record_.forgetMatch();
      broadcaster_.clear();
      pose_publisher_.clear();
      announcer_.clear();
      break;
    case belief::Broadcast::kKeep:
      break;
  }
  draw(session, *references.at(decision.answer.map), decision.answer, findings.followed);
  return report;
}

void MapMatcherServer::announce(const SessionMap& session, const ReferenceMapPtr& reference,
                                const search::SearchResult& result, const MapMatch& report) {
  map_serving_.serve(reference);
  broadcaster_.set({reference->frame, session.frame, result.T_reference_session});
  pose_publisher_.request(report, ros::Time::now());
  announcer_.set({reference, session.frame, session.stamp, result.T_reference_session, result.covariance});
}

/// Shows in rviz how the session map lies in the reference map, and where else it may.
void MapMatcherServer::draw(const SessionMap& session, const ReferenceMap& reference, const belief::Answer& answer,
                            bool followed) {
  const search::MatchedCells cells = search::splitByMatch(reference.map.grid(), session.grid,
                                                          answer.search.T_reference_session, tracker_.options().search);
  if (answer.matched()) {
    overlay_publisher_.publish(cells, session.frame, session.grid.resolution());
  }
  if (!followed) {  // which looks nowhere else, and says nothing of what was found there
    overlay_publisher_.publishOtherPlaces(cells, answer, reference.frame, session.grid.resolution());
  }
}

/// Publishes and logs what came of a map.
void MapMatcherServer::tellReport(MapMatch& report) {
  dropped_session_maps_ += isUnusable(report) ? 1 : 0;
  report.state = stateConstant(tracker_.state());
  report.state_text = toString(tracker_.state());
  complete(report);
  record_.add(report);
  map_match_publisher_.publish(report);
  speech_.tell(report);
  if (!references_.empty()) {
    const auto reference = findFrame(references_, report.reference_frame);
    overlay_publisher_.write(report, **(reference == references_.end() ? references_.begin() : reference));
  }
  tell(report);
}

void MapMatcherServer::tell(const MapMatch& report) {
  if (report.status == MapMatch::MATCHED) {
    ROS_INFO_STREAM_COND(last_status_ != MapMatch::MATCHED,
                         "localized: \"" << report.session_frame << "\" lies at (" << report.x << " m, " << report.y
                                         << " m, " << report.yaw << " rad) in \"" << report.reference_frame << "\"; "
                                         << report.reason);
  } else if (report.status == MapMatch::EQUAL_FRAMES && last_status_ != MapMatch::EQUAL_FRAMES) {
    ROS_ERROR_STREAM(report.reason);
  } else if (report.status == MapMatch::ROBOT_LOST && last_status_ != MapMatch::ROBOT_LOST) {
    ROS_ERROR_STREAM(
        (record_.last_match ? "the alignment is broadcast, but wrong: " : "the alignment is not broadcast: ")
        << report.reason);
  } else if (report.status == MapMatch::FAILED) {
    ROS_ERROR_STREAM_THROTTLE(kWarningPeriod, report.reason);
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
    record_ = {};
    dropAlignment();
  }
  return tick != ros_common::RisingClock::Tick::kHeld;
}

void MapMatcherServer::dropAlignment() {
  tracker_.reset();
  withdraw();
}

void MapMatcherServer::withdraw() {
  record_.forgetMatch();
  worker_.cancel();
  broadcaster_.clear();
  pose_publisher_.clear();
  announcer_.clear();
  overlay_publisher_.clear();
}

}  // namespace map_matcher::ros_matching
