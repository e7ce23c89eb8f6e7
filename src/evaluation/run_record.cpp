#include "map_matcher/evaluation/run_record.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>

namespace map_matcher {
namespace {

void writePose(std::ostream& out, const std::optional<Rigid2>& pose) {
  if (pose) {
    out << ',' << pose->x << ',' << pose->y << ',' << pose->yaw;
  } else {
    out << ",,,";
  }
}

nlohmann::ordered_json jsonOf(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json jsonOf(const std::optional<ErrorStatistics>& statistics) {
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

RunRecord::RunRecord(const std::string& csv_path) : path_(csv_path) {
  if (path_.empty()) {
    return;
  }
  file_.open(path_);
  file_ << "time,truth_x,truth_y,truth_yaw,estimate_x,estimate_y,estimate_yaw,translation_error,rotation_error,"
           "session_x,session_y,session_yaw,ratio\n"
        << std::setprecision(15);
  if (!file_.flush()) {
    throw RunRecordError("file '" + path_ + "' cannot be written");
  }
}

void RunRecord::add(const RunRow& row) {
  samples_.push_back(row.sample);
  if (path_.empty()) {
    return;
  }
  file_ << row.sample.time;
  writePose(file_, row.sample.truth);
  writePose(file_, row.sample.estimate);
  if (row.sample.estimate) {
    const PoseError error = errorOf(*row.sample.estimate, row.sample.truth);
    file_ << ',' << error.translation << ',' << error.rotation;
  } else {
    file_ << ",,";
  }
  writePose(file_, row.T_reference_session);
  file_ << ',';
  if (row.ratio) {
    file_ << *row.ratio;
  }
  file_ << '\n';
  if (!file_.flush()) {
    throw RunRecordError("file '" + path_ + "' cannot be written");
  }
}

std::string toJson(const TrajectoryError& error) {
  const nlohmann::ordered_json json = {{"samples", error.samples},
                                       {"estimates", error.estimates},
                                       {"time_to_first_estimate", jsonOf(error.time_to_first_estimate)},
                                       {"worst_time", jsonOf(error.worst_time)},
                                       {"translation", jsonOf(error.translation)},
                                       {"rotation", jsonOf(error.rotation)}};
  return json.dump(2);
}

void writeSummary(const TrajectoryError& error, const std::string& path) {
  std::ofstream file(path);
  file << toJson(error) << '\n';
  if (!file.flush()) {
    throw RunRecordError("file '" + path + "' cannot be written");
  }
}

}  // namespace map_matcher
