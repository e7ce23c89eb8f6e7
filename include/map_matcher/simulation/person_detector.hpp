/// \file
/// What a person detector makes of the people in a scan.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/pedestrians.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {

/// A detector of people's legs. The defaults are what the authors of DR-SPAAM found for it (Jia, Hermans, Leibe:
/// "DR-SPAAM: A spatial-attention and auto-regressive model for person detection in 2D range data", 2020): precision
/// and recall, and the rate on a robot's computer. Ranges stand in parametersOf().
struct PersonDetectorOptions {
  double recall = 0.70;           ///< Share of the people in sight who are detected with score_threshold or more.
  double precision = 0.75;        ///< Share of the detections with score_threshold or more that are people.
  double score_threshold = 0.4;   ///< Score at which recall and precision hold; the report's section 2.2.
  double correlation_time = 1.0;  ///< [s] Misses, false alarms and position errors persist about so long.
  double position_sigma = 0.08;   ///< [m] Standard deviation of a position along x and y.
  double range = 12.0;            ///< [m] Nobody farther away is detected.
  int min_rays = 2;               ///< Somebody is in sight whose legs so many rays return from.
  double false_alarms = 0.2;      ///< In a scan on average, at least, however few people are there.
  double latency = 0.045;         ///< [s] From the scan to its detections.
  double rate = 22.0;             ///< [Hz] Of scans that it can work through; others are passed over.
};

/// The parameters that fill `options`; their names begin with "detector_".
parameters::ParameterList parametersOf(PersonDetectorOptions& options);

/// Somebody, or what was taken for somebody.
struct DetectedPerson {
  Eigen::Vector2d position;  ///< In the lidar's frame [m].
  double score = 0.0;        ///< From 0.1 to 1, as a confidence.
};

/// What was detected in one scan.
struct DetectedPeople {
  double time = 0.0;                   ///< Of the scan [s].
  double arrival = 0.0;                ///< When the detections are there [s].
  std::vector<DetectedPerson> people;  ///< At least 0.5 m from each other, the highest score first; none: nobody.
};

/// Detects the people whom one lidar sees. Each of them has a score that drifts (an Ornstein-Uhlenbeck process through
/// a logistic function), so that somebody who is missed is missed for several scans. So has each of many places at
/// walls and furniture that look like legs; some of those stand out for good. How many of these exceed the threshold
/// follows the number of people in sight lately, since the precision is asked for. Positions err likewise. Of
/// detections nearer than 0.5 m to each other the one with the highest score remains, so in a dense crowd the recall is
/// lower. The same random numbers give the same detections. Not thread-safe.
class PersonDetector {
 public:
  /// Looks for false alarms at the occupied cells of `map`. Throws std::invalid_argument that names every option out of
  /// its range.
  PersonDetector(const grid::OccupancyGrid& map, const PersonDetectorOptions& options, const RandomNumbers& random);

  /// Detections in a scan at `time` [s]; std::nullopt when the detector is busy with an earlier one. `people` are
  /// always the same, in the same order; `view` is of their legsOf(). Times rise.
  std::optional<DetectedPeople> detect(const LidarView& view, const std::vector<Person>& people,
                                       const grid::Rigid2& T_map_lidar, double time);

 private:
  /// How somebody, or a place, looks to the detector; each number of variance 1.
  struct Impression {
    double bias = 0.0;  // for good
    double score = 0.0;
    double x = 0.0;
    double y = 0.0;
  };

  struct Candidate {
    DetectedPerson detection;
    bool is_person;
  };

  struct Site {
    Eigen::Vector2d position;
    Impression impression;
  };

  void findSites(const grid::OccupancyGrid& map);
  Impression firstImpression();
  void drift(Impression& impression, double memory);
  void driftAll(std::size_t num_people, double time);
  std::vector<Candidate> peopleIn(const LidarView& view, const std::vector<Person>& people,
                                  const grid::Rigid2& T_lidar_map) const;
  std::vector<Candidate> falseAlarmsIn(const scan::PlanarScan& scan, const grid::Rigid2& T_lidar_map) const;
  DetectedPerson detection(const Eigen::Vector2d& position, const Impression& impression, double evidence) const;
  static std::vector<Candidate> bestOf(std::vector<Candidate> candidates);
  void adjust(std::size_t people_in_sight, const std::vector<Candidate>& kept, double time);

  PersonDetectorOptions options_;
  RandomNumbers random_;
  std::vector<Site> sites_;              // that look like legs, in the map frame
  std::vector<Impression> impressions_;  // of the people
  std::optional<double> last_time_;
  double ease_ = 0.0;          // of detecting people, in standard deviations of their scores
  double false_alarms_ = 0.0;  // in a scan, wanted
};

}  // namespace map_matcher::simulation
