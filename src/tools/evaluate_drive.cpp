// Takes a drive, simulated or recorded, through mapper and matcher, and writes down what they made of it.

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command_line.hpp"
#include "drive_arguments.hpp"
#include "file_roles.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/trials/bag_session_maps.hpp"
#include "map_matcher/ros/trials/bag_trial.hpp"
#include "map_matcher/simulation/map_changes.hpp"
#include "map_matcher/trials/monte_carlo_trial.hpp"
#include "map_matcher/trials/simulated_trial.hpp"
#include "map_matcher/trials/trial_table.hpp"
#include "map_matcher/trials/truth_fit.hpp"

namespace {

namespace evaluation = map_matcher::evaluation;
namespace files = map_matcher::files;
namespace grid = map_matcher::grid;
namespace localization = map_matcher::localization;
namespace parameters = map_matcher::parameters;
namespace ros_mapping = map_matcher::ros_mapping;
namespace ros_matching = map_matcher::ros_matching;
namespace ros_scrubbing = map_matcher::ros_scrubbing;
namespace ros_trials = map_matcher::ros_trials;
namespace simulation = map_matcher::simulation;
namespace trials = map_matcher::trials;

struct Arguments {
  Arguments(int argc, char** argv) : drive(argc, argv) {}

  map_matcher::tools::DriveArguments drive;
  ros_trials::BagTrialRequest recorded;
  std::string session_maps;
  std::string reference;
  std::vector<double> missing;
  int starts = 1;
  bool stranger = false;
  std::string config;
  std::string mapper_config;
  std::string scrubber_config;
  std::string monte_carlo_config;
  trials::TrialOptions trial;
  std::string output;
  std::string monte_carlo;
  std::string session;
  bool place_session = false;
  std::string first_overlay;
  std::string last_overlay;
};

trials::TrialOptions readOptions(const Arguments& arguments) {
  trials::TrialOptions options = arguments.trial;
  if (!arguments.config.empty()) {
    ros_matching::MapMatcherServerOptions matcher;
    parameters::loadYamlParameters(arguments.config, parametersOf(matcher));
    options.match = matcher.match;
  }
  if (!arguments.mapper_config.empty()) {
    ros_mapping::SessionMapperServerOptions mapper;
    parameters::loadYamlParameters(arguments.mapper_config, parametersOf(mapper));
    options.mapper = mapper.mapping.mapper;
    options.map_update_interval = mapper.mapping.map_update_interval;
  }
  if (!arguments.scrubber_config.empty()) {
    ros_scrubbing::LidarScrubberServerOptions scrubber;
    parameters::loadYamlParameters(arguments.scrubber_config, parametersOf(scrubber));
    options.scrubbing = scrubber.scrubbing;
    options.detection_wait = scrubber.mode == "synchronised" ? scrubber.sync_timeout : 0.0;
  }
  return options;
}

localization::MonteCarloOptions monteCarloOptions(const Arguments& arguments) {
  localization::MonteCarloOptions options;
  if (!arguments.monte_carlo_config.empty()) {
    parameters::loadYamlParameters(arguments.monte_carlo_config, parametersOf(options));
  }
  options.seed = arguments.drive.options().seed;
  return options;
}

bool isRecorded(const Arguments& arguments) { return !arguments.recorded.bag.empty(); }

void warn(const std::string& text) { std::cerr << "evaluate_drive: warning: " << text << '\n'; }

/// One drive after the other, each with the next seed.
void simulate(const grid::OccupancyGrid& map, const Arguments& arguments, trials::Trial& trial) {
  simulation::DriveOptions options = arguments.drive.options();
  for (int start = 0; start < arguments.starts; ++start, ++options.seed) {
    simulation::DriveSimulation simulation(map, options);
    trial.beginDrive();
    while (const auto simulated = simulation.next()) {
      for (const auto& detections : trials::trialDetectionsOf(*simulated)) {
        trial.add(detections);
      }
      trials::TrialStep step = trials::trialStepOf(*simulated, simulation.lidarPoses());
      if (arguments.stranger) {
        step.truth.reset();
      }
      trial.add(step);
    }
  }
}

void printSummary(const std::vector<trials::TrialQuery>& queries) {
  int matched = 0;
  int right = 0;
  std::optional<trials::TrialQuery> first;
  for (const trials::TrialQuery& query : queries) {
    const auto error = query.robotError();
    matched += query.answer.matched() ? 1 : 0;
    right += error && error->translation < 1.0 ? 1 : 0;
    if (query.answer.matched() && !first) {
      first = query;
    }
  }
  std::cout << queries.size() << " session maps, " << matched << " matched, " << right
            << " of them within 1 m of the truth";
  if (first) {
    std::cout << "; first match after " << first->session_age << " s";
  }
  std::cout << '\n';
}

/// The session map in the frame of the truth, where it really lies.
grid::OccupancyGrid placed(const grid::OccupancyGrid& session, const trials::TrialQuery& query) {
  if (!query.true_alignment) {
    throw std::invalid_argument("--place-session is given, but the drive has no true poses");
  }
  grid::GridGeometry geometry = session.geometry();
  geometry.T_map_grid = *query.true_alignment * geometry.T_map_grid;
  return {geometry, session.values()};
}

bool hasPeople(const Arguments& arguments) {
  const simulation::PedestrianOptions people = arguments.drive.options().pedestrians;
  return people.people != 0 || people.density != 0.0;
}

/// The people who are to be put into the scans of a recorded drive; null for nobody.
std::unique_ptr<simulation::InsertedCrowd> crowdFor(const Arguments& arguments, const grid::OccupancyGrid& map) {
  const simulation::DriveOptions drive = arguments.drive.options();
  if (!hasPeople(arguments)) {
    return nullptr;
  }
  if (arguments.recorded.truth_topic.empty()) {
    throw std::invalid_argument(
        "--people or --density is given with --bag but without --truth, expected the topic of the robot's true poses, "
        "among which people are to walk");
  }
  return std::make_unique<simulation::InsertedCrowd>(
      map, simulation::InsertedCrowdOptions{drive.seed, drive.pedestrians, drive.detector, drive.robot.radius,
                                            drive.lidar.sigma});
}

void playRecorded(const Arguments& arguments, const grid::OccupancyGrid& map, trials::Trial& trial) {
  if (readOptions(arguments).detection_wait > 0.0 && !arguments.recorded.detection_topics.empty()) {
    warn(
        "mode is synchronised, but scans do not wait for recorded detections, which apply to later scans as with "
        "cached");
  }
  const std::unique_ptr<simulation::InsertedCrowd> crowd = crowdFor(arguments, map);
  const ros_trials::BagTrialResult played = ros_trials::playBag(arguments.recorded, trial, crowd.get());
  if (played.scans_left_out > 0 || played.detections_left_out > 0) {
    warn(std::to_string(played.scans_left_out) + " of " + std::to_string(played.scans) + " scans and " +
         std::to_string(played.detections_left_out) + " messages of detections left out: " + played.last_problem);
  }
  if (played.scans_without_people > 0) {
    warn(std::to_string(played.scans_without_people) + " of " + std::to_string(played.scans) +
         " scans left as they were recorded: the truth is not known there");
  }
}

/// Takes the drive through the trial, and what is compared with it.
void play(const Arguments& arguments, const grid::OccupancyGrid& map, const grid::OccupancyGrid& reference,
          trials::Trial& trial) {
  std::optional<trials::MonteCarloTrial> monte_carlo;
  if (!arguments.monte_carlo.empty()) {
    monte_carlo.emplace(reference, monteCarloOptions(arguments));
  }
  std::optional<trials::TruthFit> fit;
  if (isRecorded(arguments) && !hasPeople(arguments)) {  // simulated people are no walls, and simulated truth is true
    fit.emplace(reference);
  }
  trial.onMoment([&](const trials::TrialMoment& moment) {
    if (fit) {
      fit->add(moment);
    }
    if (monte_carlo) {
      monte_carlo->add(moment);
    }
  });
  if (isRecorded(arguments)) {
    playRecorded(arguments, map, trial);
  } else {
    simulate(map, arguments, trial);
  }
  if (const auto problem = fit ? fit->problem() : std::nullopt) {
    warn(*problem);
  }
  if (monte_carlo) {
    files::writeFile(arguments.monte_carlo, trials::toCsv(monte_carlo->rows()));
  }
}

/// Matches the session maps that a mapper drew while the bag was recorded.
void matchRecorded(const Arguments& arguments, trials::SessionMatching& matching) {
  const ros_trials::BagTrialRequest& recorded = arguments.recorded;
  const ros_trials::BagSessionMapsResult result =
      ros_trials::matchSessionMaps({recorded.bag, arguments.session_maps, recorded.truth_topic, recorded.truth_frame,
                                    recorded.odom_frame, recorded.base_frame},
                                   matching);
  if (result.maps_left_out > 0) {
    warn(std::to_string(result.maps_left_out) + " of " + std::to_string(result.maps) +
         " session maps left out: " + result.last_problem);
  }
}

void drawFirstMatch(const Arguments& arguments, const grid::OccupancyGrid& reference,
                    trials::SessionMatching& matching) {
  if (arguments.first_overlay.empty()) {
    return;
  }
  matching.onFirstMatch([&](const grid::OccupancyGrid& session, const grid::Rigid2& T_reference_session) {
    evaluation::writeOverlayImage(arguments.first_overlay, reference, session, T_reference_session);
  });
}

/// `session`: the session map at the end of the drive.
void writeResults(const Arguments& arguments, const grid::OccupancyGrid& reference,
                  const trials::SessionMatching& matching, const std::optional<grid::OccupancyGrid>& session) {
  files::writeFile(arguments.output, trials::toCsv(matching.queries()));
  printSummary(matching.queries());
  if (matching.queries().empty()) {
    return;
  }
  const trials::TrialQuery& last = matching.queries().back();
  if (session && !arguments.session.empty()) {
    grid::saveMap(arguments.place_session ? placed(*session, last) : *session, arguments.session);
  }
  if (!arguments.last_overlay.empty()) {
    evaluation::writeOverlayImage(arguments.last_overlay, reference, *matching.lastMap(), last.alignment());
  }
}

void requireDistinctFiles(const Arguments& arguments) {
  map_matcher::tools::FileRoles files;
  arguments.drive.addFiles(files);
  files.readsMap("--reference", arguments.reference)
      .reads("--config", arguments.config)
      .reads("--mapper-config", arguments.mapper_config)
      .reads("--scrubber-config", arguments.scrubber_config)
      .reads("--monte-carlo-config", arguments.monte_carlo_config)
      .reads("--bag", arguments.recorded.bag)
      .writes("--output", arguments.output)
      .writes("--monte-carlo", arguments.monte_carlo)
      .writesMap("--session", arguments.session)
      .writes("--first-overlay", arguments.first_overlay)
      .writes("--last-overlay", arguments.last_overlay)
      .requireDistinct();
}

/// What is matched to, where `map` is what is driven in.
grid::OccupancyGrid referenceFor(const Arguments& arguments, const grid::OccupancyGrid& map) {
  grid::OccupancyGrid reference = arguments.reference.empty() ? map : grid::loadMap(arguments.reference);
  if (arguments.missing.empty()) {
    return reference;
  }
  return simulation::withoutPart(std::move(reference), map_matcher::tools::rectangleOf("--missing", arguments.missing));
}

void evaluate(const Arguments& arguments) {
  requireDistinctFiles(arguments);
  if (isRecorded(arguments) && arguments.reference.empty()) {
    throw std::invalid_argument("--bag is given without --reference, expected the YAML file of its map");
  }
  const grid::OccupancyGrid map = isRecorded(arguments) ? grid::loadMap(arguments.reference) : arguments.drive.map();
  const grid::OccupancyGrid reference = referenceFor(arguments, map);
  const trials::TrialOptions options = readOptions(arguments);
  if (!arguments.session_maps.empty()) {
    if (hasPeople(arguments)) {
      throw std::invalid_argument("--people or --density is given with --session-maps, in which no one can be put");
    }
    trials::SessionMatching matching(reference, options.match);
    drawFirstMatch(arguments, reference, matching);
    matchRecorded(arguments, matching);
    writeResults(arguments, reference, matching, matching.lastMap());
    return;
  }
  trials::Trial trial(reference, options);
  drawFirstMatch(arguments, reference, trial.matching());
  play(arguments, map, reference, trial);
  writeResults(arguments, reference, trial.matching(), trial.sessionMap());
}

void describeRecorded(map_matcher::tools::CommandLine& command_line, Arguments& arguments,
                      const std::vector<const map_matcher::tools::Option*>& for_scans,
                      const std::vector<const map_matcher::tools::Option*>& for_simulation) {
  ros_trials::BagTrialRequest& recorded = arguments.recorded;
  auto& bag = command_line.add("--bag", &recorded.bag, "recorded drive to use instead of a simulated one");
  for (const map_matcher::tools::Option* option : for_simulation) {
    bag.excludes(*option);
  }
  const auto& scan =
      command_line.add("--scan", &recorded.scan_topic, "its topic of scans; default: the only one").needs(bag);
  auto& session_maps = command_line
                           .add("--session-maps", &arguments.session_maps,
                                "its topic of maps that slam_gmapping or another mapper drew when it was recorded, "
                                "nav_msgs/OccupancyGrid: they are matched, and no scans are mapped")
                           .needs(bag)
                           .excludes(scan);
  for (const map_matcher::tools::Option* option : for_scans) {
    session_maps.excludes(*option);
  }
  command_line.add("--truth", &recorded.truth_topic, "its topic of true poses, geometry_msgs/PoseStamped").needs(bag);
  command_line.add("--truth-frame", &recorded.truth_frame, "frame that they must have; default: any").needs(bag);
  command_line.add("--detections", &recorded.detection_topics, "its topics of detected people").needs(bag);
  command_line.add("--odom-frame", &recorded.odom_frame, "its frame of the odometry");
  command_line.add("--base-frame", &recorded.base_frame, "its frame of the robot");
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  command_line.add("--output", &arguments.output, "CSV file to write: a row for each session map").required();
  command_line.add("--reference", &arguments.reference, "YAML file of the map to match to; default: the one driven in");
  command_line
      .add("--missing", &arguments.missing,
           "the part of that map from x_min y_min to x_max y_max is unknown in it [m m m m]")
      .count(4);
  command_line.add("--config", &arguments.config, "parameters, as in config/map_matcher.yaml");
  const auto& mapper_config =
      command_line.add("--mapper-config", &arguments.mapper_config, "parameters, as in config/session_mapper.yaml");
  command_line.add("--scrubber-config", &arguments.scrubber_config, "parameters, as in config/lidar_scrubber.yaml");
  const auto& scrub =
      command_line.add("--scrub", &arguments.trial.scrub, "remove people from the scans before they are mapped").flag();
  const auto& restart = command_line
                            .add("--restart-interval", &arguments.trial.restart_interval,
                                 "throw the session map away so often [s]; 0: never")
                            .range(0.0, 1e6);
  const auto& starts =
      command_line
          .add("--starts", &arguments.starts,
               "so many simulated drives, each a session of its own: with --seed, and with the seeds that follow")
          .range(1, 10000);
  const auto& stranger = command_line
                             .add("--stranger", &arguments.stranger,
                                  "the map to match to is another building's: no place in it is the robot's")
                             .flag();
  const auto& monte_carlo = command_line.add("--monte-carlo", &arguments.monte_carlo,
                                             "CSV file to write: what Monte-Carlo localization without a prior makes "
                                             "of the same scans, at the same moments");
  command_line
      .add("--monte-carlo-config", &arguments.monte_carlo_config, "its parameters that differ from the defaults")
      .needs(monte_carlo);
  command_line.add("--session", &arguments.session, "YAML file for the last session map");
  command_line
      .add("--place-session", &arguments.place_session, "write it in the frame of the truth, where it really lies")
      .flag();
  command_line.add("--first-overlay", &arguments.first_overlay, "picture of the first match");
  command_line.add("--last-overlay", &arguments.last_overlay, "picture of the last session map where it was matched");
  describeRecorded(command_line, arguments, {&mapper_config, &scrub, &restart, &monte_carlo}, {&starts, &stranger});
  arguments.drive.describe(command_line);
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line(
      "evaluate_drive", "Takes a drive, simulated or recorded, through mapper and matcher.",
      "With --bag, --people or --density puts people into the recorded scans, where --truth says how the robot stands "
      "to them. Exit status: 0 evaluated, 2 bad input.");
  Arguments arguments(argc, argv);
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] {
    evaluate(arguments);
    return map_matcher::tools::kDone;
  });
}
