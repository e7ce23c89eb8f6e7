// Removes people from the scans of a bag without a roscore.

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <string>

#include "command_line.hpp"
#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/bag_scrubbing.hpp"

namespace {

using map_matcher::BagScrubbingRequest;
using map_matcher::BagScrubbingResult;

struct Arguments {
  BagScrubbingRequest request;
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

void printSummary(const BagScrubbingRequest& request, const BagScrubbingResult& result) {
  std::cout << result.scan_topic << ": " << result.scans << " scans, " << result.scans_changed << " changed, "
            << result.scans_too_much << " left as they were since too much would have gone, " << result.scans_dropped
            << " dropped, " << result.scans_timed_out << " waited in vain\n"
            << "detections used        " << result.detections << '\n'
            << "placed                 ";
  for (const map_matcher::PosePath path : {map_matcher::PosePath::kFixedFrame, map_matcher::PosePath::kNewest,
                                           map_matcher::PosePath::kSensorFrame, map_matcher::PosePath::kNone}) {
    std::cout << (path == map_matcher::PosePath::kFixedFrame ? "" : ", ")
              << result.paths[static_cast<std::size_t>(path)] << ' ' << toString(path);
  }
  std::cout << "\npoints removed         " << share(result.removed, result.points) << '\n';
  if (!request.people_topic.empty()) {
    const map_matcher::PeopleCount& people = result.people;
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
  map_matcher::LidarScrubberServerOptions& options = arguments.request.options;
  if (!arguments.config.empty()) {
    loadYamlParameters(arguments.config, parametersOf(options));
  }
  if (!arguments.detections.empty()) {
    options.detection_topics = arguments.detections;
  }
  if (!arguments.mode.empty()) {
    options.mode = arguments.mode;
  }
  map_matcher::throwIfAny(problemsOf(parametersOf(options)));
  printSummary(arguments.request, scrubBag(arguments.request));
}

void describe(CLI::App& app, Arguments& arguments) {
  BagScrubbingRequest& request = arguments.request;
  app.add_option("--bag", request.bag, "bag with scans, detections and perhaps tf")->required();
  app.add_option("--scan", request.scan_topic, "topic of the scans; default: the only one in the bag");
  app.add_option("--detections", arguments.detections, "topics of the detections; default: those of the configuration");
  app.add_option("--people", request.people_topic,
                 "topic of the people who were really there, PoseArray with the scans' stamps: says what was missed");
  app.add_option("--output", request.output, "bag to write: everything, and the scrubbed scans");
  app.add_option("--scrubbed", request.scrubbed_topic, "topic of the scrubbed scans in it")->capture_default_str();
  app.add_option("--mode", arguments.mode, "cached or synchronised; default: that of the configuration");
  app.add_option("--config", arguments.config, "parameters, as in config/lidar_scrubber.yaml");
  app.footer("Exit status: 0 scrubbed, 2 bad input.");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Removes people from the scans of a bag.", "scrub_bag");
  Arguments arguments;
  describe(app, arguments);
  return map_matcher::tools::run(app, argc, argv, [&arguments] {
    scrub(arguments);
    return map_matcher::tools::kDone;
  });
}
