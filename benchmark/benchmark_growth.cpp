// How the time of a match with proof, runner-up and refinement grows, in generated offices.
//
//   BM_Growth/area/<m^2>          with the area of the reference map: sessions of 4,000 cells at 2 cm
//   BM_Growth/session/<cells>     with the session map: in 55 m x 15 m at 2 cm
//   BM_Growth/resolution/<mm>     with the edge length of a cell: the same drive of 15 m in 55 m x 15 m
//
// scripts/plot_growth draws it. Times are of one thread; the counter `x` is what the time grows with.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "map_matcher/simulation/office_building.hpp"
#include "map_pairs.hpp"

namespace map_matcher {
namespace {

void registerGrowth(const std::string& what, double x, const grid::OccupancyGrid& building,
                    const SimulatedSession& wanted) {
  const auto pair = std::make_shared<const MapPair>(MapPair{what, building, simulateSession(building, wanted)});
  search::SearchOptions options;
  options.threads = 1;
  options.exact_deadline = 60.0;
  const std::string name = "BM_Growth/" + what + "/" + std::to_string(std::lround(x));
  benchmark::RegisterBenchmark(name.c_str(), [pair, options, x](benchmark::State& state) {
    matchPair(state, pair, options);
    state.counters["x"] = x;
  })->Unit(benchmark::kMillisecond);
}

void registerAll() {
  for (const auto& [length, width] : {std::pair(40.0, 15.0), {80.0, 15.0}, {160.0, 15.0}, {160.0, 30.0}}) {
    simulation::OfficeBuildingOptions plan;
    plan.length = length;
    plan.width = width;
    SimulatedSession wanted;
    wanted.num_cells = 4000;
    registerGrowth("area", length * width, simulation::officeBuilding(plan), wanted);
  }
  for (const std::size_t cells : {1000, 2000, 4000, 8000, 13000}) {
    SimulatedSession wanted;
    wanted.num_cells = cells;
    registerGrowth("session", static_cast<double>(cells), simulation::officeBuilding({}), wanted);
  }
  for (const double resolution : {0.1, 0.05, 0.03, 0.02}) {
    simulation::OfficeBuildingOptions plan;
    plan.resolution = resolution;
    SimulatedSession wanted;
    wanted.length = 15.0;
    registerGrowth("resolution", 1e3 * resolution, simulation::officeBuilding(plan), wanted);
  }
}

}  // namespace
}  // namespace map_matcher

int main(int argc, char** argv) {
  map_matcher::registerAll();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
