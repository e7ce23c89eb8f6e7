// Matches two map files without a roscore: where does the session map lie in the reference map?

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_line.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/map_matcher_server_options.hpp"
#include "map_matcher/search/map_matcher.hpp"

namespace {

using map_matcher::MatchOptions;
using map_matcher::MatchResult;
using map_matcher::OccupancyGrid;
using map_matcher::Rigid2;
using map_matcher::StageReport;

constexpr int kNoMatch = 1;  // exit status

struct Arguments {
  std::string reference;
  std::string session;
  std::string search;  // empty: what the configuration says
  std::string config;
  std::string json;
  std::string overlay;
};

nlohmann::ordered_json toJson(const StageReport& stage) {
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

nlohmann::ordered_json toJson(const MatchResult& result) {
  nlohmann::ordered_json json{{"status", toString(result.status)}, {"reason", result.reason}};
  json["transform"] = nullptr;
  if (result.matched()) {
    const Rigid2& T = result.T_reference_session;
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
    const Rigid2& T = result.T_reference_session;
    const double ratio = result.hit_cells > 0 ? result.hit_ratio : result.ratio;
    json["candidate"] = {{"x", T.x}, {"y", T.y}, {"yaw", T.yaw}, {"ratio", ratio}};
  }
  json["runner_up"] = nullptr;
  if (result.runner_up) {
    const Rigid2& T = result.runner_up->T_reference_session;
    json["runner_up"] = {{"x", T.x}, {"y", T.y}, {"yaw", T.yaw}, {"ratio", result.runner_up->ratio}};
  }
  json["margin"] = result.margin;
  json["search_time"] = result.search_time;
  json["reference_time"] = result.reference_time;
  json["stages"] = nlohmann::ordered_json::array();
  for (const StageReport& stage : result.stages) {
    json["stages"].push_back(toJson(stage));
  }
  return json;
}

void writeJson(const std::string& path, const MatchResult& result) {
  if (path == "-") {
    std::cout << toJson(result).dump(2) << std::endl;
    return;
  }
  std::ofstream file(path);
  file << toJson(result).dump(2) << '\n';
  if (!file.flush()) {
    throw std::runtime_error("JSON file '" + path + "' cannot be written");
  }
}

void printSummary(const MatchResult& result) {
  std::cout << toString(result.status) << ": " << result.reason << '\n';
  if (result.matched()) {
    const Rigid2& T = result.T_reference_session;
    std::cout << "T_reference_session: x " << T.x << " m, y " << T.y << " m, yaw " << T.yaw << " rad\n"
              << "ratio " << result.ratio << " (" << result.matched_cells << " of " << result.total_cells
              << " session cells)\n";
  }
  if (result.total_cells > 0 && result.hit_cells > 0) {
    std::cout << "hit ratio " << result.hit_ratio << ", " << (result.certified ? "certified" : "not certified")
              << ", upper bound " << result.upper_bound << ", margin " << (result.runner_up && result.runner_up_proven ? "" : "at least ")
              << result.margin << '\n';
  }
  for (const StageReport& stage : result.stages) {
    std::cout << stage.name << " stage: " << stage.resolution << " m, " << stage.rotations << " rotations, ratio "
              << stage.ratio << ", " << stage.nodes_scored << " nodes scored, "
              << 1e3 * (stage.initialization_time + stage.rotation_expansion_time + stage.depth_first_search_time)
              << " ms\n";
  }
  std::cout << "search " << 1e3 * result.search_time << " ms, reference " << 1e3 * result.reference_time << " ms\n";
}

/// Options from the configuration file, which is the node's, and from the command line.
MatchOptions readOptions(const Arguments& arguments) {
  map_matcher::MapMatcherServerOptions options;
  if (!arguments.config.empty()) {
    loadYamlParameters(arguments.config, parametersOf(options));
  }
  if (!arguments.search.empty()) {
    options.match.search = arguments.search;
  }
  return options.match;
}

int matchMaps(const Arguments& arguments) {
  const MatchOptions options = readOptions(arguments);
  map_matcher::MapMatcher matcher(options);
  const OccupancyGrid reference = map_matcher::loadMap(arguments.reference);
  const OccupancyGrid session = map_matcher::loadMap(arguments.session);
  matcher.setReference(reference);
  const MatchResult result = matcher.match(session);
  if (arguments.json != "-") {
    printSummary(result);
  }
  if (!arguments.json.empty()) {
    writeJson(arguments.json, result);
  }
  if (!arguments.overlay.empty()) {
    const auto pose = result.matched() ? std::optional<Rigid2>(result.T_reference_session) : std::nullopt;
    map_matcher::writeOverlayImage(arguments.overlay, reference, session, pose,
                                   static_cast<std::int8_t>(options.occupied_threshold));
  }
  return result.matched() ? map_matcher::tools::kDone : kNoMatch;
}

void describe(CLI::App& app, Arguments& arguments) {
  app.add_option("--reference", arguments.reference, "YAML file of the reference map")->required();
  app.add_option("--session", arguments.session, "YAML file of the session map")->required();
  app.add_option("--search", arguments.search,
                 "how to search: two_stage (coarse, then fine) or exact (and then the proof; the default)")
      ->check(CLI::IsMember({"two_stage", "exact"}));
  app.add_option("--config", arguments.config, "parameters, as in config/map_matcher.yaml");
  app.add_option("--json", arguments.json, "write the result as JSON to this file; - for standard output alone");
  app.add_option("--overlay", arguments.overlay, "draw both maps on each other into this PNG file");
  app.footer("Exit status: 0 matched, 1 no acceptable match, 2 bad input.");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds where a session map lies in a reference map.", "match_maps");
  Arguments arguments;
  describe(app, arguments);
  return map_matcher::tools::run(app, argc, argv, [&arguments] { return matchMaps(arguments); });
}
