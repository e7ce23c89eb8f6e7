// Compares a session map with the true map: how much of it is really there?

#include "map_matcher/evaluation/map_quality.hpp"

#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/evaluation/overlay_image.hpp"
#include "map_matcher/grid/map_file.hpp"

namespace {

namespace belief = map_matcher::belief;
namespace evaluation = map_matcher::evaluation;
namespace grid = map_matcher::grid;
namespace search = map_matcher::search;

constexpr int kNoMatch = 1;  // exit status

struct Arguments {
  std::string truth;
  std::string session;
  std::vector<double> pose;
  double tolerance = 0.15;
  std::string overlay;
};

std::optional<grid::Rigid2> matchedPose(const grid::OccupancyGrid& truth, const grid::OccupancyGrid& session) {
  const belief::MatchOptions options;
  const search::Reference reference(truth, options.search);
  const belief::Answer answer = matchAlone({&reference}, session, options);
  if (!answer.matched()) {
    std::cout << toString(answer.status) << ": " << answer.reason << '\n';
  }
  return answer.alignment();
}

void print(const evaluation::MapQuality& quality, const grid::Rigid2& T_true_session, double tolerance) {
  const auto row = [&quality](const char* name, int cells) {
    std::cout << std::left << std::setw(20) << name << cells << " cells ("
              << 100.0 * cells / std::max(1, quality.occupied) << " %)\n";
  };
  std::cout << std::setprecision(3) << "compared at x " << T_true_session.x << " m, y " << T_true_session.y
            << " m, yaw " << T_true_session.yaw << " rad\n";
  row("occupied", quality.occupied);
  row("on walls", quality.on_walls);
  row("falsely occupied", quality.falsely_occupied);
  row("where unknown", quality.unknown);
  std::cout << "within " << tolerance << " m of a wall counts as on it\n";
}

int compare(const Arguments& arguments) {
  map_matcher::tools::FileRoles()
      .readsMap("--truth", arguments.truth)
      .readsMap("--session", arguments.session)
      .writes("--overlay", arguments.overlay)
      .requireDistinct();
  const grid::OccupancyGrid truth = grid::loadMap(arguments.truth);
  const grid::OccupancyGrid session = grid::loadMap(arguments.session);
  std::optional<grid::Rigid2> pose;
  if (arguments.pose.empty()) {
    pose = matchedPose(truth, session);
  } else {
    pose = grid::Rigid2{arguments.pose[0], arguments.pose[1], arguments.pose[2]};
  }
  if (!pose) {
    return kNoMatch;
  }
  print(evaluation::mapQuality(truth, session, *pose, arguments.tolerance), *pose, arguments.tolerance);
  if (!arguments.overlay.empty()) {
    evaluation::writeOverlayImage(arguments.overlay, truth, session, pose);
  }
  return map_matcher::tools::kDone;
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  command_line.add("--truth", &arguments.truth, "YAML file of the true map").required();
  command_line.add("--session", &arguments.session, "YAML file of the session map").required();
  command_line
      .add("--pose", &arguments.pose, "x y yaw of the session map in the true map [m m rad]; default: by matching")
      .count(3);
  command_line.add("--tolerance", &arguments.tolerance, "distance from a wall that counts as on it [m]")
      .range(0.0, 10.0);
  command_line.add("--overlay", &arguments.overlay, "picture of both maps");
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line("map_quality", "Compares a session map with the true map.",
                                               "Exit status: 0 compared, 1 no match, 2 bad input.");
  Arguments arguments;
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] { return compare(arguments); });
}
