#include "map_matcher/trials/monte_carlo_trial.hpp"

#include <ctime>

#include "csv_row.hpp"

namespace map_matcher::trials {
namespace {

/// Of this process [s]; for reports only: no decision depends on it.
double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

MonteCarloTrial::MonteCarloTrial(const grid::OccupancyGrid& reference, const localization::MonteCarloOptions& options)
    : localizer_(reference, options) {}

void MonteCarloTrial::add(const TrialMoment& moment) {
  if (session_ && *session_ != moment.session) {
    localizer_.reset();
    updates_ = 0;
    update_time_ = 0.0;
  }
  session_ = moment.session;
  const double start = processorTime();
  if (localizer_.add(moment.T_odom_base, moment.scans)) {
    ++updates_;
    update_time_ += processorTime() - start;
  }
  if (!moment.queried) {
    return;
  }
  MonteCarloRow row{
      moment.time, moment.session,         moment.session_age, moment.travelled, localizer_.estimate(), updates_,
      {},          moment.T_reference_base};
  if (updates_ > 0) {
    row.update_time = update_time_ / updates_;
  }
  rows_.push_back(row);
  updates_ = 0;
  update_time_ = 0.0;
}

std::string toCsv(const std::vector<MonteCarloRow>& rows) {
  std::string csv =
      "session,time,session_age,travelled,estimate_x,estimate_y,estimate_yaw,position_deviation,yaw_deviation,"
      "particles,updates,update_time,truth_x,truth_y,truth_yaw,translation_error,rotation_error\n";
  for (const MonteCarloRow& row : rows) {
    const localization::MonteCarloEstimate& estimate = row.estimate;
    std::optional<evaluation::PoseError> error;
    if (row.truth) {
      error = evaluation::errorOf(estimate.T_map_base, *row.truth);
    }
    CsvRow cells;
    cells.add(row.session);
    cells.add(row.time);
    cells.add(row.session_age);
    cells.add(row.travelled);
    cells.add(std::optional<grid::Rigid2>(estimate.T_map_base));
    cells.add(estimate.position_deviation);
    cells.add(estimate.yaw_deviation);
    cells.add(estimate.particles);
    cells.add(row.updates);
    cells.add(row.update_time);
    cells.add(row.truth);
    cells.add(error ? std::optional<double>(error->translation) : std::nullopt);
    cells.add(error ? std::optional<double>(error->rotation) : std::nullopt);
    csv += cells.line();
  }
  return csv;
}

}  // namespace map_matcher::trials
