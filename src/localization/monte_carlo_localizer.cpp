#include "map_matcher/localization/monte_carlo_localizer.hpp"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <stdexcept>
#include <type_traits>

#include "map_matcher/grid/resample.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::localization {
namespace {

constexpr float kFreeProbability = 0.98F;  // that MRPT's cells are free
constexpr float kOccupiedProbability = 0.02F;
constexpr float kUnknownProbability = 0.5F;
constexpr double kLeastFree = 0.7;              // of cells that particles start in
constexpr float kBinSize = 0.5F;                // [m] of the bins of KLD sampling, as amcl's
constexpr float kBinAngle = 0.17453293F;        // [rad] as amcl's
constexpr double kLeastDeviation = 0.01;        // [m] of a motion, so that particles spread
constexpr double kLeastTurnDeviation = 0.0035;  // [rad]

bool isFinite(const grid::Rigid2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

mrpt::poses::CPose2D toMrpt(const grid::Rigid2& pose) { return {pose.x, pose.y, pose.yaw}; }

/// Sets MRPT's pointer to a map that `owner` keeps: one that shares it, or in older releases one that does not.
template <typename Pointer, typename Map>
void pointTo(Pointer& pointer, const std::shared_ptr<Map>& owner) {
  if constexpr (std::is_pointer_v<Pointer>) {
    pointer = owner.get();
  } else {
    pointer = owner;
  }
}

/// MRPT's map, whose frame is that of the grid, since it knows no origin with a yaw.
std::shared_ptr<mrpt::maps::COccupancyGridMap2D> toMrpt(const grid::OccupancyGrid& grid) {
  const auto resolution = static_cast<float>(grid.resolution());
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>();
  map->setSize(0.0F, resolution * static_cast<float>(grid.width()), 0.0F,
               resolution * static_cast<float>(grid.height()), resolution, kUnknownProbability);
  bool has_free = false;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::int8_t value = grid.at(x, y);
      if (value >= grid::kDefaultOccupiedThreshold) {
        map->setCell(x, y, kOccupiedProbability);
      } else if (value != grid::kUnknown) {
        map->setCell(x, y, kFreeProbability);
        has_free = true;
      }
    }
  }
  if (!has_free) {
    throw std::invalid_argument("the map has no free cell, expected room for a robot");
  }
  return map;
}

/// MRPT computes the likelihood of a beam that ends in a cell when the first one does; here all cells at once, so that
/// no update of the particles has to.
void computeLikelihoods(const MonteCarloOptions& options, mrpt::maps::COccupancyGridMap2D& map) {
  auto& likelihood = map.likelihoodOptions;
  likelihood.likelihoodMethod = mrpt::maps::COccupancyGridMap2D::lmLikelihoodField_Thrun;
  likelihood.enableLikelihoodCache = true;
  likelihood.LF_stdHit = static_cast<float>(options.laser_sigma_hit);
  likelihood.LF_zHit = static_cast<float>(options.laser_z_hit);
  likelihood.LF_zRandom = static_cast<float>(options.laser_z_rand);
  likelihood.LF_maxRange = static_cast<float>(options.laser_max_range);
  likelihood.LF_maxCorrsDistance = static_cast<float>(options.laser_likelihood_max_dist);
  likelihood.LF_decimation = 1;  // the beams are chosen before
  mrpt::maps::CSimplePointsMap row;
  for (std::size_t y = 0; y < map.getSizeY(); ++y) {
    row.clear();
    for (std::size_t x = 0; x < map.getSizeX(); ++x) {
      row.insertPoint(map.idx2x(x), map.idx2y(y));
    }
    map.computeLikelihoodField_Thrun(&row);
  }
}

mrpt::bayes::CParticleFilter filterOf(const MonteCarloOptions& options) {
  mrpt::bayes::CParticleFilter filter;
  filter.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
  filter.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prMultinomial;  // what KLD sampling can do
  filter.m_options.adaptiveSampleSize = true;
  filter.m_options.sampleSize = static_cast<unsigned int>(options.max_particles);
  filter.m_options.powFactor = options.likelihood_power;
  return filter;
}

