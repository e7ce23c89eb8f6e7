#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "map_matcher/simulation/person_detector.hpp"
#include "support/ascii_map.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::simulation {
namespace {

using test::thrownText;

constexpr double kMatched = 0.5;  // [m] from a person a detection is of that person

/// Somebody who stands at (x, y) and looks along x.
Person personAt(double x, double y) {
  return {{x, y}, 0.0, {Circle{{x, y + 0.1}, 0.065}, Circle{{x, y - 0.1}, 0.065}}};
}

/// A wide hall, a lidar without noise in its middle, and a detector that makes no false alarms.
struct Hall {
  Hall() {
    lidar_options.sigma = 0.0;
    lidar_options.T_base_lidar = {};
    options.precision = 1.0;
    options.false_alarms = 0.0;
  }

  LidarView look(const std::vector<Person>& people) const {
    return Lidar(lidar_options, RandomNumbers(1)).scanAmong(legsOf(people), World(map), T_map_lidar);
  }

  PersonDetector detector() const { return PersonDetector(map, options, RandomNumbers(7)); }

  grid::OccupancyGrid map = test::asciiMap(std::vector<std::string>(30, std::string(30, '.')));
  grid::Rigid2 T_map_lidar{15.0, 15.0, M_PI / 2.0};
  LidarOptions lidar_options;
  PersonDetectorOptions options;
};

int numCounted(const DetectedPeople& detections, double threshold) {
  return static_cast<int>(std::count_if(detections.people.begin(), detections.people.end(),
                                        [&](const auto& detection) { return detection.score >= threshold; }));
}

TEST(PersonDetector, tellsPositionsInTheLidarsFrame) {
  const Hall hall;
  PersonDetector detector = hall.detector();
  const std::vector<Person> people{personAt(12.0, 17.0)};
  const LidarView view = hall.look(people);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double variance = 0.0;
  int count = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto found = detector.detect(view, people, hall.T_map_lidar, i);
    ASSERT_TRUE(found);
    for (const DetectedPerson& detection : found->people) {
      const Eigen::Vector2d error = detection.position - Eigen::Vector2d(2.0, 3.0);
      mean += error;
      variance += 0.5 * error.squaredNorm();
      ++count;
    }
  }
  ASSERT_GT(count, 3000);
  EXPECT_LT((mean / count).norm(), 0.01);
  EXPECT_NEAR(std::sqrt(variance / count), hall.options.position_sigma, 0.01);
}

TEST(PersonDetector, missesPeopleForSeveralScansInARow) {
  const Hall hall;
  PersonDetector detector = hall.detector();
  const std::vector<Person> people{personAt(15.0, 18.0)};
  const LidarView view = hall.look(people);
  constexpr int kScans = 60000;
  int num_found = 0;
  int num_runs = 0;
  bool missed = false;
  for (int i = 0; i < kScans; ++i) {
    const bool found = numCounted(*detector.detect(view, people, hall.T_map_lidar, i / 15.0), 0.4) > 0;
    num_found += found ? 1 : 0;
    num_runs += !found && !missed ? 1 : 0;
    missed = !found;
  }
  EXPECT_NEAR(static_cast<double>(num_found) / kScans, hall.options.recall, 0.03);
  const double mean_run = static_cast<double>(kScans - num_found) / num_runs;
  EXPECT_GT(mean_run, 3.0);
  EXPECT_LT(mean_run, 15.0);
}

