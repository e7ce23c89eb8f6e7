#include "map_matcher/mapping/session_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "map_matcher/mapping/beams.hpp"
#include "map_matcher/mapping/hit_counting_grid.hpp"
#include "map_matcher/mapping/scan_matching.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::mapping {
namespace {

constexpr int kMinHits = 10;                // fewer say nothing
constexpr double kWallMargin = 0.3;         // [m] behind a wall: what ends there was seen through it
constexpr double kMostContradiction = 0.5;  // of the beams that may go through walls
constexpr int kMostContradictions = 10;     // scans in a row, until the session ends
constexpr int kManyPoints = 30;             // in known territory, that can tell odometry to be wrong
constexpr double kPoorFit = 0.3;            // of the points lie at walls where something is wrong, or people walk
constexpr double kGoodFit = 0.8;            // lie at walls where nothing can be wrong
constexpr double kMuchLikelier = 15.0;      // logarithm, that believing the walls against the odometry takes
constexpr double kStandstill = 0.01;        // [m, rad]
constexpr double kSlip = 0.3;               // [m], standard deviation of a motion that odometry did not measure
constexpr double kTwist = 0.2;              // [rad] of its turning
constexpr double kLongestJump = 0.5;        // [m] between two scans that came together
constexpr double kWidestJump = 0.5;         // [rad]
constexpr double kFastest = 5.0;            // [m/s] that robots are
constexpr double kFastestTurn = 10.0;       // [rad/s]

bool isFinite(const grid::Rigid2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

/// Where the robot was when something was last done with a laser's scan, and whether it has moved since.
struct Milestone {
  grid::Rigid2 pose;

  bool isPassed(const grid::Rigid2& now, double linear, double angular) const {
    const grid::Rigid2 motion = pose.inverse() * now;
    return motion.translation().norm() >= linear || std::abs(motion.yaw) >= angular;
  }
};

/// What was done with the scans of a laser.
struct LaserHistory {
  Milestone last_match;
  Milestone last_drawing;
  double last_drawing_time = 0.0;  // [s]
};

BeamFan everyFourth(const BeamFan& fan) {
  BeamFan few{fan.origin, {}};
  for (std::size_t i = 0; i < fan.beams.size(); i += 4) {
    few.beams.push_back(fan.beams[i]);
  }
  return few;
}

/// The same pose, where odometry is not to be trusted.
PoseEstimate doubtful(PoseEstimate estimate) {
  estimate.covariance += Eigen::Vector3d(kSlip * kSlip, kSlip * kSlip, kTwist * kTwist).asDiagonal();
  return estimate;
}

/// Of the first map: around the robot, so that a map costs as little however far off odometry began.
Extent extentAround(const Eigen::Vector2d& robot, const SessionMapperOptions& options) {
  const Eigen::Vector2d middle = (robot / options.delta).array().round() * options.delta;
  return {middle + Eigen::Vector2d(options.xmin, options.ymin), middle + Eigen::Vector2d(options.xmax, options.ymax)};
}

/// What was drawn. Begins with the first scan.
struct Session {
  Session(const SessionMapperOptions& options, const Eigen::Vector2d& robot)
      : grid(options.delta, extentAround(robot, options)) {}

  HitCountingGrid grid;
  std::map<std::size_t, LaserHistory> lasers;  // of which a scan was drawn
};

}  // namespace

class SessionMapper::Impl {
 public:
  explicit Impl(const SessionMapperOptions& options) : options_(options) {
    parameters::throwIfAny(problemsWith(options));
  }

  const SessionMapperOptions& options() const { return options_; }
  grid::Rigid2 T_session_odom() const { return estimate_.T_session_base * T_odom_base_.inverse(); }
  const grid::Rigid2& T_session_base() const { return estimate_.T_session_base; }
  bool hasMap() const { return session_.has_value(); }
  std::optional<grid::OccupancyGrid> map() const {
    return session_ ? std::make_optional(session_->grid.toOccupancyGrid(options_.occ_thresh)) : std::nullopt;
  }

