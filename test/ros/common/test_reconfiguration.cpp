#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/ros/common/reconfiguration.hpp"

namespace map_matcher::ros_common {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Options {
  bool flag = false;
  int number = 3;
  double share = 0.5;
  std::string choice = "a";
  std::vector<std::string> topics{"scan"};
};

parameters::ParameterList parametersOf(Options& options) {
  return {{"flag", "", "A flag.", &options.flag},
          {"number", "", "A number.", &options.number, 0, 10},
          {"share", "", "A share.", &options.share, 0.0, 1.0},
          {"choice", "", "A choice.", &options.choice, {}, {}, {"a", "b"}},
          {"topics", "", "Topics.", &options.topics}};
}

TEST(Reconfiguration, TakesBackWhatItSends) {
  Options sent;
  sent.flag = true;
  sent.number = 7;
  sent.share = 0.1;
  sent.choice = "b";
  Options taken;

  const std::vector<std::string> changes = takeFrom(configOf(parametersOf(sent)), parametersOf(taken));

  EXPECT_TRUE(taken.flag);
  EXPECT_EQ(taken.number, 7);
  EXPECT_EQ(taken.share, 0.1);
  EXPECT_EQ(taken.choice, "b");
  EXPECT_THAT(changes, ElementsAre("flag is true now, and was false", "number is 7 now, and was 3",
                                   "share is 0.1 now, and was 0.5", "choice is \"b\" now, and was \"a\""));
}

TEST(Reconfiguration, LeavesWhatIsNotNamed) {
  Options options;
  dynamic_reconfigure::Config config;
  config.doubles.emplace_back();
  config.doubles.back().name = "share";
  config.doubles.back().value = 0.5;

  EXPECT_THAT(takeFrom(config, parametersOf(options)), IsEmpty());
  EXPECT_EQ(options.number, 3);
}

TEST(Reconfiguration, RefusesEverythingThatIsOutOfItsRangeAtOnce) {
  Options wrong;
  wrong.share = std::numeric_limits<double>::quiet_NaN();
  wrong.choice = "c";
  Options options;

  try {
    takeFrom(configOf(parametersOf(wrong)), parametersOf(options));
    FAIL() << "taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "share is nan, expected 0 to 1; choice is \"c\", expected a | b");
  }
}

}  // namespace
}  // namespace map_matcher::ros_common
