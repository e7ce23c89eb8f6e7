#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/map_matcher_server_options.hpp"

namespace map_matcher {
namespace {

const std::string kConfig = MAP_MATCHER_SOURCE_DIR "/config/map_matcher.yaml";

/// What a parameter file says about a parameter.
struct Entry {
  std::string comment;  // the lines above it, joined by spaces
  std::string value;
};

std::map<std::string, Entry> readEntries() {
  std::map<std::string, Entry> entries;
  std::ifstream file(kConfig);
  std::string comment;
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.empty()) {
      comment.clear();
    } else if (line.rfind("# ", 0) == 0) {
      comment += (comment.empty() ? "" : " ") + line.substr(2);
    } else if (colon != std::string::npos) {
      entries[line.substr(0, colon)] = {comment, line.substr(colon + 2)};
      comment.clear();
    }
  }
  return entries;
}

TEST(MapMatcherConfig, NamesEveryParameterAndNoOther) {
  MapMatcherServerOptions options;
  const ParameterList parameters = parametersOf(options);
  const auto entries = readEntries();

  EXPECT_EQ(entries.size(), parameters.size());
  for (const Parameter& parameter : parameters) {
    EXPECT_EQ(entries.count(parameter.name), 1U) << parameter.name;
  }
}

TEST(MapMatcherConfig, DescribesEveryParameterWithItsUnitAndRange) {
  MapMatcherServerOptions options;
  const auto entries = readEntries();

  for (const Parameter& parameter : parametersOf(options)) {
    const std::string unit = parameter.unit.empty() ? "" : "[" + parameter.unit + "] ";
    ASSERT_EQ(entries.count(parameter.name), 1U) << parameter.name;
    EXPECT_EQ(entries.at(parameter.name).comment, parameter.description + " " + unit + rangeText(parameter));
  }
}

TEST(MapMatcherConfig, HoldsTheDefaults) {
  MapMatcherServerOptions defaults;
  MapMatcherServerOptions read;
  for (const Parameter& parameter : parametersOf(read)) {  // so that what the file does not set is seen to differ
    std::visit([](auto* field) { *field = {}; }, parameter.value);
  }
  const ParameterList expected = parametersOf(defaults);
  const ParameterList actual = parametersOf(read);

  const YamlParametersReport report = readYamlParameters(kConfig, actual);

  EXPECT_TRUE(report.problems.empty()) << report.problems.front();
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_EQ(valueText(actual[n]), valueText(expected[n])) << expected[n].name;
  }
}

TEST(MapMatcherConfig, WritesNumbersSoThatRosReadsThemAsTheirType) {
  MapMatcherServerOptions options;
  const auto entries = readEntries();

  for (const Parameter& parameter : parametersOf(options)) {
    ASSERT_EQ(entries.count(parameter.name), 1U) << parameter.name;
    if (std::holds_alternative<int*>(parameter.value)) {
      EXPECT_EQ(entries.at(parameter.name).value.find_first_not_of("-0123456789"), std::string::npos) << parameter.name;
    }
  }
}

TEST(MapMatcherConfig, DefaultsAreInRange) {
  MapMatcherServerOptions options;
  for (const Parameter& parameter : parametersOf(options)) {
    EXPECT_EQ(problemWith(parameter), "");
  }
}

}  // namespace
}  // namespace map_matcher
