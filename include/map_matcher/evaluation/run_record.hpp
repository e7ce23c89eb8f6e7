/// \file
/// What happened in a run, written down while it runs.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "map_matcher/evaluation/trajectory_error.hpp"
#include "map_matcher/files/output_file.hpp"

namespace map_matcher::evaluation {

/// A file of a run that cannot be written; the message names it.
class RunRecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One moment of a run.
struct RunRow {
  PoseSample sample;                                ///< Truth and estimate in the reference map frame.
  std::optional<grid::Rigid2> T_reference_session;  ///< The alignment of the maps at that time (report figure 10b).
  std::optional<double> ratio;  ///< Share of matched cells of the latest match [0 to 1] (figure 10a).
};

/// Keeps the samples of a run, and writes each of its moments into a CSV file as it comes, with a header line:
/// time,truth_x,truth_y,truth_yaw,estimate_x,estimate_y,estimate_yaw,translation_error,rotation_error,
/// session_x,session_y,session_yaw,ratio (s, m, rad; what is not known is empty). Until the run is complete the file
/// has the name of a pending OutputFile, "NAME.partial".
class RunRecord {
 public:
  /// Begins the file; an empty path writes none. Throws RunRecordError.
  explicit RunRecord(const std::string& csv_path = "");

  /// Throws RunRecordError when the row cannot be written.
  void add(const RunRow& row);

  /// Ends the file and gives it its name, in the place of the file of an earlier run. No row may follow. Throws
  /// RunRecordError.
  void complete();

  const std::vector<PoseSample>& samples() const { return samples_; }

 private:
  std::optional<files::OutputFile> file_;
  std::vector<PoseSample> samples_;
};

/// The figures of a run as JSON: samples, estimates, time_to_first_estimate, worst_time [s], translation [m] and
/// rotation [rad] with mean, standard_deviation, median, rms, worst; null where there was no estimate.
std::string toJson(const TrajectoryError& error);

/// Writes toJson() into a file. Throws RunRecordError.
void writeSummary(const TrajectoryError& error, const std::string& path);

}  // namespace map_matcher::evaluation
