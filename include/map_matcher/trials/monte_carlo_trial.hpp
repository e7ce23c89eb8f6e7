/// \file
/// What Monte-Carlo localization makes of the drive that a trial takes through mapper and matcher.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map_matcher/localization/monte_carlo_localizer.hpp"
#include "map_matcher/trials/trial.hpp"

namespace map_matcher::trials {

/// The estimate at the moment of a map query.
struct MonteCarloRow {
  double time = 0.0;                          ///< [s]
  int session = 0;                            ///< As of the trial: the filter starts anew with each session.
  double session_age = 0.0;                   ///< Since the session's first scan [s].
  double travelled = 0.0;                     ///< In the session, by odometry [m].
  localization::MonteCarloEstimate estimate;  ///< In the reference map.
  int updates = 0;                            ///< How often the particles were weighed since the row before.
  std::optional<double> update_time;          ///< Processor time that one of them took on average [s]; none: no update.
  std::optional<grid::Rigid2> truth;          ///< T_reference_base, where it is known.
};

/// A filter beside a trial: it gets the same scans, scrubbed if the mapper's are, and the same odometry. It starts
/// without a pose, and so again with each session. Neither copied nor moved; not thread-safe.
class MonteCarloTrial {
 public:
  /// Throws as MonteCarloLocalizer does.
  MonteCarloTrial(const grid::OccupancyGrid& reference, const localization::MonteCarloOptions& options);

  /// The moments of the trial, in their order.
  void add(const TrialMoment& moment);

  const std::vector<MonteCarloRow>& rows() const { return rows_; }

 private:
  localization::MonteCarloLocalizer localizer_;
  std::optional<int> session_;
  int updates_ = 0;           // since the last row
  double update_time_ = 0.0;  // of all of them [s]
  std::vector<MonteCarloRow> rows_;
};

/// The rows as CSV with a header line: session, time, session_age, travelled; estimate_x, _y, _yaw, position_deviation,
/// yaw_deviation, particles; updates and update_time; the true pose and the error. Units are s, m and rad; what is not
/// known is empty.
std::string toCsv(const std::vector<MonteCarloRow>& rows);

}  // namespace map_matcher::trials
