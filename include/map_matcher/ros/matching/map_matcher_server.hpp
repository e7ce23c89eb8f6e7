/// \file
/// The map_matcher node: session maps in, their alignment with the reference map out.
#pragma once

#include <map_matcher/MapMatcherConfig.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/belief/session_tracker.hpp"
#include "map_matcher/ros/common/reconfiguration.hpp"
#include "map_matcher/ros/common/rising_clock.hpp"
#include "map_matcher/ros/matching/alignment_broadcaster.hpp"
#include "map_matcher/ros/matching/change_map_service.hpp"
#include "map_matcher/ros/matching/frame_diagnostics.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/matching/map_serving.hpp"
#include "map_matcher/ros/matching/match_diagnostics.hpp"
#include "map_matcher/ros/matching/match_pose_publisher.hpp"
#include "map_matcher/ros/matching/match_services.hpp"
#include "map_matcher/ros/matching/operator_hand.hpp"
#include "map_matcher/ros/matching/overlay_publisher.hpp"
#include "map_matcher/ros/matching/reference_source.hpp"
#include "map_matcher/ros/matching/robot_announcer.hpp"
#include "map_matcher/ros/matching/robot_pose_source.hpp"
#include "map_matcher/ros/matching/session_map.hpp"
#include "map_matcher/ros/matching/state_speech.hpp"
#include "map_matcher/work/latest_job_worker.hpp"

namespace map_matcher::ros_matching {

/// Matches every session map to the reference maps on a worker thread, the newest first, and publishes what came of it
/// (names: names.hpp). A match that is accepted is broadcast on tf until a later one replaces it; one that fails is
/// told on `map_match` and changes nothing else. What is believed is decided by belief::SessionTracker alone. The
/// alignment is dropped when a map begins a new session, when the reference maps are replaced and when time goes back,
/// which means that a bag loops and the mapper may have started anew.
class MapMatcherServer {
 public:
  /// Throws std::exception, with the name of the file or the option, when one cannot be used.
  MapMatcherServer(ros::NodeHandle node, ros::NodeHandle private_node, const MapMatcherServerOptions& options);

 private:
  using MapEvent = ros::MessageEvent<const nav_msgs::OccupancyGrid>;
  using Answer = std::shared_ptr<std::promise<MapMatch>>;

  void onSessionMap(const MapEvent& event);
  void loadReferences(const MapMatcherServerOptions& options);
  void onReferences(const ReferenceMapList& references);
  void onOptions(const MapMatcherServerOptions& options);
  void onTick();
  void tellWhatIsMissing();

  MatchServices::Actions serviceActions();
  MatchDiagnostics::State diagnosticState();
  std::vector<ros_common::ContestedFrame> contestedFrames();
  MapsInUse mapsInUse();
  void suppose(const belief::Prior& prior);
  void forget(const std::string& service);
  std::optional<std::future<MapMatch>> matchSession();
  void submitMatch(const Answer& answer);
  MapMatch conclude(const SessionMap& session, const ReferenceMapList& references, const belief::Findings& findings);
  void announce(const SessionMap& session, const ReferenceMapPtr& reference, const search::SearchResult& result,
                const MapMatch& report);
  void draw(const SessionMap& session, const ReferenceMap& reference, const belief::Answer& answer, bool followed);
  void tellReport(MapMatch& report);
  void tell(const MapMatch& report);
  void complete(MapMatch& report) const;
  bool followClock(const ros::Time& now);
  void dropAlignment();
  void withdraw();

  std::mutex mutex_;  // guards the session and reference maps, and that no answer is published after it was outdated
  SessionMapPtr session_;  // the newest that can be used
  ReferenceMapList references_;
  belief::SessionTracker tracker_;
  MatchRecord record_;
  std::atomic<std::uint32_t> dropped_session_maps_{0};
  std::uint8_t last_status_ = MapMatch::STOPPED;  // the worker's
  ros_common::RisingClock clock_;                 // of the thread that spins

  ros::Publisher map_match_publisher_;
  AlignmentBroadcaster broadcaster_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_{tf_};
  RobotPoseSource robot_;
  MatchPosePublisher pose_publisher_;
  RobotAnnouncer announcer_;
  OverlayPublisher overlay_publisher_;
  StateSpeech speech_;
  ReferenceSource reference_source_;
  ros::Subscriber session_subscriber_;
  MapServing map_serving_;
  work::LatestJobWorker worker_;  // after all that its jobs use
  ros::Timer tick_timer_;
  ros::WallTimer waiting_timer_;
  OperatorHand operator_;
  std::optional<MatchServices> services_;
  std::optional<ChangeMapService> change_map_;
  std::optional<MatchDiagnostics> diagnostics_;
  FrameDiagnostics frame_diagnostics_;
  ros_common::Reconfiguration<MapMatcherConfig, MapMatcherServerOptions> reconfiguration_;
};

}  // namespace map_matcher::ros_matching
