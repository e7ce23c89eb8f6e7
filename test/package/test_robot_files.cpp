#include <gtest/gtest.h>

#include <string>

#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "support/source_dir.hpp"

namespace map_matcher {
namespace {

/// What is wrong with config/<robot>/<name>.yaml as parameters of these options; empty when nothing is.
template <typename Options>
std::string problemWith(const std::string& robot, const std::string& name) {
  Options options;
  try {
    parameters::loadYamlParameters(test::sourceFile("config/" + robot + "/" + name + ".yaml"), parametersOf(options));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

class RobotFiles : public testing::TestWithParam<const char*> {};

TEST_P(RobotFiles, NameParametersThatThereAreWithValuesInTheirRange) {
  EXPECT_EQ(problemWith<ros_matching::MapMatcherServerOptions>(GetParam(), "map_matcher"), "");
  EXPECT_EQ(problemWith<ros_scrubbing::LidarScrubberServerOptions>(GetParam(), "lidar_scrubber"), "");
  EXPECT_EQ(problemWith<ros_mapping::SessionMapperServerOptions>(GetParam(), "session_mapper"), "");
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotFiles, testing::Values("pepper", "pioneer"));

}  // namespace
}  // namespace map_matcher
