#include "map_matcher/simulation/person_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/place_index.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kApart = 0.5;             // [m] between two detections, at least
constexpr double kLowestScore = 0.1;       // of a detection
constexpr double kPersonSpread = 1.5;      // of people's scores, on the logistic scale
constexpr double kFalseAlarmSpread = 1.0;  // of false alarms' scores: few are high
constexpr double kSiteSpacing = 0.6;       // [m] between two places of false alarms
constexpr double kSiteBias = 0.5;          // share of a site's score variance that never changes
constexpr double kOnSurface = 0.3;         // [m] from a scanned surface is on it
constexpr double kEaseRate = 0.02;         // [1/s] for each person who was missed too many
constexpr double kMostEase = 1.5;          // [standard deviations]
constexpr double kFalseAlarmRate = 0.1;    // [1/s]
constexpr double kMostFalseAlarms = 0.8;   // of the sites in sight

/// The number that a normally distributed one (mean 0, variance 1) is below with this probability.
double normalQuantile(double probability) {
  double low = -8.0;
  double high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool is_below = 0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability;
    (is_below ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }
double logit(double p) { return std::log(p / (1.0 - p)); }

bool isSurface(const grid::OccupancyGrid& map, int x, int y) {
  const auto is_free = [&](int free_x, int free_y) {
    return map.geometry().contains({free_x, free_y}) && map.at(free_x, free_y) >= grid::kFree &&
           map.at(free_x, free_y) < grid::kDefaultOccupiedThreshold;
  };
  return map.at(x, y) >= grid::kDefaultOccupiedThreshold &&
         (is_free(x - 1, y) || is_free(x + 1, y) || is_free(x, y - 1) || is_free(x, y + 1));
}

/// Whether a point of the lidar's frame [m] lies on what the scan shows.
bool isOnSurface(const scan::PlanarScan& scan, const Eigen::Vector2d& point) {
  const double ray = std::round((std::atan2(point.y(), point.x()) - scan.angle_min) / scan.angle_increment);
  if (ray < 0.0 || ray >= static_cast<double>(scan.ranges.size())) {
    return false;
  }
  return std::abs(static_cast<double>(scan.ranges[static_cast<std::size_t>(ray)]) - point.norm()) < kOnSurface;
}

}  // namespace

parameters::ParameterList parametersOf(PersonDetectorOptions& options) {
  return {
      {"detector_recall", "", "Share of the people in sight who are detected.", &options.recall, 0.01, 0.99},
      {"detector_precision", "", "Share of the detections that are people.", &options.precision, 0.1, 1.0},
      {"detector_score_threshold", "", "Score from which a detection counts.", &options.score_threshold, 0.11, 0.95},
      {"detector_correlation_time", "s", "Misses, false alarms and position errors persist about so long.",
       &options.correlation_time, 0.01, 60.0},
      {"detector_position_sigma", "m", "Standard deviation of a detection along x and y.", &options.position_sigma, 0.0,
       0.5},
      {"detector_range", "m", "Nobody farther away is detected.", &options.range, 1.0, 50.0},
      {"detector_min_rays", "", "Rays on somebody's legs that it takes to detect them.", &options.min_rays, 1, 100},
      {"detector_false_alarms", "", "False alarms in a scan, at least, however few people are there.",
       &options.false_alarms, 0.0, 20.0},
      {"detector_latency", "s", "From a scan to its detections.", &options.latency, 0.0, 5.0},
      {"detector_rate", "Hz", "Scans that the detector can work through.", &options.rate, 0.1, 1000.0},
  };
}

PersonDetector::PersonDetector(const grid::OccupancyGrid& map, const PersonDetectorOptions& options,
                               const RandomNumbers& random)
    : options_(options), random_(random) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options_)));
  findSites(map);
}

/// Random places at the surfaces of walls and furniture.
void PersonDetector::findSites(const grid::OccupancyGrid& map) {
  std::vector<grid::Cell> cells;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (isSurface(map, x, y)) {
        cells.push_back({x, y});
      }
    }
  }
  // In the frame of the grid, whose box is known.
  const double resolution = map.resolution();
  PlaceIndex index({0.0, 0.0}, {map.width() * resolution, map.height() * resolution}, kSiteSpacing);
  for (std::size_t left = cells.size(); left > 0; --left) {
    const std::size_t drawn = random_.index(left);
    const grid::Cell cell = std::exchange(cells[drawn], cells[left - 1]);
    const Eigen::Vector2d place((cell.x + 0.5) * resolution, (cell.y + 0.5) * resolution);
    const Eigen::Vector2d position = map.geometry().cellCentre(cell);
    bool is_apart = true;
    index.visitNear(place, kSiteSpacing, [&](std::size_t other) {
      is_apart = is_apart && (sites_[other].position - position).norm() >= kSiteSpacing;
    });
    if (is_apart) {
      index.insert(sites_.size(), place);
      sites_.push_back({position, firstImpression()});
    }
  }
}

PersonDetector::Impression PersonDetector::firstImpression() {
  Impression impression;
  for (double* number : {&impression.bias, &impression.score, &impression.x, &impression.y}) {
    *number = random_.gaussian();
  }
  return impression;
}

/// `memory`: how much of a number remains.
void PersonDetector::drift(Impression& impression, double memory) {
  const double news = std::sqrt(1.0 - memory * memory);
  for (double* number : {&impression.score, &impression.x, &impression.y}) {
    *number = memory * *number + news * random_.gaussian();
  }
}

