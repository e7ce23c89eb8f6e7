#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "map_matcher/ros/evaluation/pose_evaluator_server.hpp"
#include "map_matcher/ros/mapping/session_mapper_server_options.hpp"
#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
#include "map_matcher/ros/merging/scan_merger_server_options.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "map_matcher/ros/simulation/crowd_simulator_server_options.hpp"
#include "support/source_dir.hpp"

namespace map_matcher {
namespace {

/// Cells of a table row, without the spaces and backticks around them.
std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t begin = 1; begin < row.size();) {
    const std::size_t end = std::min(row.find('|', begin), row.size());
    const std::size_t first = row.find_first_not_of(" `", begin);
    const std::size_t last = row.find_last_not_of(" `", end - 1);
    cells.push_back(first < end ? row.substr(first, last + 1 - first) : "");
    begin = end + 1;
  }
  return cells;
}

using Rows = std::map<std::string, std::vector<std::string>>;

/// Rows of a page's tables of parameters, by name: those under the heading "## <part>", or all where that is empty.
Rows parameterRows(const std::string& page, const std::string& part) {
  Rows rows;
  std::ifstream file(test::sourceFile(page));
  bool is_part = part.empty();
  for (std::string line; std::getline(file, line);) {
    if (!part.empty() && line.rfind("## ", 0) == 0) {
      is_part = line == "## " + part;
    } else if (is_part && line.rfind("| `~", 0) == 0) {
      const std::vector<std::string> cells = cellsOf(line);
      EXPECT_EQ(cells.size(), 4U) << line;
      EXPECT_EQ(rows.count(cells[0].substr(1)), 0U) << cells[0] << " stands there twice";
      rows[cells[0].substr(1)] = cells;
    }
  }
  return rows;
}

/// "unit, range" as the tables have it; choices are separated by commas there, as | would end the cell.
std::string rangeCell(const parameters::Parameter& parameter) {
  if (std::holds_alternative<std::string*>(parameter.value) && parameter.choices.empty()) {
    return "";
  }
  std::string range = parameters::rangeText(parameter);
  for (std::size_t bar = range.find(" |"); bar != std::string::npos; bar = range.find(" |")) {
    range.replace(bar, 2, ",");
  }
  return parameter.unit.empty() ? range : parameter.unit + ", " + range;
}

void expectRow(const parameters::Parameter& parameter, const Rows& rows) {
  ASSERT_EQ(rows.count(parameter.name), 1U) << parameter.name << " is not in the table";
  const std::vector<std::string>& cells = rows.at(parameter.name);
  EXPECT_EQ(cells[1], parameters::valueText(parameter)) << parameter.name;
  EXPECT_EQ(cells[2], rangeCell(parameter)) << parameter.name;
  EXPECT_FALSE(cells[3].empty()) << parameter.name;
}

template <typename Options>
void expectPart(const std::string& part) {
  Options options;
  const Rows rows = parameterRows("docs/parameters.md", part);
  const parameters::ParameterList parameters = parametersOf(options);
  EXPECT_EQ(rows.size(), parameters.size()) << part;
  for (const parameters::Parameter& parameter : parameters) {
    expectRow(parameter, rows);
  }
}

TEST(ParameterPage, ListsEveryParameterOfEveryNodeWithItsDefaultAndItsRange) {
  expectPart<ros_matching::MapMatcherServerOptions>("map_matcher");
  expectPart<ros_scrubbing::LidarScrubberServerOptions>("lidar_scrubber");
  expectPart<ros_mapping::SessionMapperServerOptions>("session_mapper");
  expectPart<ros_merging::ScanMergerServerOptions>("scan_merger");
  expectPart<ros_simulation::CrowdSimulatorServerOptions>("crowd_simulator");
  expectPart<ros_evaluation::PoseEvaluatorOptions>("pose_evaluator");
}

TEST(Readme, ListsParametersThatThereAreWithTheirDefaultsAndTheirRanges) {
  ros_matching::MapMatcherServerOptions options;
  const parameters::ParameterList parameters = parametersOf(options);
  const Rows rows = parameterRows("README.md", "");

  EXPECT_GE(rows.size(), 8U);
  for (const auto& row : rows) {
    const auto described = std::find_if(parameters.begin(), parameters.end(),
                                        [&row](const auto& parameter) { return parameter.name == row.first; });
    ASSERT_NE(described, parameters.end()) << "there is no " << row.first;
    expectRow(*described, rows);
  }
}

}  // namespace
}  // namespace map_matcher
