#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "map_matcher/ros/matching/map_matcher_server_options.hpp"
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

/// Rows of the table of parameters in the documentation, by name.
std::map<std::string, std::vector<std::string>> parameterRows() {
  std::map<std::string, std::vector<std::string>> rows;
  std::ifstream file(test::sourceFile("docs/interfaces.md"));
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("| `~", 0) == 0) {
      const std::vector<std::string> cells = cellsOf(line);
      if (cells.size() == 4) {  // those of topics and services have three
        rows[cells[0].substr(1)] = cells;
      }
    }
  }
  return rows;
}

/// "unit, range" as the table has it; choices are separated by commas there, as | would end the cell.
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

TEST(Documentation, ListsEveryParameterWithItsDefaultAndItsRange) {
  ros_matching::MapMatcherServerOptions options;
  const auto rows = parameterRows();
  const parameters::ParameterList parameters = parametersOf(options);

  EXPECT_EQ(rows.size(), parameters.size());
  for (const parameters::Parameter& parameter : parameters) {
    ASSERT_EQ(rows.count(parameter.name), 1U) << parameter.name << " is not in the table";
    const std::vector<std::string>& cells = rows.at(parameter.name);
    EXPECT_EQ(cells[1], parameters::valueText(parameter)) << parameter.name;
    EXPECT_EQ(cells[2], rangeCell(parameter)) << parameter.name;
    EXPECT_FALSE(cells[3].empty()) << parameter.name;
  }
}

}  // namespace
}  // namespace map_matcher
