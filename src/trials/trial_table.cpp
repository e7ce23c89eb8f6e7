#include "map_matcher/trials/trial_table.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <variant>

#include "csv_row.hpp"
#include "map_matcher/belief/answer_fields.hpp"

namespace map_matcher::trials {
namespace {

/// A table's cell of what is told of something by a name; empty where it is not known.
std::string cellOf(const belief::FieldList& fields, const std::string& name) {
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&name](const belief::Field& candidate) { return candidate.name == name; });
  if (field == fields.end()) {
    return "";
  }
  if (const auto* text = std::get_if<std::string>(&field->value)) {
    return *text;
  }
  if (const auto* number = std::get_if<double>(&field->value)) {
    return parameters::numberText(*number);
  }
  if (const auto* count = std::get_if<std::int64_t>(&field->value)) {
    return parameters::numberText(static_cast<double>(*count));
  }
  const auto* flag = std::get_if<bool>(&field->value);
  return flag == nullptr ? "" : *flag ? "1" : "0";
}

void addCells(CsvRow& row, const belief::FieldList& fields, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    row.add(cellOf(fields, name));
  }
}

void addStage(CsvRow& row, const search::SearchResult& result, const char* name) {
  const search::StageReport* stage = search::stageOf(result, name);
  addCells(row, stage != nullptr ? belief::fieldsOf(*stage) : belief::FieldList{},
           {"ratio", "initialization_time", "rotation_expansion_time", "depth_first_search_time"});
}

/// What the exact search says; nothing where it did not run.
void addProof(CsvRow& row, const belief::Answer& answer) {
  const search::StageReport* exact = search::stageOf(answer.search, "exact");
  addCells(row, exact != nullptr ? belief::fieldsOf(answer) : belief::FieldList{},
           {"certified", "hit_ratio", "upper_bound", "margin"});
  row.add(exact != nullptr ? std::optional<double>(exact->time()) : std::nullopt);
}

void addSurroundings(CsvRow& row, const belief::Answer& answer) {
  const belief::FieldList fields = belief::fieldsOf(answer);
  const belief::Evidence* cells = belief::find(answer.evidence, "nearby_ratio");
  const belief::Evidence* walls = belief::find(answer.evidence, "nearby_walls_ratio");
  const auto value_of = [](const belief::Evidence* piece, int count) {
    return piece != nullptr && count > 0 ? std::optional<double>(piece->value) : std::nullopt;
  };
  addCells(row, fields, {"nearby_cells"});
  row.add(value_of(cells, answer.nearby.cells));
  addCells(row, fields, {"nearby_walls"});
  row.add(value_of(walls, answer.nearby.walls));
}

/// All pieces of evidence, "name:bearing" with spaces between them.
std::string evidenceText(const belief::Answer& answer) {
  std::string text;
  for (const belief::Evidence& piece : answer.evidence) {
    text += (text.empty() ? "" : " ") + piece.name + ":" + toString(piece.bearing);
  }
  return text;
}

/// Difference of two poses in the coordinates of the reference map.
std::optional<grid::Rigid2> difference(const std::optional<grid::Rigid2>& estimate,
                                       const std::optional<grid::Rigid2>& truth) {
  if (!estimate || !truth) {
    return std::nullopt;
  }
  return grid::Rigid2{estimate->x - truth->x, estimate->y - truth->y, grid::normalizeAngle(estimate->yaw - truth->yaw)};
}

/// How far the heading in the session map is from the true one: what bends walls that are parallel in truth.
std::optional<double> headingDrift(const TrialQuery& query) {
  if (!query.true_alignment || !query.truth) {
    return std::nullopt;
  }
  return grid::normalizeAngle(query.T_session_base.yaw - (query.true_alignment->inverse() * *query.truth).yaw);
}

constexpr const char* kHeader =
    "session,time,session_age,travelled,status,matched,ratio,search_time,"
    "coarse_ratio,coarse_initialization_time,coarse_rotation_expansion_time,coarse_depth_first_search_time,"
    "fine_ratio,fine_initialization_time,fine_rotation_expansion_time,fine_depth_first_search_time,"
    "certified,hit_ratio,upper_bound,margin,exact_time,"
    "alignment_x,alignment_y,alignment_yaw,alignment_x_error,alignment_y_error,alignment_yaw_error,"
    "heading_drift,estimate_x,estimate_y,estimate_yaw,truth_x,truth_y,truth_yaw,translation_error,rotation_error,"
    "occupied,falsely_occupied,nearby_cells,nearby_ratio,nearby_walls,nearby_walls_ratio,evidence\n";

std::string rowOf(const TrialQuery& query) {
  const belief::Answer& answer = query.answer;
  const std::optional<grid::Rigid2> alignment = query.alignment();
  const std::optional<evaluation::PoseError> error = query.robotError();
  CsvRow row;
  row.add(query.session);
  row.add(query.time);
  row.add(query.session_age);
  row.add(query.travelled);
  const belief::FieldList fields = belief::fieldsOf(answer);
  addCells(row, fields, {"status"});
  row.add(answer.matched() ? 1.0 : 0.0);
  addCells(row, fields, {"ratio", "search_time"});
  addStage(row, answer.search, "coarse");
  addStage(row, answer.search, "fine");
  addProof(row, answer);
  row.add(alignment);
  row.add(difference(alignment, query.true_alignment));
  row.add(headingDrift(query));
  row.add(query.estimate());
  row.add(query.truth);
  row.add(error ? std::optional<double>(error->translation) : std::nullopt);
  row.add(error ? std::optional<double>(error->rotation) : std::nullopt);
  row.add(query.occupied);
  row.add(query.falsely_occupied);
  addSurroundings(row, answer);
  row.add(evidenceText(answer));
  return row.line();
}

}  // namespace

std::string toCsv(const std::vector<TrialQuery>& queries) {
  std::string csv = kHeader;
  for (const TrialQuery& query : queries) {
    csv += rowOf(query);
  }
  return csv;
}

}  // namespace map_matcher::trials
