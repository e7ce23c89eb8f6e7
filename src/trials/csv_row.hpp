/// \file
/// A line of a table.
#pragma once

#include <optional>
#include <sstream>
#include <string>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::trials {

/// Cells separated by commas; what is not known is an empty cell.
class CsvRow {
 public:
  void add(const std::string& text) {
    line_ << (empty_ ? "" : ",") << text;
    empty_ = false;
  }
  void add(double value) { add(parameters::numberText(value)); }
  void add(const std::optional<double>& value) { add(value ? parameters::numberText(*value) : std::string()); }
  /// Three cells: x, y, yaw.
  void add(const std::optional<grid::Rigid2>& pose) {
    for (double grid::Rigid2::*field : {&grid::Rigid2::x, &grid::Rigid2::y, &grid::Rigid2::yaw}) {
      add(pose ? parameters::numberText((*pose).*field) : std::string());
    }
  }

  std::string line() const { return line_.str() + "\n"; }

 private:
  std::ostringstream line_;
  bool empty_ = true;
};

}  // namespace map_matcher::trials
