#include <dynamic_reconfigure/ConfigDescription.h>
#include <gtest/gtest.h>
#include <map_matcher/LidarScrubberConfig.h>
#include <map_matcher/MapMatcherConfig.h>

#include <algorithm>
#include <string>
#include <variant>

#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"

namespace map_matcher {
namespace {

/// The value of a parameter in one of a message's lists.
template <typename Entries>
auto valueOf(const Entries& entries, const std::string& name) {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
  EXPECT_NE(entry, entries.end()) << name;
  return entry == entries.end() ? decltype(entry->value){} : entry->value;
}

template <typename Entries>
void expectNumber(const Entries& smallest, const Entries& largest, const Entries& defaults, double value,
                  const parameters::Parameter& parameter) {
  EXPECT_EQ(valueOf(smallest, parameter.name), parameter.min) << parameter.name;
  EXPECT_EQ(valueOf(largest, parameter.name), parameter.max) << parameter.name;
  EXPECT_EQ(valueOf(defaults, parameter.name), value) << parameter.name;
}

void expectDescription(const dynamic_reconfigure::ConfigDescription& description,
                       const dynamic_reconfigure::ParamDescription& described, const parameters::Parameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " [" + parameter.unit + "]";
  EXPECT_EQ(described.description, parameter.description + unit);
  if (const auto* const* flag = std::get_if<bool*>(&parameter.value)) {
    EXPECT_EQ(described.type, "bool");
    EXPECT_EQ(valueOf(description.dflt.bools, parameter.name) != 0, **flag) << parameter.name;
  } else if (const auto* const* whole = std::get_if<int*>(&parameter.value)) {
    EXPECT_EQ(described.type, "int");
    expectNumber(description.min.ints, description.max.ints, description.dflt.ints, **whole, parameter);
  } else if (const auto* const* number = std::get_if<double*>(&parameter.value)) {
    EXPECT_EQ(described.type, "double");
    expectNumber(description.min.doubles, description.max.doubles, description.dflt.doubles, **number, parameter);
  } else {
    EXPECT_EQ(described.type, "str");
    EXPECT_EQ(valueOf(description.dflt.strs, parameter.name), **std::get_if<std::string*>(&parameter.value));
    for (const std::string& choice : parameter.choices) {
      EXPECT_NE(described.edit_method.find("'value': '" + choice + "'"), std::string::npos) << choice;
    }
  }
}

template <typename Config, typename Options>
void expectDescriptions() {
  Options options;
  const parameters::ParameterList parameters = parametersOf(options);
  const dynamic_reconfigure::ConfigDescription& description = Config::__getDescriptionMessage__();
  ASSERT_EQ(description.groups.size(), 1U);
  EXPECT_GE(description.groups[0].parameters.size(), 10U);
  for (const dynamic_reconfigure::ParamDescription& described : description.groups[0].parameters) {
    const auto parameter = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const auto& candidate) { return candidate.name == described.name; });
    ASSERT_NE(parameter, parameters.end()) << "there is no " << described.name;
    expectDescription(description, described, *parameter);
  }
}

TEST(Reconfigurable, IsDescribedAsTheNodesDescribeIt) {
  expectDescriptions<MapMatcherConfig, ros_matching::MapMatcherServerOptions>();
  expectDescriptions<LidarScrubberConfig, ros_scrubbing::LidarScrubberServerOptions>();
}

}  // namespace
}  // namespace map_matcher
