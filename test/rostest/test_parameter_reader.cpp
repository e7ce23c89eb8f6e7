#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/node_handle.h>
#include <ros/param.h>

#include <limits>
#include <string>
#include <vector>

#include "map_matcher/ros/common/parameter_reader.hpp"
#include "map_matcher/ros/common/run_node.hpp"

namespace map_matcher {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Options {
  double tf_rate = 20.0;
  int min_session_cells = 100;
  bool enabled = false;
  std::string tf_mode = "none";
  std::vector<std::string> topics{"detections"};
};

parameters::ParameterList parametersOf(Options& options) {
  return {
      {"tf_rate", "Hz", "", &options.tf_rate, 0.1, 1000.0, {}},
      {"min_session_cells", "cells", "", &options.min_session_cells, 1.0, 1e6, {}},
      {"enabled", "", "", &options.enabled, {}, {}, {}},
      {"tf_mode", "", "", &options.tf_mode, {}, {}, {"none", "reference_to_session"}},
      {"topics", "", "", &options.topics, {}, {}, {}},
  };
}

class ParameterReader : public testing::Test {
 protected:
  ~ParameterReader() override { ros::param::del(node.getNamespace()); }

  ros::NodeHandle node{"~options"};
  Options options;
};

TEST_F(ParameterReader, FillsTheFieldsThatAreSetAndKeepsTheOthers) {
  node.setParam("tf_rate", 12.5);
  node.setParam("enabled", true);
  node.setParam("tf_mode", "reference_to_session");

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)), IsEmpty());

  EXPECT_EQ(options.tf_rate, 12.5);
  EXPECT_TRUE(options.enabled);
  EXPECT_EQ(options.tf_mode, "reference_to_session");
  EXPECT_EQ(options.min_session_cells, 100);
}

TEST_F(ParameterReader, ReadsAListOfTexts) {
  node.setParam("topics", std::vector<std::string>{"front", "rear"});

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)), IsEmpty());

  EXPECT_THAT(options.topics, ElementsAre("front", "rear"));
}

TEST_F(ParameterReader, RefusesAListOfAnythingElse) {
  node.setParam("topics", std::vector<int>{1, 2});

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)),
              ElementsAre("~topics is a list, expected a list of texts"));

  node.setParam("topics", "front");
  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)),
              ElementsAre("~topics is \"front\", expected a list of texts"));
  EXPECT_THAT(options.topics, ElementsAre("detections"));
}

TEST_F(ParameterReader, TakesAWholeNumberForADouble) {
  node.setParam("tf_rate", 10);

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)), IsEmpty());

  EXPECT_EQ(options.tf_rate, 10.0);
}

TEST_F(ParameterReader, RefusesADoubleForAWholeNumber) {
  node.setParam("min_session_cells", 50.0);

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)),
              ElementsAre("~min_session_cells is 50.0, expected a whole number: 1 to 1000000 cells"));
  EXPECT_EQ(options.min_session_cells, 100);
}

TEST_F(ParameterReader, TellsEveryWrongTypeAndEveryValueOutOfRangeAtOnce) {
  node.setParam("tf_rate", 0);
  node.setParam("min_session_cells", "many");
  node.setParam("enabled", 1);
  node.setParam("tf_mode", "both");

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)),
              ElementsAre("~tf_rate is 0, expected 0.1 to 1000 Hz",
                          "~min_session_cells is \"many\", expected a whole number: 1 to 1000000 cells",
                          "~enabled is 1, expected true | false",
                          "~tf_mode is \"both\", expected none | reference_to_session"));
  EXPECT_EQ(options.tf_rate, 20.0);
  EXPECT_EQ(options.tf_mode, "none");
}

TEST_F(ParameterReader, RefusesNotANumber) {
  node.setParam("tf_rate", std::numeric_limits<double>::quiet_NaN());

  EXPECT_THAT(ros_common::readParameters(node, parametersOf(options)),
              ElementsAre(HasSubstr("expected 0.1 to 1000 Hz")));
}

TEST_F(ParameterReader, NamesAMisspeltParameterAndTheNearestKnownOne) {
  node.setParam("tf_rat", 10.0);
  node.setParam("tf_mode", "none");

  EXPECT_THAT(ros_common::unknownParameters(node, parametersOf(options)),
              ElementsAre("~tf_rat is 10.0, but there is no such parameter; did you mean ~tf_rate?"));
}

TEST_F(ParameterReader, SuggestsNothingForANameUnlikeAllOthers) {
  node.setParam("xyz/zzz", 10.0);

  EXPECT_THAT(ros_common::unknownParameters(node, parametersOf(options)),
              ElementsAre("~xyz is a group of parameters, but there is no such parameter"));
}

TEST_F(ParameterReader, LoadsParametersInSpiteOfAMisspeltOneButNotOfAWrongOne) {
  node.setParam("tf_rat", 10.0);
  EXPECT_TRUE(ros_common::loadParameters(node, parametersOf(options)));

  node.setParam("tf_rate", -1.0);
  EXPECT_FALSE(ros_common::loadParameters(node, parametersOf(options)));
}

}  // namespace
}  // namespace map_matcher

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "parameter_reader_test");
  return RUN_ALL_TESTS();
}