  ScanReport addScan(double time, const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan,
                     const scan::LaserMount& mount, std::size_t laser) {
    if (!std::isfinite(time) || !isFinite(T_odom_base) || !isFinite(mount.T_base_laser)) {
      throw std::invalid_argument("the time, the odometry or the mount of the laser is not finite");
    }
    const BeamFan fan = castBeams(scan, mount, {options_.max_range, options_.max_urange});
    ScanReport report;
    follow(time, T_odom_base, report);
    report.hits = countHits(fan);
    if (session_ && !isDue(laser)) {
      report.reason = "the robot has moved too little since the last scan";
    } else if (report.hits < kMinHits) {
      report.outcome = ScanOutcome::kTooFewHits;
      report.reason =
          std::to_string(report.hits) + " beams end at walls, expected at least " + std::to_string(kMinHits);
    } else if (!session_) {
      startSession(laser, fan, report);
    } else {
      matchAndDraw(laser, fan, report);
    }
    return report;
  }

 private:
  /// Moves on as the odometry did, unless no robot moves like that.
  void follow(double time, const grid::Rigid2& T_odom_base, ScanReport& report) {
    const grid::Rigid2 motion = T_odom_base_.inverse() * T_odom_base;
    const double duration = std::max(0.0, time - time_);
    if (!session_) {
      estimate_ = {T_odom_base, Eigen::Matrix3d::Zero()};
    } else if (motion.translation().norm() > kLongestJump + kFastest * duration ||
               std::abs(motion.yaw) > kWidestJump + kFastestTurn * duration) {
      std::ostringstream text;
      text << "the odometry jumped by " << motion.translation().norm() << " m and " << motion.yaw << " rad within "
           << duration << " s: the robot is taken to be where it was";
      report.alarm = text.str();
      estimate_ = doubtful(estimate_);
    } else {
      estimate_ = moved(estimate_, motion, duration, options_.odometry);
    }
    T_odom_base_ = T_odom_base;
    time_ = time;
  }

  void startSession(std::size_t laser, const BeamFan& fan, ScanReport& report) {
    session_.emplace(options_, estimate_.T_session_base.translation());
    draw(laser, fan, report);
    if (report.outcome == ScanOutcome::kMapFull) {
      session_.reset();
    }
  }

  bool isDue(std::size_t laser) const {
    const auto history = session_->lasers.find(laser);
    return history == session_->lasers.end() || isDueToDraw(history->second) ||
           history->second.last_match.isPassed(T_session_base(), options_.match_linear_update,
                                               options_.match_angular_update);
  }

  bool isDueToDraw(const LaserHistory& history) const {
    return history.last_drawing.isPassed(T_session_base(), options_.linear_update, options_.angular_update) ||
           (options_.temporal_update >= 0.0 && time_ - history.last_drawing_time >= options_.temporal_update);
  }

  void matchAndDraw(std::size_t laser, const BeamFan& fan, ScanReport& report) {
    const ScanMatch match = bestMatch(laser, fan, report);
    report.goodness = match.fit;
    if (match.all_fit < kPoorFit) {  // people who walked off were no walls, but leave the others where they were
      const double contradiction = session_->grid.shareThroughWalls(
          transform(match.estimate.T_session_base, everyFourth(fan)), options_.occ_thresh, kWallMargin);
      if (contradiction > kMostContradiction) {
        refuse(laser, fan, contradiction, report);
        return;
      }
    }
    contradictions_ = 0;
    estimate_ = match.estimate;
    report.outcome = ScanOutcome::kMatched;
    report.reason = std::to_string(match.fit) + " of " + std::to_string(match.points) + " points lie at walls";
    const auto history = session_->lasers.find(laser);
    if (history == session_->lasers.end() || isDueToDraw(history->second)) {
      draw(laser, fan, report);
    } else {
      history->second.last_match.pose = T_session_base();
    }
  }

