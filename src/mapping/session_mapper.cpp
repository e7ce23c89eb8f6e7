#include "map_matcher/mapping/session_mapper.hpp"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/slam/CICP.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "map_matcher/mapping/beams.hpp"
#include "map_matcher/mapping/hit_counting_grid.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::mapping {
namespace {

constexpr int kMinHits = 10;             // fewer points do not tell a pose
constexpr double kPointSpacing = 0.03;   // [m] of the points that scans are matched to
constexpr double kThresholdDecay = 0.8;  // of the correspondence distance, at each convergence

bool isFinite(const grid::Rigid2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

mrpt::slam::CICP::TConfigParams icpParameters(const IcpOptions& options) {
  mrpt::slam::CICP::TConfigParams parameters;
  parameters.ICP_algorithm = mrpt::slam::icpClassic;
  parameters.maxIterations = static_cast<unsigned int>(options.max_iterations);
  parameters.thresholdDist = options.max_distance;
  parameters.thresholdAng = options.max_angle;
  parameters.smallestThresholdDist = options.min_distance;
  parameters.ALFA = kThresholdDecay;
  parameters.skip_cov_calculation = true;  // nobody asks for it
  return parameters;
}

/// Where the robot was when something was last done, and whether it has moved since.
struct Milestone {
  grid::Rigid2 pose;

  bool isPassed(const grid::Rigid2& now, double linear, double angular) const {
    const grid::Rigid2 motion = pose.inverse() * now;
    return motion.translation().norm() >= linear || std::abs(motion.yaw) >= angular;
  }
};

void insertPoint(const Eigen::Vector2d& point, mrpt::maps::CSimplePointsMap& points) {
  points.insertPoint(static_cast<float>(point.x()), static_cast<float>(point.y()));
}

/// Where the beams of a scan ended, all of them.
mrpt::maps::CSimplePointsMap hitsOf(const BeamFan& fan) {
  mrpt::maps::CSimplePointsMap points;
  for (const Beam& beam : fan.beams) {
    if (beam.hit) {
      insertPoint(beam.end, points);
    }
  }
  return points;
}

/// Where beams ended, at most one point for each square of kPointSpacing: the points grow with what was seen and not
/// with how often, so that a mapper that runs for long stays fast.
class ThinnedPoints {
 public:
  void add(const BeamFan& fan) {
    for (const Beam& beam : fan.beams) {
      if (beam.hit && taken_.insert(squareOf(beam.end)).second) {
        insertPoint(beam.end, points_);
      }
    }
  }

  const mrpt::maps::CSimplePointsMap& points() const { return points_; }

 private:
  static std::pair<int, int> squareOf(const Eigen::Vector2d& point) {
    return {static_cast<int>(std::floor(point.x() / kPointSpacing)),
            static_cast<int>(std::floor(point.y() / kPointSpacing))};
  }

  std::set<std::pair<int, int>> taken_;
  mrpt::maps::CSimplePointsMap points_;
};

/// The points and the grid of a session. They begin with its first scan. The points lie in the start frame, the base
/// frame of the first scan: MRPT keeps them in 32 bits, and odometry may be far from its origin.
struct Session {
  Session(const grid::Rigid2& T_session_base, const SessionMapperOptions& options)
      : T_session_start(T_session_base),
        grid(options.delta, {{options.xmin, options.ymin}, {options.xmax, options.ymax}}) {}

  grid::Rigid2 T_session_start;
  ThinnedPoints points;
  HitCountingGrid grid;
  Milestone last_match{T_session_start};
  Milestone last_drawing{T_session_start};
};

}  // namespace

class SessionMapper::Impl {
 public:
  explicit Impl(const SessionMapperOptions& options) : options_(options) {
    parameters::throwIfAny(problemsWith(options));
  }

  const SessionMapperOptions& options() const { return options_; }
  const grid::Rigid2& T_session_odom() const { return T_session_odom_; }
  grid::Rigid2 T_session_base() const { return T_session_odom_ * T_odom_base_; }
  bool hasMap() const { return session_.has_value(); }
  std::optional<grid::OccupancyGrid> map() const {
    return session_ ? std::make_optional(session_->grid.toOccupancyGrid(options_.occ_thresh)) : std::nullopt;
  }