void configure(mrpt::slam::TKLDParams& kld, const MonteCarloOptions& options) {
  kld.KLD_binSize_XY = kBinSize;
  kld.KLD_binSize_PHI = kBinAngle;
  kld.KLD_epsilon = static_cast<float>(options.kld_err);
  kld.KLD_delta = static_cast<float>(0.5 * std::erfc(options.kld_z / std::sqrt(2.0)));
  kld.KLD_minSampleSize = static_cast<unsigned int>(options.min_particles);
  kld.KLD_maxSampleSize = static_cast<unsigned int>(options.max_particles);
}

mrpt::obs::CActionRobotMovement2D::TMotionModelOptions motionModelOf(const MonteCarloOptions& options) {
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
  model.gaussianModel = {std::sqrt(options.odom_alpha3),
                         std::sqrt(options.odom_alpha4),
                         std::sqrt(options.odom_alpha2),
                         std::sqrt(options.odom_alpha1),
                         kLeastDeviation,
                         kLeastTurnDeviation};
  return model;
}

/// So many evenly spaced beams of a scan as amcl takes; nothing when none of them measured anything.
mrpt::obs::CObservation2DRangeScan::Ptr observationOf(const scan::MountedScan& mounted, int max_beams) {
  const scan::PlanarScan& scan = mounted.scan;
  scan.validate();
  const std::size_t step = std::max<std::size_t>(1, (scan.ranges.size() - 1) / static_cast<std::size_t>(max_beams - 1));
  const std::size_t count = (scan.ranges.size() - 1) / step + 1;
  auto observation = mrpt::obs::CObservation2DRangeScan::Create();
  observation->resizeScan(count);
  bool measured_any = false;
  for (std::size_t i = 0; i < count; ++i) {
    const float range = scan.ranges[i * step];
    const auto measured = static_cast<double>(range);
    const bool is_valid = measured >= scan.range_min && measured < scan.range_max;
    observation->setScanRange(i, is_valid ? range : 0.0F);
    observation->setScanRangeValidity(i, is_valid);
    measured_any = measured_any || is_valid;
  }
  if (!measured_any || count < 2) {
    return nullptr;
  }
  // MRPT counts angles from the middle of the scan.
  const double turn = mounted.mount.upside_down ? -1.0 : 1.0;
  const double aperture = scan.angle_increment * static_cast<double>((count - 1) * step);
  const grid::Rigid2& T_base_laser = mounted.mount.T_base_laser;
  observation->aperture = static_cast<float>(std::abs(aperture));
  observation->rightToLeft = turn * scan.angle_increment > 0.0;
  observation->maxRange = static_cast<float>(scan.range_max);
  observation->sensorPose = mrpt::poses::CPose3D(T_base_laser.x, T_base_laser.y, 0.0,
                                                 T_base_laser.yaw + turn * (scan.angle_min + 0.5 * aperture), 0.0, 0.0);
  return observation;
}

}  // namespace

class MonteCarloLocalizer::Impl {
 public:
  Impl(const grid::OccupancyGrid& map, const MonteCarloOptions& options) : options_(options), seeds_(options.seed) {
    parameters::throwIfAny(problemsWith(options));
    T_map_grid_ = map.geometry().T_map_grid;
    const bool is_fine = map.resolution() < options.map_resolution;
    map_ = toMrpt(is_fine ? grid::resample(map, options.map_resolution) : map);
    computeLikelihoods(options, *map_);
    filter_ = filterOf(options);
    pointTo(particles_.options.metricMap, map_);
    configure(particles_.options.KLD_params, options);
    reset();
  }

  void reset() {
    drawAnew();
    particles_.resetUniformFreeSpace(map_.get(), kLeastFree, options_.max_particles);
    T_odom_weighed_.reset();
    summarize();
  }

