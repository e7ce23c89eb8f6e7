// Draws the session map of a bag without a roscore.

#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"
#include "map_matcher/ros/trials/bag_mapping.hpp"

namespace {

namespace evaluation = map_matcher::evaluation;
namespace files = map_matcher::files;
namespace grid = map_matcher::grid;
namespace parameters = map_matcher::parameters;
namespace ros_mapping = map_matcher::ros_mapping;
namespace ros_trials = map_matcher::ros_trials;

struct Arguments {
  ros_trials::BagMappingRequest request;
  std::string output = "session.yaml";
  std::string trajectory;
  std::string config;
};

/// Options from the configuration file; throws std::invalid_argument with every problem in it.
ros_mapping::SessionMappingOptions readOptions(const std::string& config) {
  ros_mapping::SessionMapperServerOptions options;
  if (!config.empty()) {
    parameters::loadYamlParameters(config, parametersOf(options));
  }
  return options.mapping;
}

void writeTrajectory(const std::string& path, const std::vector<evaluation::StampedPose>& trajectory) {
  std::ostringstream table;
  table << "time,x,y,yaw\n" << std::setprecision(15);
  for (const auto& [time, pose] : trajectory) {
    table << time << ',' << pose.x << ',' << pose.y << ',' << pose.yaw << '\n';
  }
  files::writeFile(path, table.str());
}

void printSummary(const ros_trials::BagMappingResult& result, const ros_mapping::SessionSnapshot& last,
                  const std::string& output) {
  for (const std::string& topic : result.scan_topics) {
    std::cout << topic << (topic == result.scan_topics.back() ? ": " : ", ");
  }
  std::cout << result.scans << " scans, " << result.scans_drawn << " drawn, " << result.scans_not_fitting
            << " did not fit, " << result.scans_without_tf << " without tf, " << result.scans_refused << " refused\n";
  if (!result.last_problem.empty()) {
    std::cout << "last problem: " << result.last_problem << '\n';
  }
  std::cout << output << ": " << last.map.width() << " x " << last.map.height() << " cells of " << last.map.resolution()
            << " m, " << grid::occupiedCells(last.map).size() << " occupied, as of "
            << (last.stamp - result.begin).toSec() << " s\n";
}

void drawBag(Arguments& arguments) {
  map_matcher::tools::FileRoles()
      .reads("--bag", arguments.request.bag)
      .reads("--config", arguments.config)
      .writesMap("--output", arguments.output)
      .writes("--trajectory", arguments.trajectory)
      .requireDistinct();
  arguments.request.options = readOptions(arguments.config);
  std::optional<ros_mapping::SessionSnapshot> last;
  const ros_trials::BagMappingResult result =
      ros_trials::mapBag(arguments.request, [&last](const ros_mapping::SessionSnapshot& snapshot) { last = snapshot; });
  grid::saveMap(last->map, arguments.output);
  if (!arguments.trajectory.empty()) {
    writeTrajectory(arguments.trajectory, result.path);
  }
  printSummary(result, *last, arguments.output);
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  ros_trials::BagMappingRequest& request = arguments.request;
  command_line.add("--bag", &request.bag, "bag with scans, /tf and perhaps /tf_static").required();
  command_line.add("--scan", &request.scan_topics, "topics of the scans, of a laser each; default: the only one");
  command_line.add("--from", &request.from, "leave out what comes before [s since the bag begins]");
  command_line.add("--until", &request.until, "leave out what comes after [s since the bag begins]");
  command_line.add("--output", &arguments.output, "YAML file of the map; its image goes beside it");
  command_line.add("--trajectory", &arguments.trajectory,
                   "write the poses of the robot in the session frame into this CSV file (s, m, m, rad)");
  command_line.add("--config", &arguments.config, "parameters, as in config/session_mapper.yaml");
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line("map_bag", "Draws the session map of a bag.",
                                               "Exit status: 0 drawn, 2 bad input.");
  Arguments arguments;
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] {
    drawBag(arguments);
    return map_matcher::tools::kDone;
  });
}
