#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/session_mapper_server_options.hpp"

namespace map_matcher {
namespace {

const char* const kConfig = MAP_MATCHER_SOURCE_DIR "/config/session_mapper.yaml";

TEST(SessionMapperConfig, NamesEveryParameterAndNoOther) {
  SessionMapperServerOptions options;
  const YAML::Node file = YAML::LoadFile(kConfig);

  EXPECT_TRUE(readYamlParameters(kConfig, parametersOf(options)).unknown.empty());
  for (const Parameter& parameter : parametersOf(options)) {
    EXPECT_TRUE(file[parameter.name].IsDefined()) << parameter.name;
  }
}

TEST(SessionMapperConfig, HoldsTheDefaults) {
  const auto textsOf = [](SessionMapperServerOptions& options) {
    std::string text;
    for (const Parameter& parameter : parametersOf(options)) {
      text += parameter.name + ": " + valueText(parameter) + "\n";
    }
    return text;
  };
  SessionMapperServerOptions defaults;
  SessionMapperServerOptions read;
  for (Parameter& parameter : parametersOf(read)) {  // so that a key that is not read shows
    if (auto* const* number = std::get_if<double*>(&parameter.value)) {
      **number += 1.0;
    }
  }

  EXPECT_TRUE(readYamlParameters(kConfig, parametersOf(read)).problems.empty());

  EXPECT_EQ(textsOf(read), textsOf(defaults));
}

}  // namespace
}  // namespace map_matcher
