/// \file
/// What is matched in benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/mapping/session_mapper.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/simulation/drive.hpp"

namespace map_matcher {

/// A reference map and a session map of a part of it.
struct MapPair {
  std::string name;
  grid::OccupancyGrid reference;
  grid::OccupancyGrid session;
};

/// Length and range of a drive.
struct SimulatedSession {
  std::uint64_t seed = 3;
  double length = 1e9;          // [m] that the robot drives at most
  std::size_t num_cells = 1e9;  // walls at most
  double max_range = 12.0;      // [m] 12 m: a session map of about 24 m x 24 m, not one as long as the corridor
};

/// The session map of a drive through a map.
inline grid::OccupancyGrid simulateSession(const grid::OccupancyGrid& map, const SimulatedSession& wanted) {
  simulation::DriveOptions drive_options;
  drive_options.seed = wanted.seed;
  drive_options.lidar.sigma = 0.03;
  const simulation::Drive drive = simulation::simulateDrive(map, drive_options);
  mapping::SessionMapperOptions mapper_options;
  mapper_options.delta = map.resolution();
  mapper_options.max_range = wanted.max_range;
  mapping::SessionMapper mapper(mapper_options);
  double length = 0.0;
  Eigen::Vector2d last = drive.steps.front().T_map_base.translation();
  for (const simulation::DriveStep& step : drive.steps) {
    length += (step.T_map_base.translation() - last).norm();
    last = step.T_map_base.translation();
    const mapping::ScanReport report =
        mapper.addScan(step.time, step.T_odom_base, step.scans.front(), {drive.T_base_lidar.front(), false});
    const bool drawn = report.outcome == mapping::ScanOutcome::kDrawn;
    if (length > wanted.length || (drawn && grid::occupiedCells(*mapper.map()).size() >= wanted.num_cells)) {
      break;
    }
  }
  return *mapper.map();
}

inline void addStage(benchmark::State& state, const search::StageReport& stage) {
  state.counters[stage.name + "_init_ms"] += 1e3 * stage.initialization_time;
  state.counters[stage.name + "_rotations_ms"] += 1e3 * stage.rotation_expansion_time;
  state.counters[stage.name + "_dfs_ms"] += 1e3 * stage.depth_first_search_time;
}

/// Times the match of a pair, split by stage.
inline void matchPair(benchmark::State& state, const std::shared_ptr<const MapPair>& pair,
                      const search::SearchOptions& options) {
  const search::MapMatcher matcher(options);
  const search::Reference reference(pair->reference, options);
  reference.at(pair->session.resolution());  // building it is timed by another benchmark
  search::SearchResult result;
  for (auto _ : state) {
    result = matcher.match(reference, pair->session);
    for (const search::StageReport& stage : result.stages) {
      addStage(state, stage);
    }
  }
  for (auto& [name, counter] : state.counters) {
    counter.value /= static_cast<double>(state.iterations());
  }
  state.counters["session_cells"] = result.total_cells;
  state.counters["ratio"] = result.ratio;
  state.counters["hit_ratio"] = result.hit_ratio;
  state.counters["margin"] = result.margin;
  state.counters["rotations"] = result.stages.empty() ? 0 : result.stages.front().rotations;
  state.SetLabel(result.certified ? "certified" : result.found ? "found" : "nothing found");
}

}  // namespace map_matcher
