#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {
namespace {

TEST(RandomNumbers, areTheSameOnEveryPlatform) {
  RandomNumbers random(42);
  EXPECT_EQ(random.uniform(), 0.72172262895025996);
  EXPECT_EQ(random.uniform(), 0.66033153379436649);
  EXPECT_EQ(random.index(1000), 233U);
  EXPECT_DOUBLE_EQ(random.gaussian(), 0.53700366977245351);
  EXPECT_DOUBLE_EQ(random.gaussian(), -1.9386495933343653);
}

TEST(RandomNumbers, ofOneSeedAndStreamRepeat) {
  RandomNumbers one(7, 3);
  RandomNumbers other(7, 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(one.uniform(), other.uniform());
  }
}

TEST(RandomNumbers, ofNeighbouringSeedsAndStreamsHaveNothingInCommon) {
  for (const auto& [seed, stream] : {std::pair{8, 3}, std::pair{7, 4}}) {
    RandomNumbers one(7, 3);
    RandomNumbers other(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(stream));
    double product = 0.0;
    for (int i = 0; i < 10000; ++i) {
      product += (one.uniform() - 0.5) * (other.uniform() - 0.5);
    }
    EXPECT_NEAR(product / 10000 * 12.0, 0.0, 0.05) << "seed " << seed << " stream " << stream;
  }
}

TEST(RandomNumbers, uniformFillTheirInterval) {
  RandomNumbers random(1);
  double sum = 0.0;
  double smallest = 10.0;
  double largest = -10.0;
  for (int i = 0; i < 100000; ++i) {
    const double number = random.uniform(-2.0, 3.0);
    sum += number;
    smallest = std::min(smallest, number);
    largest = std::max(largest, number);
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.02);
  EXPECT_GE(smallest, -2.0);
  EXPECT_LT(smallest, -1.99);
  EXPECT_LT(largest, 3.0);
  EXPECT_GT(largest, 2.99);
}

TEST(RandomNumbers, choosesEveryIndexEquallyOften) {
  RandomNumbers random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) {
    ++counts.at(random.index(counts.size()));
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 10000, 400);  // four standard deviations
  }
}

TEST(RandomNumbers, refuseToChooseFromNothing) {
  RandomNumbers random(3);
  EXPECT_THROW(random.index(0), std::invalid_argument);
}

TEST(RandomNumbers, gaussianHaveTheMomentsOfTheNormalDistribution) {
  RandomNumbers random(4);
  constexpr int kCount = 200000;
  double mean = 0.0;
  double variance = 0.0;
  double fourth = 0.0;
  int beyond_two_sigma = 0;
  for (int i = 0; i < kCount; ++i) {
    const double number = random.gaussian();
    mean += number / kCount;
    variance += number * number / kCount;
    fourth += std::pow(number, 4) / kCount;
    beyond_two_sigma += std::abs(number) > 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(mean, 0.0, 0.01);
  EXPECT_NEAR(variance, 1.0, 0.015);
  EXPECT_NEAR(fourth, 3.0, 0.1);
  EXPECT_NEAR(beyond_two_sigma / static_cast<double>(kCount), 0.0455, 0.002);
}

}  // namespace
}  // namespace map_matcher::simulation