std::optional<DetectedPeople> PersonDetector::detect(const LidarView& view, const std::vector<Person>& people,
                                                     const grid::Rigid2& T_map_lidar, double time) {
  constexpr double kRounding = 1e-6;  // [s] a scan that comes as the detector gets ready is taken
  if (last_time_ && time < *last_time_ + 1.0 / options_.rate - kRounding) {
    return std::nullopt;
  }
  driftAll(people.size(), time);
  const grid::Rigid2 T_lidar_map = T_map_lidar.inverse();
  std::vector<Candidate> candidates = peopleIn(view, people, T_lidar_map);
  const std::size_t people_in_sight = candidates.size();
  const std::vector<Candidate> wrong = falseAlarmsIn(view.scan, T_lidar_map);
  candidates.insert(candidates.end(), wrong.begin(), wrong.end());
  const std::vector<Candidate> kept = bestOf(std::move(candidates));
  adjust(people_in_sight, kept, time);
  last_time_ = time;

  DetectedPeople detected{time, time + options_.latency, {}};
  for (const Candidate& candidate : kept) {
    detected.people.push_back(candidate.detection);
  }
  return detected;
}

void PersonDetector::driftAll(std::size_t num_people, double time) {
  while (impressions_.size() < num_people) {
    impressions_.push_back(firstImpression());
  }
  const double memory = last_time_ ? std::exp(-(time - *last_time_) / options_.correlation_time) : 1.0;
  for (Impression& impression : impressions_) {
    drift(impression, memory);
  }
  for (Site& site : sites_) {
    drift(site.impression, memory);
  }
}

/// Everybody in sight, whatever the score.
std::vector<PersonDetector::Candidate> PersonDetector::peopleIn(const LidarView& view,
                                                                const std::vector<Person>& people,
                                                                const grid::Rigid2& T_lidar_map) const {
  // A score drifts about such a mean that it exceeds the threshold with the probability `recall`.
  const double mean = normalQuantile(options_.recall) + ease_;
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const Eigen::Vector2d position = T_lidar_map * people[i].position;
    if (view.rays_on[2 * i] + view.rays_on[2 * i + 1] >= options_.min_rays && position.norm() <= options_.range) {
      const double evidence = kPersonSpread * (mean + impressions_[i].score);
      candidates.push_back({detection(position, impressions_[i], evidence), true});
    }
  }
  return candidates;
}

std::vector<PersonDetector::Candidate> PersonDetector::falseAlarmsIn(const scan::PlanarScan& scan,
                                                                     const grid::Rigid2& T_lidar_map) const {
  std::vector<std::pair<Eigen::Vector2d, const Impression*>> in_sight;
  for (const Site& site : sites_) {
    const Eigen::Vector2d position = T_lidar_map * site.position;
    if (position.norm() <= options_.range && isOnSurface(scan, position)) {
      in_sight.emplace_back(position, &site.impression);
    }
  }
  const double share = false_alarms_ / std::max(1.0, static_cast<double>(in_sight.size()));
  const double mean = normalQuantile(std::min(kMostFalseAlarms, share));
  std::vector<Candidate> candidates;
  for (const auto& [position, impression] : in_sight) {
    const double drifted = std::sqrt(kSiteBias) * impression->bias + std::sqrt(1.0 - kSiteBias) * impression->score;
    candidates.push_back({detection(position, *impression, kFalseAlarmSpread * (mean + drifted)), false});
  }
  return candidates;
}

/// `evidence` is 0 at the threshold.
DetectedPerson PersonDetector::detection(const Eigen::Vector2d& position, const Impression& impression,
                                         double evidence) const {
  const Eigen::Vector2d error(impression.x, impression.y);
  return {position + options_.position_sigma * error, logistic(logit(options_.score_threshold) + evidence)};
}

/// In descending order of their scores, without those near a higher one and without the lowest.
std::vector<PersonDetector::Candidate> PersonDetector::bestOf(std::vector<Candidate> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.detection.score > b.detection.score; });
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    const bool is_apart = std::all_of(kept.begin(), kept.end(), [&](const Candidate& other) {
      return (other.detection.position - candidate.detection.position).norm() >= kApart;
    });
    if (is_apart && candidate.detection.score >= kLowestScore) {
      kept.push_back(candidate);
    }
  }
  return kept;
}

/// Makes up for what the last scan lacked of the recall and precision asked for.
void PersonDetector::adjust(std::size_t people_in_sight, const std::vector<Candidate>& kept, double time) {
  double num_true = 0.0;
  double num_false = 0.0;
  for (const Candidate& candidate : kept) {
    if (candidate.detection.score >= options_.score_threshold) {
      (candidate.is_person ? num_true : num_false) += 1.0;
    }
  }
  const double wanted_true = options_.recall * static_cast<double>(people_in_sight);
  const double false_per_true = (1.0 - options_.precision) / options_.precision;
  if (!last_time_) {
    false_alarms_ = std::max(options_.false_alarms, false_per_true * wanted_true);
    return;
  }
  const double period = std::min(time - *last_time_, 1.0);
  ease_ = std::clamp(ease_ + kEaseRate * period * (wanted_true - num_true), -kMostEase, kMostEase);
  const double lacking = std::max(options_.false_alarms, false_per_true * num_true) - num_false;
  false_alarms_ = std::max(0.5 * options_.false_alarms, false_alarms_ + kFalseAlarmRate * period * lacking);
}

}  // namespace map_matcher::simulation
