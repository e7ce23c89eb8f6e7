// Lays two maps of one building on each other: what moved, and is the reference map out of date?

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "file_roles.hpp"
#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/evaluation/map_changes.hpp"
#include "map_matcher/grid/map_file.hpp"

namespace {

namespace belief = map_matcher::belief;
namespace evaluation = map_matcher::evaluation;
namespace grid = map_matcher::grid;
namespace search = map_matcher::search;

constexpr int kNoMatch = 1;  // exit status

struct Arguments {
  std::string before;
  std::string after;
  std::vector<double> pose;
  double tolerance = 0.15;
  double deadline = 60.0;
  std::string output;
};

std::optional<grid::Rigid2> matchedPose(const grid::OccupancyGrid& before, const grid::OccupancyGrid& after,
                                        double deadline) {
  belief::MatchOptions options;
  options.search.exact_deadline = deadline;
  const search::Reference reference(before, options.search);
  const belief::Answer answer = matchAlone({&reference}, after, options);
  if (!answer.matched()) {
    std::cout << toString(answer.status) << ": " << answer.reason << "; give the pose with --pose\n";
  }
  return answer.alignment();
}

void print(const evaluation::MapChanges& changes, const grid::Rigid2& T_before_after, const Arguments& arguments,
           const grid::OccupancyGrid& before, const grid::OccupancyGrid& after) {
  const auto row = [](const char* name, int cells, int all, double resolution) {
    std::cout << std::left << std::setw(36) << name << cells * resolution << " m (" << 100.0 * cells / std::max(1, all)
              << " %)\n";
  };
  std::cout << std::setprecision(3) << "the newer map lies at x " << T_before_after.x << " m, y " << T_before_after.y
            << " m, yaw " << T_before_after.yaw << " rad in the older one\n";
  const int old_seen = changes.before.occupied - changes.before.unknown;
  const int new_seen = changes.after.occupied - changes.after.unknown;
  row("walls that are still there", changes.before.on_walls, old_seen, before.resolution());
  row("walls that are gone", changes.before.falsely_occupied, old_seen, before.resolution());
  row("walls that are new", changes.after.falsely_occupied, new_seen, after.resolution());
  row("old walls that were not seen again", changes.before.unknown, changes.before.occupied, before.resolution());
  row("new walls where nothing was known", changes.after.unknown, changes.after.occupied, after.resolution());
  std::cout << "lengths are those of wall cells, one cell thick; walls within " << arguments.tolerance
            << " m of each other are the same\n";
}

int compare(const Arguments& arguments) {
  map_matcher::tools::FileRoles()
      .readsMap("--before", arguments.before)
      .readsMap("--after", arguments.after)
      .writes("--output", arguments.output)
      .requireDistinct();
  const grid::OccupancyGrid before = grid::loadMap(arguments.before);
  const grid::OccupancyGrid after = grid::loadMap(arguments.after);
  std::optional<grid::Rigid2> pose;
  if (arguments.pose.empty()) {
    pose = matchedPose(before, after, arguments.deadline);
  } else {
    pose = grid::Rigid2{arguments.pose[0], arguments.pose[1], arguments.pose[2]};
  }
  if (!pose) {
    return kNoMatch;
  }
  print(evaluation::mapChanges(before, after, *pose, arguments.tolerance), *pose, arguments, before, after);
  if (!arguments.output.empty()) {
    evaluation::writeChangesImage(arguments.output, before, after, *pose, arguments.tolerance);
  }
  return map_matcher::tools::kDone;
}

void describe(map_matcher::tools::CommandLine& command_line, Arguments& arguments) {
  command_line.add("--before", &arguments.before, "YAML file of the older map, the reference").required();
  command_line.add("--after", &arguments.after, "YAML file of the newer map").required();
  command_line
      .add("--pose", &arguments.pose, "x y yaw of the newer map in the older one [m m rad]; default: by matching")
      .count(3);
  command_line.add("--tolerance", &arguments.tolerance, "walls no farther apart are the same [m]").range(0.0, 10.0);
  command_line.add("--deadline", &arguments.deadline, "longest time for matching [s]").range(0.1, 3600.0);
  command_line.add("--output", &arguments.output, "picture: gone red, new green, still there dark, not seen grey");
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line("compare_maps", "Lays two maps of one building on each other.",
                                               "Exit status: 0 compared, 1 no match, 2 bad input.");
  Arguments arguments;
  describe(command_line, arguments);
  return map_matcher::tools::run(command_line, argc, argv, [&arguments] { return compare(arguments); });
}
