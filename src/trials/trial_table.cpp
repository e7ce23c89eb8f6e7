#include "map_matcher/trials/trial_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <variant>

#include "csv_row.hpp"
#include "map_matcher/belief/answer_fields.hpp"

namespace map_matcher::trials {
namespace {

/// A table's cell; empty where nothing is known.
std::string textOf(const belief::Field& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) {
    return *text;
  }
  if (const auto* number = std::get_if<double>(&field.value)) {
    return parameters::numberText(*number);
  }
  if (const auto* count = std::get_if<std::int64_t>(&field.value)) {
    return parameters::numberText(static_cast<double>(*count));
  }
  const auto* flag = std::get_if<bool>(&field.value);
  return flag == nullptr ? "" : *flag ? "1" : "0";
}

/// The cell of what is told of something by a name; empty where it is not known.
std::string cellOf(const belief::FieldList& fields, const std::string& name) {
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&name](const belief::Field& candidate) { return candidate.name == name; });
  return field == fields.end() ? "" : textOf(*field);
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
    "occupied,falsely_occupied,nearby_cells,nearby_ratio,nearby_walls,nearby_walls_ratio,evidence,drive,"
    "candidate_x,candidate_y,candidate_yaw,candidate_error,candidate_rotation_error,candidate_map_error,"
    "candidate_map_rotation_error";

/// Names that a table has columns for, in the order in which they come.
class ColumnNames {
 public:
  void add(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) {
      names_.push_back(name);
    }
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Columns for what the answers tell in numbers, whatever it may be: what is added to an answer needs no line here.
struct ToldColumns {
  explicit ToldColumns(const std::vector<TrialQuery>& queries) {
    for (const belief::Field& field : belief::fieldsOf(belief::Answer{})) {
      addAnswer(field);
    }
    for (const TrialQuery& query : queries) {
      for (const belief::Field& field : belief::fieldsOf(query.answer)) {
        addAnswer(field);
      }
      for (const belief::Evidence& piece : query.answer.evidence) {
        evidence.add(piece.name);
      }
    }
  }

  std::string header() const {
    std::string header;
    for (const std::string& name : answer.names()) {
      header += ",answer." + name;
    }
    for (const std::string& name : evidence.names()) {
      header += ",evidence." + name;
    }
    return header;
  }

  void addTo(CsvRow& row, const belief::Answer& told) const {
    const belief::FieldList fields = belief::fieldsOf(told);
    for (const std::string& name : answer.names()) {
      row.add(cellOf(fields, name));
    }
    for (const std::string& name : evidence.names()) {
      const belief::Evidence* piece = belief::find(told.evidence, name);
      row.add(piece == nullptr || std::isnan(piece->value) ? "" : parameters::numberText(piece->value));
    }
  }

  ColumnNames answer;
  ColumnNames evidence;

 private:
  /// Sentences and poses have columns of their own, or none.
  void addAnswer(const belief::Field& field) {
    if (!std::holds_alternative<std::string>(field.value) && !std::holds_alternative<grid::Rigid2>(field.value) &&
        !std::holds_alternative<std::monostate>(field.value)) {
      answer.add(field.name);
    }
  }
};

void addCandidate(CsvRow& row, const TrialQuery& query) {
  const std::optional<evaluation::PoseError> robot = query.candidateError();
  const std::optional<search::PlaceDifference> map = query.candidateMapError();
  row.add(query.candidate());
  row.add(robot ? std::optional<double>(robot->translation) : std::nullopt);
  row.add(robot ? std::optional<double>(robot->rotation) : std::nullopt);
  row.add(map ? std::optional<double>(map->distance) : std::nullopt);
  row.add(map ? std::optional<double>(map->angle) : std::nullopt);
}

std::string rowOf(const TrialQuery& query, const ToldColumns& columns) {
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
  row.add(query.drive);
  addCandidate(row, query);
  columns.addTo(row, answer);
  return row.line();
}

}  // namespace

std::string toCsv(const std::vector<TrialQuery>& queries) {
  const ToldColumns columns(queries);
  std::string csv = kHeader + columns.header() + "\n";
  for (const TrialQuery& query : queries) {
    csv += rowOf(query, columns);
  }
  return csv;
}

}  // namespace map_matcher::trials
