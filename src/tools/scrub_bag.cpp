// Removes people from the scans of a bag without a roscore.

#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/bags/bag_scrubbing.hpp"

namespace {

namespace parameters = map_matcher::parameters;
namespace ros_bags = map_matcher::ros_bags;
namespace ros_scrubbing = map_matcher::ros_scrubbing;
namespace scrubbing = map_matcher::scrubbing;

struct Arguments {
  ros_bags::BagScrubbingRequest request;
  std::vector<std::string> detections;
  std::string mode;
  std::string config;
};

/// "12 of 345 (3.5 %)"
std::string share(std::int64_t part, std::int64_t whole) {
  std::ostringstream text;
  const double percent = whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  text << part << " of " << whole << " (" << std::fixed << std::setprecision(1) << percent << " %)";
  return text.str();
}

void printSummary(const ros_bags::BagScrubbingRequest& request, const ros_bags::BagScrubbingResult& result) {
  std::cout << result.scan_topic << ": " << result.scans << " scans, " << result.scans_changed << " changed, "
            << result.scans_too_much << " left as they were since too much would have gone, " << result.scans_dropped
            << " dropped, " << result.scans_timed_out << " waited in vain\n"
            << "detections used        " << result.detections << '\n'
            << "placed                 ";
  for (const scrubbing::PosePath path : {scrubbing::PosePath::kFixedFrame, scrubbing::PosePath::kNewest,
                                         scrubbing::PosePath::kSensorFrame, scrubbing::PosePath::kNone}) {
    std::cout << (path == scrubbing::PosePath::kFixedFrame ? "" : ", ") << result.paths[static_cast<std::size_t>(path)]
              << ' ' << toString(path);
  }
  std::cout << "\npoints removed         " << share(result.removed, result.points) << '\n';
  if (!request.people_topic.empty()) {
    const ros_bags::PeopleCount& people = result.people;
    std::cout << "scans with people      " << people.scans << ", " << people.people << " people\n"
              << "points near them left  " << share(people.near_left, people.near) << '\n'
              << "other points lost      " << share(people.others_lost, people.others) << '\n';
  }
  if (!result.last_problem.empty()) {
    std::cout << "last problem: " << result.last_problem << '\n';
  }
  if (!request.output.empty()) {
    std::cout << request.output << ": scrubbed scans on " << request.scrubbed_topic << '\n';
  }
}

void scrub(Arguments& arguments) {
  map_matcher::tools::FileRoles()
      .reads("--bag", arguments.request.bag)
      .reads("--config", arguments.config)
      .writes("--output", arguments.request.output)
      .requireDistinct();
  ros_scrubbing::LidarScrubberServerOptions& options = arguments.request.options;
  if (!arguments.config.empty()) {
    parameters::loadYamlParameters(arguments.config, parametersOf(options));
  }
  if (!arguments.detections.empty()) {
    options.detection_topics = arguments.detections;
  }
  if (!arguments.mode.empty()) {
    options.mode = arguments.mode;
  }
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options)));
  printSummary(arguments.request, ros_bags::scrubBag(arguments.request));
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  ros_bags::BagScrubbingRequest& request = arguments.request;
  command_line.add("--bag", &request.bag, "bag with scans, detections and perhaps tf").required();
  command_line.add("--scan", &request.scan_topic, "topic of the scans; default: the only one in the bag");
  command_line.add("--detections", &arguments.detections,
                   "topics of the detections; default: those of the configuration");
  command_line.add("--people", &request.people_topic,
                   "topic of the people who were really there, PoseArray with the scans' stamps: says what was missed");
  command_line.add("--output", &request.output, "bag to write: everything, and the scrubbed scans");
  command_line.add("--scrubbed", &request.scrubbed_topic, "topic of the scrubbed scans in it");
  command_line.add("--mode", &arguments.mode, "cached or synchronised; default: that of the configuration");
  command_line.add("--config", &arguments.config, "parameters, as in config/lidar_scrubber.yaml");
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line("scrub_bag", "Removes people from the scans of a bag.",
                                               "Exit status: 0 scrubbed, 2 bad input.");
  Arguments arguments;
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] {
    scrub(arguments);
    return map_matcher::tools::kDone;
  });
}
