#include "map_matcher/mapping/session_mapper_options.hpp"

#include <sstream>

#include "map_matcher/mapping/hit_counting_grid.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::mapping {
namespace {

constexpr double kSmallestCell = 0.001;   // [m]
constexpr double kLargestCell = 1.0;      // [m]
constexpr double kLargestExtent = 1e5;    // [m]
constexpr double kLongestRange = 1000.0;  // [m]
constexpr double kLargestTurn = 3.15;     // [rad] a bit more than half a turn

parameters::ParameterList matchParametersOf(SessionMapperOptions& options) {
  return {
      {"match_linear_update", "m", "Motion after which a scan corrects the pose again.", &options.match_linear_update,
       0.0, 100.0},
      {"match_angular_update", "rad", "Turning after which a scan corrects the pose again.",
       &options.match_angular_update, 0.0, kLargestTurn},
      {"sigma", "m", "Standard deviation of the ends of beams from the wall that they ended at, as it was drawn.",
       &options.sigma, 0.001, 1.0},
      {"srr", "m", "Standard deviation of the odometry's way after a metre.", &options.odometry.srr, 0.0, 10.0},
      {"srt", "rad", "Standard deviation of the odometry's heading after a metre.", &options.odometry.srt, 0.0, 10.0},
      {"str", "m", "Standard deviation of the odometry's position after turning a radian.", &options.odometry.str, 0.0,
       10.0},
      {"stt", "rad", "Standard deviation of the odometry's heading after turning a radian.", &options.odometry.stt, 0.0,
       10.0},
  };
}

void expectBelow(const char* low_name, double low, const char* high_name, double high,
                 std::vector<std::string>& problems) {
  if (low >= high) {
    std::ostringstream text;
    text << low_name << " is " << low << ", expected less than " << high_name << " = " << high << " m";
    problems.push_back(text.str());
  }
}

}  // namespace

parameters::ParameterList parametersOf(SessionMapperOptions& options) {
  parameters::ParameterList parameters = {
      {"linearUpdate", "m", "Motion after which a scan is drawn.", &options.linear_update, 0.0, 100.0},
      {"angularUpdate", "rad", "Turning after which a scan is drawn.", &options.angular_update, 0.0, kLargestTurn},
      {"temporalUpdate", "s",
       "Time after which a scan is drawn though the robot stands, so that walls appear where people were; negative: "
       "never.",
       &options.temporal_update, -1.0, 3600.0},
      {"maxRange", "m", "Longer ranges say nothing; 0: the scan's range_max less 1 cm.", &options.max_range, 0.0,
       kLongestRange},
      {"maxUrange", "m", "Longer ranges clear the space up to here and show no wall, at most maxRange; 0: as maxRange.",
       &options.max_urange, 0.0, kLongestRange},
      {"delta", "m", "Edge length of a cell of the map.", &options.delta, kSmallestCell, kLargestCell},
      {"occ_thresh", "", "A cell is a wall when more than this share of the beams that reached it ended in it.",
       &options.occ_thresh, 0.0, 1.0},
      {"xmin", "m", "Left side of the first map as seen from the robot, less than xmax; the map grows as needed.",
       &options.xmin, -kLargestExtent, kLargestExtent},
      {"ymin", "m", "Lower side of the first map, less than ymax.", &options.ymin, -kLargestExtent, kLargestExtent},
      {"xmax", "m", "Right side of the first map.", &options.xmax, -kLargestExtent, kLargestExtent},
      {"ymax", "m", "Upper side of the first map.", &options.ymax, -kLargestExtent, kLargestExtent},
  };
  const parameters::ParameterList match = matchParametersOf(options);
  parameters.insert(parameters.end(), match.begin(), match.end());
  return parameters;
}

std::vector<std::string> problemsWith(const SessionMapperOptions& options) {
  SessionMapperOptions copy = options;
  std::vector<std::string> problems = parameters::problemsOf(parametersOf(copy));
  expectBelow("xmin", options.xmin, "xmax", options.xmax, problems);
  expectBelow("ymin", options.ymin, "ymax", options.ymax, problems);
  if (options.max_range > 0.0 && options.max_urange > options.max_range) {
    std::ostringstream text;
    text << "maxUrange is " << options.max_urange << ", expected at most maxRange = " << options.max_range << " m";
    problems.push_back(text.str());
  }
  const double cells = (options.xmax - options.xmin) / options.delta * ((options.ymax - options.ymin) / options.delta);
  if (problems.empty() && cells > static_cast<double>(HitCountingGrid::kMaxCells)) {
    std::ostringstream text;
    text << "delta is " << options.delta << ", expected a value for which the first map from (xmin, ymin) to (xmax, "
         << "ymax) takes at most " << HitCountingGrid::kMaxCells << " cells, not " << cells;
    problems.push_back(text.str());
  }
  return problems;
}

}  // namespace map_matcher::mapping
