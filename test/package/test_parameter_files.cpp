#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <variant>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/evaluation/pose_evaluator_server.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/merging/scan_merger_server_options.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/simulation/crowd_simulator_server_options.hpp"
#include "support/source_dir.hpp"

namespace map_matcher {
namespace {

/// What a parameter file says about a parameter.
struct Entry {
  std::string comment;  // the lines above it, joined by spaces
  std::string value;
};

std::map<std::string, Entry> readEntries(const std::string& path) {
  std::map<std::string, Entry> entries;
  std::ifstream file(path);
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

struct CrowdSimulatorFile {
  using Options = ros_simulation::CrowdSimulatorServerOptions;
  static constexpr const char* kPath = "config/crowd_simulator.yaml";
};

struct LidarScrubberFile {
  using Options = ros_scrubbing::LidarScrubberServerOptions;
  static constexpr const char* kPath = "config/lidar_scrubber.yaml";
};

struct MapMatcherFile {
  using Options = ros_matching::MapMatcherServerOptions;
  static constexpr const char* kPath = "config/map_matcher.yaml";
};

struct PoseEvaluatorFile {
  using Options = ros_evaluation::PoseEvaluatorOptions;
  static constexpr const char* kPath = "config/pose_evaluator.yaml";
};

struct ScanMergerFile {
  using Options = ros_merging::ScanMergerServerOptions;
  static constexpr const char* kPath = "config/scan_merger.yaml";
};

struct SessionMapperFile {
  using Options = ros_mapping::SessionMapperServerOptions;
  static constexpr const char* kPath = "config/session_mapper.yaml";
};

/// The file of a node's parameters, and the options that it is to describe.
template <typename File>
class ParameterFile : public testing::Test {
 protected:
  typename File::Options options;
  parameters::ParameterList parameters = parametersOf(options);
  std::map<std::string, Entry> entries = readEntries(test::sourceFile(File::kPath));
};

using Files = testing::Types<CrowdSimulatorFile, LidarScrubberFile, MapMatcherFile, PoseEvaluatorFile, ScanMergerFile,
                             SessionMapperFile>;
TYPED_TEST_SUITE(ParameterFile, Files, );

TYPED_TEST(ParameterFile, NamesEveryParameterAndNoOther) {
  EXPECT_EQ(this->entries.size(), this->parameters.size());
  for (const parameters::Parameter& parameter : this->parameters) {
    EXPECT_EQ(this->entries.count(parameter.name), 1U) << parameter.name;
  }
}

TYPED_TEST(ParameterFile, DescribesEveryParameterWithItsUnitAndRange) {
  for (const parameters::Parameter& parameter : this->parameters) {
    const std::string unit = parameter.unit.empty() ? "" : "[" + parameter.unit + "] ";
    ASSERT_EQ(this->entries.count(parameter.name), 1U) << parameter.name;
    EXPECT_EQ(this->entries.at(parameter.name).comment,
              parameter.description + " " + unit + parameters::rangeText(parameter));
  }
}

TYPED_TEST(ParameterFile, HoldsTheDefaults) {
  typename TypeParam::Options read;
  const parameters::ParameterList actual = parametersOf(read);
  for (const parameters::Parameter& parameter : actual) {  // so that what the file does not set is seen to differ
    std::visit([](auto* field) { *field = {}; }, parameter.value);
  }

  parameters::loadYamlParameters(test::sourceFile(TypeParam::kPath), actual);

  for (std::size_t n = 0; n < actual.size(); ++n) {
    EXPECT_EQ(parameters::valueText(actual[n]), parameters::valueText(this->parameters[n])) << actual[n].name;
  }
}

TYPED_TEST(ParameterFile, WritesNumbersSoThatRosReadsThemAsTheirType) {
  for (const parameters::Parameter& parameter : this->parameters) {
    ASSERT_EQ(this->entries.count(parameter.name), 1U) << parameter.name;
    if (std::holds_alternative<int*>(parameter.value)) {
      EXPECT_EQ(this->entries.at(parameter.name).value.find_first_not_of("-0123456789"), std::string::npos)
          << parameter.name;
    }
  }
}

TYPED_TEST(ParameterFile, HoldsDefaultsThatAreInRange) {
  for (const parameters::Parameter& parameter : this->parameters) {
    EXPECT_EQ(parameters::problemWith(parameter), "");
  }
}

}  // namespace
}  // namespace map_matcher
