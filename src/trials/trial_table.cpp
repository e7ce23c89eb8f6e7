#include "map_matcher/trials/trial_table.hpp"

#include <optional>

#include "csv_row.hpp"

namespace map_matcher::trials {
namespace {

const search::StageReport* stageOf(const search::MatchResult& result, const std::string& name) {
  for (const search::StageReport& stage : result.stages) {
    if (stage.name == name) {
      return &stage;
    }
  }
  return nullptr;
}

void addStage(CsvRow& row, const search::StageReport* stage) {
  const auto value = [stage](double search::StageReport::*field) {
    return stage != nullptr ? std::optional<double>(stage->*field) : std::nullopt;
  };
  row.add(value(&search::StageReport::ratio));
  row.add(value(&search::StageReport::initialization_time));
  row.add(value(&search::StageReport::rotation_expansion_time));
  row.add(value(&search::StageReport::depth_first_search_time));
}

/// What the exact search says; nothing where it did not run.
void addProof(CsvRow& row, const search::MatchResult& result) {
  const search::StageReport* exact = stageOf(result, "exact");
  const auto known = [exact](double value) { return exact != nullptr ? std::optional<double>(value) : std::nullopt; };
  row.add(known(result.certified ? 1.0 : 0.0));
  row.add(known(result.hit_ratio));
  row.add(known(result.upper_bound));
  row.add(known(result.margin));
  row.add(exact != nullptr ? std::optional<double>(exact->initialization_time + exact->rotation_expansion_time +
                                                   exact->depth_first_search_time)
                           : std::nullopt);
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
    "occupied,falsely_occupied,nearby_cells,nearby_ratio,nearby_walls,nearby_walls_ratio\n";

std::string rowOf(const TrialQuery& query) {
  const search::MatchResult& result = query.result;
  const std::optional<grid::Rigid2> alignment = query.alignment();
  const std::optional<evaluation::PoseError> error = query.robotError();
  CsvRow row;
  row.add(query.session);
  row.add(query.time);
  row.add(query.session_age);
  row.add(query.travelled);
  row.add(std::string(toString(result.status)));
  row.add(result.matched() ? 1.0 : 0.0);
  row.add(result.ratio);
  row.add(result.search_time);
  addStage(row, stageOf(result, "coarse"));
  addStage(row, stageOf(result, "fine"));
  addProof(row, result);
  row.add(alignment);
  row.add(difference(alignment, query.true_alignment));
  row.add(headingDrift(query));
  row.add(query.estimate());
  row.add(query.truth);
  row.add(error ? std::optional<double>(error->translation) : std::nullopt);
  row.add(error ? std::optional<double>(error->rotation) : std::nullopt);
  row.add(query.occupied);
  row.add(query.falsely_occupied);
  row.add(result.nearby.cells);
  row.add(result.nearby.cells > 0 ? std::optional<double>(result.nearby.ratio) : std::nullopt);
  row.add(result.nearby.walls);
  row.add(result.nearby.walls > 0 ? std::optional<double>(result.nearby.walls_ratio) : std::nullopt);
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
