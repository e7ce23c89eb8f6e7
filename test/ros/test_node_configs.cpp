#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <variant>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/pose_evaluator_server.hpp"
#include "map_matcher/ros/session_mapper_server_options.hpp"

namespace map_matcher {
namespace {

/// A parameter file and the options that it describes.
template <typename Options>
struct ConfigFile {
  std::string path;
};

const ConfigFile<SessionMapperServerOptions> kSessionMapper{MAP_MATCHER_SOURCE_DIR "/config/session_mapper.yaml"};
const ConfigFile<PoseEvaluatorOptions> kPoseEvaluator{MAP_MATCHER_SOURCE_DIR "/config/pose_evaluator.yaml"};

template <typename Options>
void expectEveryParameterAndNoOther(const ConfigFile<Options>& file) {
  Options options;
  const YAML::Node keys = YAML::LoadFile(file.path);
  for (const Parameter& parameter : parametersOf(options)) {
    EXPECT_TRUE(keys[parameter.name].IsDefined()) << parameter.name;
  }
  EXPECT_EQ(keys.size(), parametersOf(options).size());
  EXPECT_TRUE(readYamlParameters(file.path, parametersOf(options)).unknown.empty());
}

template <typename Options>
std::string textOf(Options& options) {
  std::string text;
  for (const Parameter& parameter : parametersOf(options)) {
    text += parameter.name + ": " + valueText(parameter) + "\n";
  }
  return text;
}

/// Changes every number and text, so that a key that is not read shows.
template <typename Options>
void spoil(Options& options) {
  for (Parameter& parameter : parametersOf(options)) {
    if (auto* const* number = std::get_if<double*>(&parameter.value)) {
      **number += 1.0;
    } else if (auto* const* count = std::get_if<int*>(&parameter.value)) {
      **count += 1;
    } else if (auto* const* text = std::get_if<std::string*>(&parameter.value)) {
      **text += "_";
    }
  }
}

template <typename Options>
void expectDefaults(const ConfigFile<Options>& file) {
  Options defaults;
  Options read;
  spoil(read);

  EXPECT_TRUE(readYamlParameters(file.path, parametersOf(read)).problems.empty());

  EXPECT_EQ(textOf(read), textOf(defaults));
}

TEST(SessionMapperConfig, NamesEveryParameterAndNoOther) { expectEveryParameterAndNoOther(kSessionMapper); }

TEST(SessionMapperConfig, HoldsTheDefaults) { expectDefaults(kSessionMapper); }

TEST(PoseEvaluatorConfig, NamesEveryParameterAndNoOther) { expectEveryParameterAndNoOther(kPoseEvaluator); }

TEST(PoseEvaluatorConfig, HoldsTheDefaults) { expectDefaults(kPoseEvaluator); }

}  // namespace
}  // namespace map_matcher
