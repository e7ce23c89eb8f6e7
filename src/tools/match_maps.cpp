// Matches two map files without a roscore: where does the session map lie in the reference map?

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/belief/answer_fields.hpp"
#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"

namespace {

namespace belief = map_matcher::belief;
namespace evaluation = map_matcher::evaluation;
namespace files = map_matcher::files;
namespace grid = map_matcher::grid;
namespace parameters = map_matcher::parameters;
namespace ros_matching = map_matcher::ros_matching;
namespace search = map_matcher::search;

constexpr int kNoMatch = 1;  // exit status

struct Arguments {
  std::string reference;
  std::string session;
  std::string search;  // empty: what the configuration says
  std::string config;
  std::string json;
  std::string overlay;
};

nlohmann::json toJson(const grid::Rigid2& pose) { return {{"x", pose.x}, {"y", pose.y}, {"yaw", pose.yaw}}; }

nlohmann::json toJson(const belief::FieldList& fields) {
  nlohmann::json json;
  for (const belief::Field& field : fields) {
    json[field.name] = std::visit(
        [](const auto& value) -> nlohmann::json {
          using Value = std::decay_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, std::monostate>) {
            return nullptr;
          } else if constexpr (std::is_same_v<Value, grid::Rigid2>) {
            return toJson(value);
          } else {
            return value;
          }
        },
        field.value);
  }
  return json;
}

template <typename Item>
nlohmann::json toJson(const std::vector<Item>& items) {
  nlohmann::json json = nlohmann::json::array();
  for (const Item& item : items) {
    json.push_back(toJson(belief::fieldsOf(item)));
  }
  return json;
}

nlohmann::json toJson(const belief::Answer& answer) {
  nlohmann::json json = toJson(fieldsOf(answer));
  json["evidence"] = toJson(answer.evidence);
  json["stages"] = toJson(answer.search.stages);
  return json;
}

void writeJson(const std::string& path, const belief::Answer& answer) {
  const std::string text = toJson(answer).dump(2) + '\n';
  if (path == "-") {
    std::cout << text;
  } else {
    files::writeFile(path, text);
  }
}

void printSummary(const belief::Answer& answer) {
  const search::SearchResult& search = answer.search;
  std::cout << toString(answer.status) << ": " << answer.reason << '\n';
  if (answer.matched()) {
    const grid::Rigid2& T = search.T_reference_session;
    std::cout << "T_reference_session: x " << T.x << " m, y " << T.y << " m, yaw " << T.yaw << " rad\n"
              << "ratio " << search.ratio << " (" << search.matched_cells << " of " << search.total_cells
              << " session cells)\n";
  }
  for (const belief::Evidence& piece : answer.evidence) {
    std::cout << piece.name << " " << piece.value << " (limit " << piece.limit << "): " << toString(piece.bearing)
              << '\n';
  }
  for (const search::StageReport& stage : search.stages) {
    std::cout << stage.name << " stage: " << stage.resolution << " m, " << stage.rotations << " rotations, ratio "
              << stage.ratio << ", " << stage.nodes_scored << " nodes scored, " << 1e3 * stage.time() << " ms\n";
  }
  std::cout << "search " << 1e3 * search.search_time << " ms, reference " << 1e3 * search.reference_time << " ms\n";
}

/// Options from the configuration file, which is the node's, and from the command line.
belief::MatchOptions readOptions(const Arguments& arguments) {
  ros_matching::MapMatcherServerOptions options;
  if (!arguments.config.empty()) {
    parameters::loadYamlParameters(arguments.config, parametersOf(options));
  }
  if (!arguments.search.empty()) {
    options.match.search.search = arguments.search;
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
  const belief::MatchOptions options = readOptions(arguments);
  const search::Reference reference(grid::loadMap(arguments.reference), options.search);
  const grid::OccupancyGrid session = grid::loadMap(arguments.session);
  const belief::Answer answer = matchAlone({&reference}, session, options);
  if (arguments.json != "-") {
    printSummary(answer);
  }
  if (!arguments.json.empty()) {
    writeJson(arguments.json, answer);
  }
  if (!arguments.overlay.empty()) {
    evaluation::writeOverlayImage(arguments.overlay, reference.grid(), session, answer.alignment(), options.search);
  }
  return answer.matched() ? map_matcher::tools::kDone : kNoMatch;
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
