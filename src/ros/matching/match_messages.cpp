#include "map_matcher/ros/matching/match_messages.hpp"

#include <Eigen/Core>
#include <limits>

#include "map_matcher/grid/pose_covariance.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

std::uint8_t statusConstant(belief::MatchStatus status) {
  switch (status) {
    case belief::MatchStatus::kMatched:
      return MapMatch::MATCHED;
    case belief::MatchStatus::kBelowAcceptanceRatio:
      return MapMatch::BELOW_ACCEPTANCE_RATIO;
    case belief::MatchStatus::kNoReference:
      return MapMatch::NO_REFERENCE;
    case belief::MatchStatus::kEmptyReference:
      return MapMatch::EMPTY_REFERENCE;
    case belief::MatchStatus::kTooFewSessionCells:
      return MapMatch::TOO_FEW_SESSION_CELLS;
    case belief::MatchStatus::kSessionTooLarge:
      return MapMatch::SESSION_TOO_LARGE;
    case belief::MatchStatus::kNotCertified:
      return MapMatch::NOT_CERTIFIED;
    case belief::MatchStatus::kAmbiguous:
      return MapMatch::AMBIGUOUS;
    case belief::MatchStatus::kDoubtful:
      return MapMatch::DOUBTFUL;
    case belief::MatchStatus::kUnconfirmed:
      return MapMatch::UNCONFIRMED;
    case belief::MatchStatus::kRobotLost:
      return MapMatch::ROBOT_LOST;
    case belief::MatchStatus::kStopped:
      break;
  }
  return MapMatch::STOPPED;
}

const char* refusalText(std::uint8_t status) {
  switch (status) {
    case MapMatch::EQUAL_FRAMES:
      return "equal_frames";
    case MapMatch::INVALID_REQUEST:
      return "invalid_request";
    case MapMatch::FAILED:
      return "failed";
    default:
      return "invalid_map";
  }
}

MatchStage toMessage(const search::StageReport& stage) {
  MatchStage message;
  message.name = stage.name;
  message.answered = stage.answered;
  message.resolution = stage.resolution;
  message.rotations = stage.rotations;
  message.rotation_step = stage.rotation_step;
  message.matched_cells = stage.matched_cells;
  message.total_cells = stage.total_cells;
  message.ratio = stage.ratio;
  message.nodes_scored = stage.nodes_scored;
  message.nodes_expanded = stage.nodes_expanded;
  message.initialization_time = stage.initialization_time;
  message.rotation_expansion_time = stage.rotation_expansion_time;
  message.depth_first_search_time = stage.depth_first_search_time;
  return message;
}

Evidence toMessage(const belief::Evidence& piece) {
  Evidence message;
  message.name = piece.name;
  message.value = piece.value;
  message.limit = piece.limit;
  message.text = piece.text;
  switch (piece.bearing) {
    case belief::Bearing::kFor:
      message.bearing = Evidence::FOR;
      break;
    case belief::Bearing::kAgainst:
      message.bearing = Evidence::AGAINST;
      break;
    case belief::Bearing::kSilent:
      message.bearing = Evidence::SILENT;
      break;
  }
  return message;
}

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
const grid::Rigid2 kNoPose{kNothing, kNothing, kNothing};
const Eigen::Matrix3d kNoCovariance = Eigen::Matrix3d::Constant(kNothing);

void fillPose(MapMatch& message, const grid::Rigid2& T_reference_session, const Eigen::Matrix3d& covariance) {
  message.T_reference_session = ros_common::toTransformMessage(T_reference_session);
  message.x = T_reference_session.x;
  message.y = T_reference_session.y;
  message.yaw = T_reference_session.yaw;
  Eigen::Map<RowMajor>(message.covariance.data()) = covariance;
}

void fillCertificate(MapMatch& message, const search::SearchResult& result) {
  message.certified = result.certified;
  message.replaced = result.replaced;
  message.hit_cells = result.hit_cells;
  message.hit_ratio = result.hit_ratio;
  message.upper_bound = result.upper_bound;
  message.has_runner_up = result.runner_up.has_value();
  if (result.runner_up) {
    const grid::Rigid2& T_reference_session = result.runner_up->T_reference_session;
    message.runner_up_x = T_reference_session.x;
    message.runner_up_y = T_reference_session.y;
    message.runner_up_yaw = T_reference_session.yaw;
    message.runner_up_ratio = result.runner_up->ratio;
  }
  message.margin = result.margin;
  message.runner_up_proven = result.runner_up_proven;
}

void fillSurroundings(MapMatch& message, const belief::Surroundings& nearby) {
  message.nearby_cells = nearby.cells;
  message.nearby_ratio = nearby.ratio;
  message.nearby_walls = nearby.walls;
  message.nearby_walls_ratio = nearby.walls_ratio;
}

}  // namespace

MapMatch toMessage(const belief::Answer& answer) {
  const search::SearchResult& result = answer.search;
  MapMatch message;
  message.status = statusConstant(answer.status);
  message.status_text = toString(answer.status);
  message.reason = answer.reason;
  fillPose(message, answer.alignment().value_or(kNoPose), answer.matched() ? result.covariance : kNoCovariance);
  message.refined = result.refined;
  message.matched_cells = result.matched_cells;
  message.total_cells = result.total_cells;
  message.ratio = result.ratio;
  fillCertificate(message, result);
  message.probability = answer.probability;
  fillSurroundings(message, answer.nearby);
  for (const belief::Evidence& piece : answer.evidence) {
    message.evidence.push_back(toMessage(piece));
  }
  for (const search::StageReport& stage : result.stages) {
    message.stages.push_back(toMessage(stage));
  }
  message.search_time = result.search_time;
  message.reference_time = result.reference_time;
  return message;
}

MapMatch toMessage(const belief::Decision& decision) {
  MapMatch message = toMessage(decision.answer);
  message.maps_since_proof = static_cast<std::uint32_t>(decision.maps_since_proof);
  return message;
}

std::uint8_t stateConstant(belief::SessionState state) {
  switch (state) {
    case belief::SessionState::kSearching:
      break;
    case belief::SessionState::kTentative:
      return MapMatch::TENTATIVE;
    case belief::SessionState::kLocalized:
      return MapMatch::LOCALIZED;
    case belief::SessionState::kLost:
      return MapMatch::LOST;
  }
  return MapMatch::SEARCHING;
}

MapMatch refusal(std::uint8_t status, const std::string& reason) {
  MapMatch message;
  message.status = status;
  message.status_text = refusalText(status);
  message.reason = reason;
  fillPose(message, kNoPose, kNoCovariance);
  return message;
}

geometry_msgs::PoseWithCovariance robotPose(const MapMatch& match, const grid::Rigid2& T_session_base) {
  const grid::Rigid2 T_reference_session{match.x, match.y, match.yaw};
  const Eigen::Matrix3d covariance = Eigen::Map<const RowMajor>(match.covariance.data());
  return ros_common::toMessage(T_reference_session * T_session_base,
                               grid::covarianceOfProduct(T_reference_session, covariance, T_session_base));
}

}  // namespace map_matcher::ros_matching
