// Matches two map files without a roscore: where does the session map lie in the reference map?

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/search/map_matcher.hpp"

namespace {

using map_matcher::grid::OccupancyGrid;
using map_matcher::grid::Rigid2;
using map_matcher::search::MatchOptions;
using map_matcher::search::MatchResult;
using map_matcher::search::StageReport;

constexpr int kNoMatch = 1;  // exit status

struct Arguments {
  std::string reference;
  std::string session;
  std::string search;  // empty: what the configuration says
  std::string config;
  std::string json;
  std::string overlay;
};

nlohmann::json toJson(const search::StageReport& stage) {
  return {{"name", stage.name},
          {"answered", stage.answered},
          {"resolution", stage.resolution},
          {"rotations", stage.rotations},
          {"rotation_step", stage.rotation_step},
          {"matched_cells", stage.matched_cells},
          {"total_cells", stage.total_cells},
          {"ratio", stage.ratio},
          {"nodes_scored", stage.nodes_scored},
          {"nodes_expanded", stage.nodes_expanded},
          {"initialization_time", stage.initialization_time},
          {"rotation_expansion_time", stage.rotation_expansion_time},
          {"depth_first_search_time", stage.depth_first_search_time}};
}

nlohmann::json toJson(const search::MatchResult& result) {
  nlohmann::json json{{"status", toString(result.status)}, {"reason", result.reason}};
  json["transform"] = nullptr;
  if (result.matched()) {
    const grid::Rigid2& T = result.T_reference_session;
    json["transform"] = {{"x", T.x}, {"y", T.y}, {"yaw", T.yaw}};
  }
  json["searched"] = nullptr;
  if (result.searched) {
    json["searched"] = {{"x", result.searched->x}, {"y", result.searched->y}, {"yaw", result.searched->yaw}};
  }
  json["refined"] = result.refined;
  json["ratio"] = result.ratio;
  json["matched_cells"] = result.matched_cells;
  json["total_cells"] = result.total_cells;
  json["certified"] = result.certified;
  json["replaced"] = result.replaced;
  json["hit_ratio"] = result.hit_ratio;
  json["hit_cells"] = result.hit_cells;
  json["upper_bound"] = result.upper_bound;
  json["candidate"] = nullptr;
  if (result.matched() || result.hit_cells > 0) {
    const grid::Rigid2& T = result.T_reference_session;
    const double ratio = result.hit_cells > 0 ? result.hit_ratio : result.ratio;
    json["candidate"] = {{"x", T.x}, {"y", T.y}, {"yaw", T.yaw}, {"ratio", ratio}};
  }
  json["runner_up"] = nullptr;
  if (result.runner_up) {
    const grid::Rigid2& T = result.runner_up->T_reference_session;
    json["runner_up"] = {{"x", T.x}, {"y", T.y}, {"yaw", T.yaw}, {"ratio", result.runner_up->ratio}};
  }
  json["margin"] = result.margin;
  json["search_time"] = result.search_time;
  json["reference_time"] = result.reference_time;
  json["stages"] = nlohmann::json::array();
  for (const search::StageReport& stage : result.stages) {
    json["stages"].push_back(toJson(stage));
  }
  return json;
}

void writeJson(const std::string& path, const search::MatchResult& result) {
  const std::string text = toJson(result).dump(2) + '\n';
  if (path == "-") {
    std::cout << text;
  } else {
    map_matcher::files::writeFile(path, text);
  }
}

void printSummary(const search::MatchResult& result) {
  std::cout << toString(result.status) << ": " << result.reason << '\n';
  if (result.matched()) {
    const grid::Rigid2& T = result.T_reference_session;
    std::cout << "T_reference_session: x " << T.x << " m, y " << T.y << " m, yaw " << T.yaw << " rad\n"
              << "ratio " << result.ratio << " (" << result.matched_cells << " of " << result.total_cells
              << " session cells)\n";
  }
  if (result.total_cells > 0 && result.hit_cells > 0) {
    std::cout << "hit ratio " << result.hit_ratio << ", " << (result.certified ? "certified" : "not certified")
              << ", upper bound " << result.upper_bound << ", margin "
              << (result.runner_up && result.runner_up_proven ? "" : "at least ") << result.margin << '\n';
  }
  for (const search::StageReport& stage : result.stages) {
    std::cout << stage.name << " stage: " << stage.resolution << " m, " << stage.rotations << " rotations, ratio "
              << stage.ratio << ", " << stage.nodes_scored << " nodes scored, "
              << 1e3 * (stage.initialization_time + stage.rotation_expansion_time + stage.depth_first_search_time)
              << " ms\n";
  }
  std::cout << "search " << 1e3 * result.search_time << " ms, reference " << 1e3 * result.reference_time << " ms\n";
}

/// Options from the configuration file, which is the node's, and from the command line.
search::MatchOptions readOptions(const Arguments& arguments) {
  map_matcher::ros_matching::MapMatcherServerOptions options;
  if (!arguments.config.empty()) {
    parameters::loadYamlParameters(arguments.config, parametersOf(options));
  }
  if (!arguments.search.empty()) {
    options.match.search = arguments.search;
  }
  return options.match;
}

int matchMaps(const Arguments& arguments) {
  map_matcher::tools::FileRoles()
      .readsMap("--reference", arguments.reference)
      .readsMap("--session", arguments.session)
      .reads("--config", arguments.config)
      .writes("--json", arguments.json)
      .writes("--overlay", arguments.overlay)
      .requireDistinct();
  const search::MatchOptions options = readOptions(arguments);
  map_matcher::search::MapMatcher matcher(options);
  const grid::OccupancyGrid reference = map_matcher::grid::loadMap(arguments.reference);
  const grid::OccupancyGrid session = map_matcher::grid::loadMap(arguments.session);
  matcher.setReference(reference);
  const search::MatchResult result = matcher.match(session);
  if (arguments.json != "-") {
    printSummary(result);
  }
  if (!arguments.json.empty()) {
    writeJson(arguments.json, result);
  }
  if (!arguments.overlay.empty()) {
    const auto pose = result.matched() ? std::optional<grid::Rigid2>(result.T_reference_session) : std::nullopt;
    map_matcher::evaluation::writeOverlayImage(arguments.overlay, reference, session, pose, options);
  }
  return result.matched() ? map_matcher::tools::kDone : kNoMatch;
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  command_line.add("--reference", &arguments.reference, "YAML file of the reference map").required();
  command_line.add("--session", &arguments.session, "YAML file of the session map").required();
  command_line
      .add("--search", &arguments.search,
           "how to search: two_stage (coarse, then fine) or exact (and then the proof; the default)")
      .choices({"two_stage", "exact"});
  command_line.add("--config", &arguments.config, "parameters, as in config/map_matcher.yaml");
  command_line.add("--json", &arguments.json, "write the result as JSON to this file; - for standard output alone");
  command_line.add("--overlay", &arguments.overlay, "draw both maps on each other into this PNG file");
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line("match_maps", "Finds where a session map lies in a reference map.",
                                               "Exit status: 0 matched, 1 no acceptable match, 2 bad input.");
  Arguments arguments;
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] { return matchMaps(arguments); });
}
