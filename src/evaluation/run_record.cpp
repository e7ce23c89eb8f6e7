#include "map_matcher/evaluation/run_record.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace map_matcher::evaluation {
namespace {

void writePose(std::ostream& out, const std::optional<grid::Rigid2>& pose) {
  if (pose) {
    out << ',' << pose->x << ',' << pose->y << ',' << pose->yaw;
  } else {
    out << ",,,";
  }
}

std::string lineOf(const RunRow& row) {
  std::ostringstream out;
  out << std::setprecision(15) << row.sample.time;
  writePose(out, row.sample.truth);
  writePose(out, row.sample.estimate);
  if (row.sample.estimate) {
    const PoseError error = errorOf(*row.sample.estimate, row.sample.truth);
    out << ',' << error.translation << ',' << error.rotation;
  } else {
    out << ",,";
  }
  writePose(out, row.T_reference_session);
  out << ',';
  if (row.ratio) {
    out << *row.ratio;
  }
  out << '\n';
  return out.str();
}

nlohmann::json jsonOf(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json jsonOf(const std::optional<ErrorStatistics>& statistics) {
  if (!statistics) {
    return nullptr;
  }
  return {{"mean", statistics->mean},
          {"standard_deviation", statistics->standard_deviation},
          {"median", statistics->median},
          {"rms", statistics->rms},
          {"worst", statistics->worst}};
}

}  // namespace

RunRecord::RunRecord(const std::string& csv_path) {
  if (csv_path.empty()) {
    return;
  }
  try {
    file_.emplace(csv_path);
    file_->write(
        "time,truth_x,truth_y,truth_yaw,estimate_x,estimate_y,estimate_yaw,translation_error,rotation_error,"
        "session_x,session_y,session_yaw,ratio\n");
  } catch (const files::OutputFileError& error) {
    throw RunRecordError(error.what());
  }
}

void RunRecord::add(const RunRow& row) {
  samples_.push_back(row.sample);
  if (!file_) {
    return;
  }
  try {
    file_->write(lineOf(row));
  } catch (const files::OutputFileError& error) {
    throw RunRecordError(error.what());
  }
}

void RunRecord::complete() {
  if (!file_) {
    return;
  }
  try {
    file_->commit();
    file_.reset();
  } catch (const files::OutputFileError& error) {
    throw RunRecordError(error.what());
  }
}

std::string toJson(const TrajectoryError& error) {
  const nlohmann::json json = {{"samples", error.samples},
                               {"estimates", error.estimates},
                               {"time_to_first_estimate", jsonOf(error.time_to_first_estimate)},
                               {"worst_time", jsonOf(error.worst_time)},
                               {"translation", jsonOf(error.translation)},
                               {"rotation", jsonOf(error.rotation)}};
  return json.dump(2);
}

void writeSummary(const TrajectoryError& error, const std::string& path) {
  try {
    files::writeFile(path, toJson(error) + '\n');
  } catch (const files::OutputFileError& problem) {
    throw RunRecordError(problem.what());
  }
}

}  // namespace map_matcher::evaluation
