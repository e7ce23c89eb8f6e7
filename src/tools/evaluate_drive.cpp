// Takes a drive, simulated or recorded, through mapper and matcher, and writes down what they made of it.

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

#include "command_line.hpp"
#include "drive_arguments.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/evaluation/simulated_trial.hpp"
#include "map_matcher/evaluation/trial_table.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/bag_trial.hpp"
#include "map_matcher/ros/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/map_matcher_server_options.hpp"
#include "map_matcher/ros/session_mapper_server_options.hpp"

namespace {

using map_matcher::OccupancyGrid;
using map_matcher::Trial;
using map_matcher::TrialOptions;
using map_matcher::TrialQuery;

struct Arguments {
  Arguments(int argc, char** argv) : drive(argc, argv) {}

  map_matcher::tools::DriveArguments drive;
  map_matcher::BagTrialRequest recorded;
  std::string reference;
  std::string config;
  std::string mapper_config;
  std::string scrubber_config;
  TrialOptions trial;
  std::string output;
  std::string session;
  bool place_session = false;
  std::string first_overlay;
  std::string last_overlay;
};

TrialOptions readOptions(const Arguments& arguments) {
  TrialOptions options = arguments.trial;
  if (!arguments.config.empty()) {
    map_matcher::MapMatcherServerOptions matcher;
    loadYamlParameters(arguments.config, parametersOf(matcher));
    options.match = matcher.match;
  }
  if (!arguments.mapper_config.empty()) {
    map_matcher::SessionMapperServerOptions mapper;
    loadYamlParameters(arguments.mapper_config, parametersOf(mapper));
    options.mapper = mapper.mapping.mapper;
    options.map_update_interval = mapper.mapping.map_update_interval;
  }
  if (!arguments.scrubber_config.empty()) {
    map_matcher::LidarScrubberServerOptions scrubber;
    loadYamlParameters(arguments.scrubber_config, parametersOf(scrubber));
    options.scrubbing = scrubber.scrubbing;
  }
  return options;
}

void simulate(const OccupancyGrid& map, const Arguments& arguments, Trial& trial) {
  map_matcher::DriveSimulation simulation(map, arguments.drive.options());
  while (const auto step = simulation.next()) {
    trial.add(trialStepOf(*step, simulation.lidarPoses()));
    for (const auto& detections : trialDetectionsOf(*step)) {
      trial.add(detections);
    }
  }
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) {
    throw std::runtime_error("file '" + path + "' cannot be written");
  }
}

void printSummary(const Trial& trial) {
  int matched = 0;
  int right = 0;
  std::optional<TrialQuery> first;
  for (const TrialQuery& query : trial.queries()) {
    const auto error = query.robotError();
    matched += query.result.matched() ? 1 : 0;
    right += error && error->translation < 1.0 ? 1 : 0;
    if (query.result.matched() && !first) {
      first = query;
    }
  }
  std::cout << trial.queries().size() << " session maps, " << matched << " matched, " << right
            << " of them within 1 m of the truth";
  if (first) {
    std::cout << "; first match after " << first->session_age << " s";
  }
  std::cout << '\n';
}

/// The session map in the frame of the truth, where it really lies.
OccupancyGrid placed(const OccupancyGrid& session, const Trial& trial) {
  if (!trial.trueAlignment()) {
    throw std::invalid_argument("--place-session is given, but the drive has no true poses");
  }
  map_matcher::GridGeometry geometry = session.geometry();
  geometry.T_map_grid = *trial.trueAlignment() * geometry.T_map_grid;
  return {geometry, session.values()};
}

void evaluate(const Arguments& arguments) {
  const bool recorded = !arguments.recorded.bag.empty();
  if (recorded && arguments.reference.empty()) {
    throw std::invalid_argument("--bag is given without --reference, expected the YAML file of its map");
  }
  const OccupancyGrid map = recorded ? map_matcher::loadMap(arguments.reference) : arguments.drive.map();
  const OccupancyGrid reference = arguments.reference.empty() ? map : map_matcher::loadMap(arguments.reference);
  Trial trial(reference, readOptions(arguments));
  if (!arguments.first_overlay.empty()) {
    trial.onFirstMatch([&](const OccupancyGrid& session, const map_matcher::Rigid2& T_reference_session) {
      map_matcher::writeOverlayImage(arguments.first_overlay, reference, session, T_reference_session);
    });
  }
  if (recorded) {
    const map_matcher::BagTrialResult played = playBag(arguments.recorded, trial);
    if (played.scans_left_out > 0) {
      std::cerr << played.scans_left_out << " of " << played.scans << " scans left out: " << played.last_problem
                << '\n';
    }
  } else {
    simulate(map, arguments, trial);
  }
  write(arguments.output, toCsv(trial.queries()));
  const auto session = trial.sessionMap();
  if (session && !arguments.session.empty()) {
    saveMap(arguments.place_session ? placed(*session, trial) : *session, arguments.session);
  }
  if (session && !arguments.last_overlay.empty()) {
    std::optional<map_matcher::Rigid2> pose;
    if (trial.queries().back().result.matched()) {
      pose = trial.queries().back().result.T_reference_session;
    }
    map_matcher::writeOverlayImage(arguments.last_overlay, reference, *session, pose);
  }
  printSummary(trial);
}

void describe(CLI::App& app, Arguments& arguments) {
  app.add_option("--output", arguments.output, "CSV file to write: a row for each session map")->required();
  app.add_option("--reference", arguments.reference, "YAML file of the map to match to; default: the one driven in");
  app.add_option("--config", arguments.config, "parameters, as in config/map_matcher.yaml");
  app.add_option("--mapper-config", arguments.mapper_config, "parameters, as in config/session_mapper.yaml");
  app.add_option("--scrubber-config", arguments.scrubber_config, "parameters, as in config/lidar_scrubber.yaml");
  app.add_flag("--scrub", arguments.trial.scrub, "remove people from the scans before they are mapped");
  app.add_option("--restart-interval", arguments.trial.restart_interval,
                 "throw the session map away so often [s]; 0: never")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--session", arguments.session, "YAML file for the last session map");
  app.add_flag("--place-session", arguments.place_session, "write it in the frame of the truth, where it really lies");
  app.add_option("--first-overlay", arguments.first_overlay, "picture of the first match");
  app.add_option("--last-overlay", arguments.last_overlay, "picture of the last session map where it was matched");
  auto* bag = app.add_option("--bag", arguments.recorded.bag, "recorded drive to use instead of a simulated one");
  app.add_option("--scan", arguments.recorded.scan_topic, "its topic of scans; default: the only one")->needs(bag);
  app.add_option("--truth", arguments.recorded.truth_topic, "its topic of true poses, geometry_msgs/PoseStamped")
      ->needs(bag);
  app.add_option("--detections", arguments.recorded.detection_topics, "its topics of detected people")->needs(bag);
  app.add_option("--odom-frame", arguments.recorded.odom_frame, "its frame of the odometry")->capture_default_str();
  app.add_option("--base-frame", arguments.recorded.base_frame, "its frame of the robot")->capture_default_str();
  arguments.drive.describe(app);
  app.footer("Exit status: 0 evaluated, 2 bad input.");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Takes a drive, simulated or recorded, through mapper and matcher.", "evaluate_drive");
  Arguments arguments(argc, argv);
  describe(app, arguments);
  return map_matcher::tools::run(app, argc, argv, [&arguments] {
    evaluate(arguments);
    return map_matcher::tools::kDone;
  });
}