TEST(PersonDetector, detectsOnlyPeopleInSight) {
  Hall hall;
  hall.options.recall = 0.99;
  const auto countOf = [&](const std::vector<Person>& people) {
    PersonDetector detector = hall.detector();
    const LidarView view = hall.look(people);
    int count = 0;
    for (int i = 0; i < 100; ++i) {
      count += static_cast<int>(detector.detect(view, people, hall.T_map_lidar, i)->people.size());
    }
    return count;
  };
  EXPECT_GT(countOf({personAt(15.0, 18.0)}), 90);
  EXPECT_EQ(countOf({personAt(15.0, 12.0)}), 0);  // behind
  EXPECT_EQ(countOf({personAt(15.0, 29.0)}), 0);  // too far away
  // One who stands before the other's legs: only one is detected.
  const Person near{{15.0, 17.0}, 0.0, {Circle{{14.9, 17.0}, 0.07}, Circle{{15.1, 17.0}, 0.07}}};
  const Person hidden{{15.0, 19.0}, 0.0, {Circle{{14.8, 19.0}, 0.05}, Circle{{15.2, 19.0}, 0.05}}};
  EXPECT_LE(countOf({near, hidden}), 100);
  EXPECT_GT(countOf({near, personAt(17.0, 19.0)}), 180);
}

TEST(PersonDetector, keepsDetectionsApart) {
  Hall hall;
  hall.options.recall = 0.99;
  hall.options.false_alarms = 5.0;
  PersonDetector detector = hall.detector();
  std::vector<Person> people;
  for (int i = 0; i < 20; ++i) {
    people.push_back(personAt(13.0 + 0.25 * i, 18.0));
  }
  const LidarView view = hall.look(people);
  for (int i = 0; i < 100; ++i) {
    const auto found = detector.detect(view, people, hall.T_map_lidar, i);
    for (std::size_t a = 0; a < found->people.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GE((found->people[a].position - found->people[b].position).norm(), 0.5);
        EXPECT_LE(found->people[a].score, found->people[b].score);
      }
    }
  }
}

TEST(PersonDetector, isLateAndPassesScansOverWhenItIsSlow) {
  Hall hall;
  hall.options.rate = 5.0;
  hall.options.latency = 0.2;
  PersonDetector detector = hall.detector();
  const LidarView view = hall.look({});
  std::vector<double> times;
  for (int i = 0; i < 30; ++i) {
    if (const auto found = detector.detect(view, {}, hall.T_map_lidar, i / 15.0)) {
      EXPECT_DOUBLE_EQ(found->arrival, found->time + 0.2);
      EXPECT_TRUE(found->people.empty());
      times.push_back(found->time);
    }
  }
  ASSERT_EQ(times.size(), 10U);
  EXPECT_DOUBLE_EQ(times[1], 0.2);
}

/// Precision and recall over a drive, and of what scores.
struct Quality {
  double recall = 0.0;
  double precision = 0.0;
  double mean_true_score = 0.0;
  double mean_false_score = 0.0;
  double mean_false_persistence = 0.0;  // share of the false alarms that were there in the last scan
};

