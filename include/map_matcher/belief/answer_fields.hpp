/// \file
/// The one description of an answer that JSON output and tables are made from.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::belief {

/// Something that is told of an answer, by the name that messages, JSON output and tables have for it.
struct Field {
  std::string name;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, grid::Rigid2> value;  ///< The first: not known.
};

using FieldList = std::vector<Field>;

/// What is told of an answer, but for its evidence and its stages.
FieldList fieldsOf(const Answer& answer);

/// What is told of a stage.
FieldList fieldsOf(const search::StageReport& stage);

/// What is told of a piece of evidence.
FieldList fieldsOf(const Evidence& evidence);

}  // namespace map_matcher::belief
