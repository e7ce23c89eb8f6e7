#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::parameters {
namespace {

TEST(NumberText, IsWhatPeopleWrite) {
  EXPECT_EQ(numberText(0.0), "0");
  EXPECT_EQ(numberText(0.05), "0.05");
  EXPECT_EQ(numberText(-12.5), "-12.5");
  EXPECT_EQ(numberText(100.0), "100");
  EXPECT_EQ(numberText(1000000.0), "1000000");
  EXPECT_EQ(numberText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(numberText(1e-9), "1e-09");
  EXPECT_EQ(numberText(1e300), "1e+300");
}

TEST(NumberText, NamesWhatIsNoNumber) {
  EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, ReadsBackAsTheSameNumber) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  for (int trial = 0; trial < 2000; ++trial) {
    const double value = std::ldexp(mantissa(random), exponent(random));

    EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value) << "trial " << trial;
  }
}

}  // namespace
}  // namespace map_matcher::parameters