  bool add(const grid::Rigid2& T_odom_base, const std::vector<scan::MountedScan>& scans) {
    if (!isFinite(T_odom_base)) {
      throw std::invalid_argument("the odometry is not finite");
    }
    mrpt::obs::CSensoryFrame observations;
    for (const scan::MountedScan& scan : scans) {
      if (const auto observation = observationOf(scan, options_.laser_max_beams)) {
        observations.insert(observation);
      }
    }
    T_odom_base_ = T_odom_base;
    if (observations.empty() || !hasMoved()) {
      return false;
    }
    weigh(observations);
    return true;
  }

  MonteCarloEstimate estimate() const {
    MonteCarloEstimate estimate = weighed_;
    if (T_odom_weighed_) {
      estimate.T_map_base = weighed_.T_map_base * (T_odom_weighed_->inverse() * T_odom_base_);
    }
    return estimate;
  }

 private:
  /// MRPT's random numbers are global: what others drew must not matter.
  void drawAnew() {
    const auto seed = static_cast<std::uint32_t>(seeds_());
    mrpt::random::getRandomGenerator() = mrpt::random::CRandomGenerator(seed);  // randomize() keeps half a Gaussian
  }

  bool hasMoved() const {
    if (!T_odom_weighed_) {
      return true;
    }
    const grid::Rigid2 motion = T_odom_weighed_->inverse() * T_odom_base_;
    return motion.translation().norm() >= options_.update_min_d || std::abs(motion.yaw) >= options_.update_min_a;
  }

  void weigh(const mrpt::obs::CSensoryFrame& observations) {
    drawAnew();
    if (T_odom_weighed_) {
      mrpt::obs::CActionRobotMovement2D movement;
      movement.computeFromOdometry(toMrpt(T_odom_weighed_->inverse() * T_odom_base_), motionModelOf(options_));
      mrpt::obs::CActionCollection actions;
      actions.insert(movement);
      filter_.executeOn(particles_, &actions, &observations);
    } else {
      filter_.executeOn(particles_, nullptr, &observations);
    }
    T_odom_weighed_ = T_odom_base_;
    summarize();
  }

  void summarize() {
    const auto [covariance, mean] = particles_.getCovarianceAndMean();
    weighed_.T_map_base = T_map_grid_ * grid::Rigid2{mean.x(), mean.y(), mean.phi()};
    weighed_.position_deviation = std::sqrt(covariance(0, 0) + covariance(1, 1));
    weighed_.yaw_deviation = std::sqrt(covariance(2, 2));
    weighed_.particles = static_cast<int>(particles_.m_particles.size());
  }

  MonteCarloOptions options_;
  std::mt19937_64 seeds_;
  grid::Rigid2 T_map_grid_;
  std::shared_ptr<mrpt::maps::COccupancyGridMap2D> map_;
  mrpt::bayes::CParticleFilter filter_;
  mrpt::slam::CMonteCarloLocalization2D particles_;  // in the frame of the grid
  grid::Rigid2 T_odom_base_;                         // of the last scans
  std::optional<grid::Rigid2> T_odom_weighed_;       // of the last scans that were used; none: particles everywhere
  MonteCarloEstimate weighed_;                       // when the particles were last weighed
};

bool MonteCarloLocalizer::available() { return true; }

MonteCarloLocalizer::MonteCarloLocalizer(const grid::OccupancyGrid& map, const MonteCarloOptions& options)
    : impl_(std::make_unique<Impl>(map, options)) {}
MonteCarloLocalizer::~MonteCarloLocalizer() = default;

void MonteCarloLocalizer::reset() { impl_->reset(); }

bool MonteCarloLocalizer::add(const grid::Rigid2& T_odom_base, const std::vector<scan::MountedScan>& scans) {
  return impl_->add(T_odom_base, scans);
}

MonteCarloEstimate MonteCarloLocalizer::estimate() const { return impl_->estimate(); }

}  // namespace map_matcher::localization