  /// The pose that the scan and the odometry tell together or, where the walls show a motion that the odometry did not
  /// measure, that of the walls.
  ScanMatch bestMatch(std::size_t laser, const BeamFan& fan, ScanReport& report) const {
    const ScanMatchOptions options{options_.sigma, options_.occ_thresh};
    ScanMatch match = matchScan(session_->grid, fan, estimate_, options);
    const auto history = session_->lasers.find(laser);
    const bool stands = history != session_->lasers.end() &&
                        !history->second.last_match.isPassed(T_session_base(), kStandstill, kStandstill);
    if (match.points < kManyPoints || (match.fit > kGoodFit && !stands)) {
      return match;
    }
    ScanMatch other = matchScan(session_->grid, fan, doubtful(estimate_), options);
    if (other.fit < match.fit || other.misfit > match.misfit - kMuchLikelier) {
      return match;
    }
    const grid::Rigid2 slip = estimate_.T_session_base.inverse() * other.estimate.T_session_base;
    std::ostringstream text;
    text << "the walls show that the robot is " << slip.translation().norm() << " m and " << slip.yaw
         << " rad from where the odometry has it: the walls are believed";
    report.alarm = text.str();
    return other;
  }

  void refuse(std::size_t laser, const BeamFan& fan, double contradiction, ScanReport& report) {
    report.outcome = ScanOutcome::kNotFitting;
    std::ostringstream text;
    text << 100.0 * contradiction << " % of the beams go through walls of the map, expected at most "
         << 100.0 * kMostContradiction << " %";
    report.reason = text.str();
    if (++contradictions_ < kMostContradictions) {
      return;
    }
    text << ", " << contradictions_ << " scans in a row: the session ends, and a new one begins";
    report.alarm = text.str();
    report.new_session = true;
    session_.reset();
    contradictions_ = 0;
    estimate_ = {T_odom_base_, Eigen::Matrix3d::Zero()};
    startSession(laser, fan, report);
  }

  void draw(std::size_t laser, const BeamFan& fan, ScanReport& report) {
    if (!session_->grid.draw(transform(T_session_base(), fan))) {
      report.outcome = ScanOutcome::kMapFull;
      report.reason = "the map would take more than " + std::to_string(HitCountingGrid::kMaxCells) + " cells";
      return;
    }
    session_->lasers[laser] = {{T_session_base()}, {T_session_base()}, time_};
    report.outcome = ScanOutcome::kDrawn;
    report.reason = std::to_string(report.hits) + " beams that end at walls were drawn";
  }

  SessionMapperOptions options_;
  PoseEstimate estimate_;
  grid::Rigid2 T_odom_base_;
  double time_ = 0.0;       // [s] of the last scan
  int contradictions_ = 0;  // scans in a row that saw through walls
  std::optional<Session> session_;
};

SessionMapper::SessionMapper(const SessionMapperOptions& options) : impl_(std::make_unique<Impl>(options)) {}
SessionMapper::~SessionMapper() = default;
SessionMapper::SessionMapper(SessionMapper&&) noexcept = default;
SessionMapper& SessionMapper::operator=(SessionMapper&&) noexcept = default;

const SessionMapperOptions& SessionMapper::options() const { return impl_->options(); }
bool SessionMapper::hasMap() const { return impl_->hasMap(); }
grid::Rigid2 SessionMapper::T_session_base() const { return impl_->T_session_base(); }
grid::Rigid2 SessionMapper::T_session_odom() const { return impl_->T_session_odom(); }
std::optional<grid::OccupancyGrid> SessionMapper::map() const { return impl_->map(); }

ScanReport SessionMapper::addScan(double time, const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan,
                                  const scan::LaserMount& mount, std::size_t laser) {
  return impl_->addScan(time, T_odom_base, scan, mount, laser);
}

void SessionMapper::reset() { impl_ = std::make_unique<Impl>(options()); }

}  // namespace map_matcher::mapping