Quality qualityOf(const DriveOptions& options) {
  const grid::OccupancyGrid map = officeBuilding({});
  const World world(map);
  DriveSimulation simulation(map, options);
  double num_in_sight = 0.0;
  double num_found = 0.0;
  double num_true = 0.0;
  double num_false = 0.0;
  double num_again = 0.0;
  Quality quality;
  std::vector<Eigen::Vector2d> last_false;
  while (const auto step = simulation.next()) {
    const grid::Rigid2 T_map_lidar = step->T_map_base * simulation.lidarPoses().front();
    const grid::Rigid2 T_lidar_map = T_map_lidar.inverse();
    LidarOptions exact = options.lidar;
    exact.sigma = 0.0;
    const LidarView view = Lidar(exact, RandomNumbers(1)).scanAmong(legsOf(step->people), world, step->T_map_base);
    std::vector<Eigen::Vector2d> in_sight;
    for (std::size_t i = 0; i < step->people.size(); ++i) {
      const Eigen::Vector2d position = T_lidar_map * step->people[i].position;
      if (view.rays_on[2 * i] + view.rays_on[2 * i + 1] >= 2 && position.norm() <= options.detector.range) {
        in_sight.push_back(position);
      }
    }
    // A detection is of the nearest person who is not taken yet.
    std::vector<bool> taken(in_sight.size(), false);
    std::vector<Eigen::Vector2d> now_false;
    for (const DetectedPerson& detection : step->detections.front()->people) {
      if (detection.score < options.detector.score_threshold) {
        continue;
      }
      std::size_t nearest = in_sight.size();
      double distance = kMatched;
      for (std::size_t i = 0; i < in_sight.size(); ++i) {
        if (!taken[i] && (in_sight[i] - detection.position).norm() < distance) {
          nearest = i;
          distance = (in_sight[i] - detection.position).norm();
        }
      }
      if (nearest < in_sight.size()) {
        taken[nearest] = true;
        num_true += 1.0;
        quality.mean_true_score += detection.score;
      } else {
        num_false += 1.0;
        quality.mean_false_score += detection.score;
        const Eigen::Vector2d p_map = T_map_lidar * detection.position;
        now_false.push_back(p_map);
        num_again += std::any_of(last_false.begin(), last_false.end(),
                                 [&](const Eigen::Vector2d& p) { return (p - p_map).norm() < 0.2; });
      }
    }
    last_false = now_false;
    num_in_sight += static_cast<double>(in_sight.size());
    num_found += static_cast<double>(std::count(taken.begin(), taken.end(), true));
  }
  quality.recall = num_found / num_in_sight;
  quality.precision = num_true / (num_true + num_false);
  quality.mean_true_score /= num_true;
  quality.mean_false_score /= num_false;
  quality.mean_false_persistence = num_again / num_false;
  return quality;
}

class DetectorQuality : public testing::TestWithParam<double> {
 protected:
  DriveOptions options() const {
    DriveOptions options;
    options.seed = 1;
    options.duration = 120.0;
    options.pedestrians.density = GetParam();
    return options;
  }
};

TEST_P(DetectorQuality, isThatOfThePublishedFiguresByDefault) {
  const Quality quality = qualityOf(options());
  std::cout << "recall " << quality.recall << ", precision " << quality.precision << ", scores "
            << quality.mean_true_score << " and " << quality.mean_false_score << '\n';
  EXPECT_NEAR(quality.recall, 0.70, 0.04);
  EXPECT_NEAR(quality.precision, 0.75, 0.05);
  EXPECT_GT(quality.mean_true_score, quality.mean_false_score + 0.1);
  EXPECT_GT(quality.mean_false_persistence, 0.6);
}

TEST_P(DetectorQuality, isThatAskedFor) {
  DriveOptions asked = options();
  asked.detector.recall = 0.8;
  asked.detector.precision = 0.6;
  const Quality quality = qualityOf(asked);
  EXPECT_NEAR(quality.recall, 0.8, 0.04);
  EXPECT_NEAR(quality.precision, 0.6, 0.06);
}

INSTANTIATE_TEST_SUITE_P(Densities, DetectorQuality, testing::Values(0.05, 0.2));

/// Some stand so close that their detections are one: as many as can be told apart are found, not as many as asked for.
TEST(PersonDetector, missesMoreWherePeopleStandClose) {
  DriveOptions options;
  options.duration = 60.0;
  options.pedestrians.density = 0.8;
  const Quality quality = qualityOf(options);
  EXPECT_GT(quality.recall, 0.5);
  EXPECT_LT(quality.recall, 0.72);
  EXPECT_GT(quality.precision, 0.7);
}

TEST(PersonDetector, namesEveryOptionOutOfItsRange) {
  Hall hall;
  hall.options.recall = 1.5;
  hall.options.rate = 0.0;
  const std::string text = thrownText<std::invalid_argument>([&] { hall.detector(); });
  for (const char* problem : {"detector_recall is 1.5, expected 0.01 to 0.99", "detector_rate is 0"}) {
    EXPECT_NE(text.find(problem), std::string::npos) << problem << " is not in: " << text;
  }
}

}  // namespace
}  // namespace map_matcher::simulation