  ScanReport addScan(const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan, const scan::LaserMount& mount) {
    if (!isFinite(T_odom_base) || !isFinite(mount.T_base_laser)) {
      throw std::invalid_argument("the odometry or the mount of the laser is not finite");
    }
    const BeamFan fan = castBeams(scan, mount, {options_.max_range, options_.max_urange});
    T_odom_base_ = T_odom_base;
    ScanReport report;
    report.hits = countHits(fan);
    if (session_ && !hasMoved()) {
      report.reason = "the robot has moved too little since the last scan";
    } else if (report.hits < kMinHits) {
      report.outcome = ScanOutcome::kTooFewHits;
      report.reason =
          std::to_string(report.hits) + " beams end at walls, expected at least " + std::to_string(kMinHits);
    } else if (!session_) {
      startSession(fan, report);
    } else {
      matchAndDraw(fan, report);
    }
    return report;
  }

 private:
  void startSession(const BeamFan& fan, ScanReport& report) {
    session_.emplace(T_session_base(), options_);
    draw(fan, report);
    if (report.outcome == ScanOutcome::kMapFull) {
      session_.reset();
    }
  }

  bool hasMoved() const {
    const grid::Rigid2 pose = T_session_base();
    return session_->last_match.isPassed(pose, options_.icp.linear_update, options_.icp.angular_update) ||
           session_->last_drawing.isPassed(pose, options_.linear_update, options_.angular_update);
  }

  void matchAndDraw(const BeamFan& fan, ScanReport& report) {
    match(fan, report);
    if (report.goodness <= options_.icp.min_goodness) {
      report.outcome = ScanOutcome::kNotFitting;
      report.reason = "only " + std::to_string(report.goodness) + " of the points fit the map, expected more than " +
                      std::to_string(options_.icp.min_goodness);
      return;
    }
    session_->last_match.pose = T_session_base();
    report.outcome = ScanOutcome::kMatched;
    report.reason = std::to_string(report.goodness) + " of the points fit the map";
    if (session_->last_drawing.isPassed(T_session_base(), options_.linear_update, options_.angular_update)) {
      draw(fan, report);
    }
  }

  /// Aligns the scan with the points of the session, and corrects the odometry when they fit.
  void match(const BeamFan& fan, ScanReport& report) {
    const mrpt::maps::CSimplePointsMap seen = hitsOf(fan);
    const grid::Rigid2 guess = session_->T_session_start.inverse() * T_session_base();
    mrpt::slam::CICP icp(icpParameters(options_.icp));
    mrpt::slam::CICP::TReturnInfo info;
    const auto result =
        icp.Align(&session_->points.points(), &seen, mrpt::poses::CPose2D(guess.x, guess.y, guess.yaw), info)
            ->getMeanVal();
    report.goodness = info.goodness;
    if (info.goodness > options_.icp.min_goodness) {
      const grid::Rigid2 T_start_base{result.x(), result.y(), grid::normalizeAngle(result.phi())};
      T_session_odom_ = session_->T_session_start * T_start_base * T_odom_base_.inverse();
    }
  }

  void draw(const BeamFan& fan, ScanReport& report) {
    const grid::Rigid2 pose = T_session_base();
    if (!session_->grid.draw(transform(pose, fan))) {
      report.outcome = ScanOutcome::kMapFull;
      report.reason = "the map would take more than " + std::to_string(HitCountingGrid::kMaxCells) + " cells";
      return;
    }
    session_->points.add(transform(session_->T_session_start.inverse() * pose, fan));
    session_->last_match.pose = pose;
    session_->last_drawing.pose = pose;
    report.outcome = ScanOutcome::kDrawn;
    report.reason = std::to_string(report.hits) + " beams that end at walls were drawn";
  }

  SessionMapperOptions options_;
  grid::Rigid2 T_session_odom_;
  grid::Rigid2 T_odom_base_;
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

ScanReport SessionMapper::addScan(const grid::Rigid2& T_odom_base, const scan::PlanarScan& scan,
                                  const scan::LaserMount& mount) {
  return impl_->addScan(T_odom_base, scan, mount);
}

void SessionMapper::reset() { impl_ = std::make_unique<Impl>(options()); }

}  // namespace map_matcher::mapping
