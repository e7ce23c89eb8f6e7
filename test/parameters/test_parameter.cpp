#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::parameters {
namespace {

Parameter ratioParameter(double& value) {
  return {"acceptance_ratio", "", "Smallest share of matched cells.", &value, 0.0, 1.0, {}};
}

TEST(Parameter, IsFineWithinItsRangeAndOnItsLimits) {
  for (double value : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(problemWith(ratioParameter(value)), "") << value;
  }
}

TEST(Parameter, NamesItselfItsValueAndItsRangeWhenOutside) {
  double value = 1.5;
  EXPECT_EQ(problemWith(ratioParameter(value)), "acceptance_ratio is 1.5, expected 0 to 1");
  value = -1e-9;
  EXPECT_EQ(problemWith(ratioParameter(value)), "acceptance_ratio is -1e-09, expected 0 to 1");
}

TEST(Parameter, RefusesWhatIsNoNumber) {
  double value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problemWith(ratioParameter(value)), "acceptance_ratio is nan, expected 0 to 1");

  value = std::numeric_limits<double>::infinity();
  const Parameter unbounded{"size", "m", "Any.", &value};
  EXPECT_EQ(problemWith(unbounded), "size is inf, expected any number m");
}

TEST(Parameter, WritesTheUnitAfterTheRange) {
  int cells = 0;
  const Parameter parameter{"min_session_cells", "cells", "Fewer are not matched.", &cells, 1.0};

  EXPECT_EQ(problemWith(parameter), "min_session_cells is 0, expected at least 1 cells");
}

TEST(Parameter, ListsTheChoicesOfAText) {
  std::string mode = "sideways";
  const Parameter parameter{"tf_mode", "", "Direction.", &mode, 0.0, 0.0, {"forward", "none"}};

  EXPECT_EQ(problemWith(parameter), "tf_mode is \"sideways\", expected forward | none");
  mode = "none";
  EXPECT_EQ(problemWith(parameter), "");
}

TEST(Parameter, WritesAListAsYamlDoes) {
  std::vector<std::string> topics{"front", "rear"};
  const Parameter parameter{"detection_topics", "", "Topics.", &topics};

  EXPECT_EQ(valueText(parameter), "[\"front\", \"rear\"]");
  EXPECT_EQ(rangeText(parameter), "a list of texts");
  EXPECT_EQ(problemWith(parameter), "");
  topics.clear();
  EXPECT_EQ(valueText(parameter), "[]");
}

TEST(Parameter, AllowsAnyTextWithoutChoices) {
  std::string file;
  const Parameter parameter{"reference_map_file", "", "Map.", &file};

  EXPECT_EQ(problemWith(parameter), "");
  EXPECT_EQ(rangeText(parameter), "any text");
}

TEST(Parameter, WritesEachTypeAsYamlDoes) {
  bool flag = true;
  int number = -3;
  double real = 0.05;
  std::string text = "map";

  EXPECT_EQ(valueText({"flag", "", "", &flag}), "true");
  EXPECT_EQ(valueText({"number", "", "", &number}), "-3");
  EXPECT_EQ(valueText({"real", "", "", &real}), "0.05");
  EXPECT_EQ(valueText({"text", "", "", &text}), "\"map\"");
}

TEST(Parameter, DescribesEachKindOfRange) {
  bool flag = false;
  double real = 0.0;
  const double infinity = std::numeric_limits<double>::infinity();

  EXPECT_EQ(rangeText({"flag", "", "", &flag}), "true | false");
  EXPECT_EQ(rangeText({"real", "", "", &real}), "any number");
  EXPECT_EQ(rangeText({"real", "", "", &real, 1.0, 1000000.0}), "1 to 1000000");
  EXPECT_EQ(rangeText({"real", "", "", &real, 0.5, infinity}), "at least 0.5");
  EXPECT_EQ(rangeText({"real", "", "", &real, -infinity, 0.5}), "at most 0.5");
}

TEST(Parameter, FollowsItsField) {
  double value = 2.0;
  const Parameter parameter = ratioParameter(value);
  EXPECT_NE(problemWith(parameter), "");

  value = 0.25;

  EXPECT_EQ(problemWith(parameter), "");
  EXPECT_EQ(valueText(parameter), "0.25");
}

}  // namespace
}  // namespace map_matcher::parameters
