#include "map_matcher/belief/answer_fields.hpp"

#include <cmath>
#include <optional>

namespace map_matcher::belief {
namespace {

using Value = decltype(Field::value);

Value known(double value) { return std::isnan(value) ? Value() : Value(value); }

Value known(const std::optional<grid::Rigid2>& pose) { return pose ? Value(*pose) : Value(); }

Value count(std::int64_t value) { return value; }

void addPlaces(FieldList& fields, const Answer& answer) {
  const search::SearchResult& search = answer.search;
  const double candidate_ratio = search.hit_cells > 0 ? search.hit_ratio : search.ratio;
  fields.push_back({"transform", known(answer.alignment())});
  fields.push_back({"candidate", search.found ? Value(search.T_reference_session) : Value()});
  fields.push_back({"candidate_ratio", search.found ? Value(candidate_ratio) : Value()});
  fields.push_back({"searched", known(search.searched)});
  fields.push_back({"runner_up", search.runner_up ? Value(search.runner_up->T_reference_session) : Value()});
  fields.push_back({"runner_up_ratio", search.runner_up ? Value(search.runner_up->ratio) : Value()});
}

}  // namespace

FieldList fieldsOf(const Answer& answer) {
  const search::SearchResult& search = answer.search;
  FieldList fields{{"status", std::string(toString(answer.status))}, {"reason", answer.reason}};
  addPlaces(fields, answer);
  const FieldList others{{"refined", search.refined},
                         {"ratio", search.ratio},
                         {"matched_cells", count(search.matched_cells)},
                         {"total_cells", count(search.total_cells)},
                         {"exact", search.exact},
                         {"certified", search.certified},
                         {"replaced", search.replaced},
                         {"hit_ratio", search.hit_ratio},
                         {"hit_cells", count(search.hit_cells)},
                         {"upper_bound", search.upper_bound},
                         {"runner_up_proven", search.runner_up_proven},
                         {"margin", search.margin},
                         {"probability", search.exact ? Value(answer.probability) : Value()},
                         {"nearby_cells", count(answer.nearby.cells)},
                         {"nearby_walls", count(answer.nearby.walls)},
                         {"search_time", search.search_time},
                         {"reference_time", search.reference_time}};
  fields.insert(fields.end(), others.begin(), others.end());
  return fields;
}

FieldList fieldsOf(const search::StageReport& stage) {
  return {{"name", stage.name},
          {"answered", stage.answered},
          {"resolution", stage.resolution},
          {"rotations", count(stage.rotations)},
          {"rotation_step", stage.rotation_step},
          {"matched_cells", count(stage.matched_cells)},
          {"total_cells", count(stage.total_cells)},
          {"ratio", stage.ratio},
          {"nodes_scored", count(stage.nodes_scored)},
          {"nodes_expanded", count(stage.nodes_expanded)},
          {"initialization_time", stage.initialization_time},
          {"rotation_expansion_time", stage.rotation_expansion_time},
          {"depth_first_search_time", stage.depth_first_search_time}};
}

FieldList fieldsOf(const Evidence& evidence) {
  return {{"name", evidence.name},
          {"value", known(evidence.value)},
          {"limit", known(evidence.limit)},
          {"bearing", std::string(toString(evidence.bearing))},
          {"text", evidence.text}};
}

}  // namespace map_matcher::belief
