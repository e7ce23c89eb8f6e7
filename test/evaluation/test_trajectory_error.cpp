#include <gtest/gtest.h>

#include <cmath>

#include "map_matcher/evaluation/trajectory_error.hpp"

namespace map_matcher::evaluation {
namespace {

TEST(ErrorOf, IsTheDistanceAndTheSmallestAngle) {
  const PoseError error = errorOf({3.0, 4.0, 3.1}, {0.0, 0.0, -3.1});

  EXPECT_DOUBLE_EQ(error.translation, 5.0);
  EXPECT_NEAR(error.rotation, 2.0 * M_PI - 6.2, 1e-12);
}

TEST(StatisticsOf, NothingIsNothing) { EXPECT_FALSE(statisticsOf({})); }

TEST(StatisticsOf, OneErrorIsThatError) {
  const ErrorStatistics statistics = *statisticsOf({2.0});

  EXPECT_DOUBLE_EQ(statistics.mean, 2.0);
  EXPECT_DOUBLE_EQ(statistics.median, 2.0);
  EXPECT_DOUBLE_EQ(statistics.rms, 2.0);
  EXPECT_DOUBLE_EQ(statistics.worst, 2.0);
  EXPECT_DOUBLE_EQ(statistics.standard_deviation, 0.0);
}

TEST(StatisticsOf, AreThoseComputedByHand) {
  const ErrorStatistics statistics = *statisticsOf({4.0, 1.0, 2.0, 9.0});

  EXPECT_DOUBLE_EQ(statistics.mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics.median, 3.0);                         // between 2 and 4
  EXPECT_DOUBLE_EQ(statistics.rms, std::sqrt(25.5));                // (16 + 1 + 4 + 81) / 4
  EXPECT_DOUBLE_EQ(statistics.standard_deviation, std::sqrt(9.5));  // 25.5 - 16
  EXPECT_DOUBLE_EQ(statistics.worst, 9.0);
}

TEST(StatisticsOf, AnOddNumberHaveTheMiddleOneAsMedian) {
  EXPECT_DOUBLE_EQ(statisticsOf({7.0, 1.0, 2.0})->median, 2.0);
}

TEST(EvaluateTrajectory, LeavesSamplesWithoutEstimateOutOfTheErrorsButCountsThem) {
  const std::vector<PoseSample> samples = {
      {10.0, {0.0, 0.0, 0.0}, std::nullopt},
      {11.5, {1.0, 0.0, 0.0}, grid::Rigid2{1.0, 0.3, 0.1}},
      {12.0, {2.0, 0.0, 0.0}, std::nullopt},
      {13.0, {3.0, 0.0, 0.0}, grid::Rigid2{3.1, 0.0, -0.2}},
  };

  const TrajectoryError error = evaluateTrajectory(samples);

  EXPECT_EQ(error.samples, 4);
  EXPECT_EQ(error.estimates, 2);
  EXPECT_DOUBLE_EQ(*error.time_to_first_estimate, 1.5);
  EXPECT_DOUBLE_EQ(*error.worst_time, 11.5);
  EXPECT_NEAR(error.translation->mean, 0.2, 1e-12);
  EXPECT_NEAR(error.translation->worst, 0.3, 1e-12);
  EXPECT_NEAR(error.rotation->mean, 0.15, 1e-12);
  EXPECT_NEAR(error.rotation->worst, 0.2, 1e-12);
}

TEST(EvaluateTrajectory, HasNoFiguresWhenThereIsNoEstimate) {
  const TrajectoryError error = evaluateTrajectory({{10.0, {0.0, 0.0, 0.0}, std::nullopt}});

  EXPECT_EQ(error.samples, 1);
  EXPECT_EQ(error.estimates, 0);
  EXPECT_FALSE(error.time_to_first_estimate);
  EXPECT_FALSE(error.worst_time);
  EXPECT_FALSE(error.translation);
  EXPECT_FALSE(error.rotation);
}

TEST(EvaluateTrajectory, TakesNoSamples) { EXPECT_EQ(evaluateTrajectory({}).samples, 0); }

}  // namespace
}  // namespace map_matcher::evaluation
