// How long it takes to find a session among floors, and how much memory, with one proof over all of them.
//
//   BM_Floors/<floors>/<drive>    generated floors of 80 m x 25 m at 5 cm; a drive of 30 m in one of them, of which
//                                 another one is a copy but for the furniture (from 3 floors on)
//
// Counters: `right`, whether the floor and the place are; `certified`; `margin`; `memory_MB`, of the process at its
// largest so far.

#include <sys/resource.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "map_matcher/belief/single_match.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "map_pairs.hpp"

namespace map_matcher {
namespace {

constexpr double kLengthOfDrive = 30.0;  // [m]
constexpr double kDeadline = 60.0;       // [s]

/// Floors, and the session map of a drive that begins at the origin of its frame on one of them.
struct Floors {
  std::vector<std::unique_ptr<search::Reference>> references;
  belief::ReferenceMaps maps;
  std::size_t right = 0;  // the number of the floor that was driven on
  std::vector<grid::OccupancyGrid> session;
  grid::Rigid2 T_map_session;  // the truth
};

simulation::OfficeBuildingOptions planOf(std::uint64_t seed) {
  simulation::OfficeBuildingOptions plan;
  plan.seed = seed;
  plan.resolution = 0.05;
  plan.length = 80.0;
  plan.width = 25.0;
  return plan;
}

std::shared_ptr<Floors> floors(std::size_t number, std::uint64_t drive_seed, const belief::MatchOptions& options) {
  auto all = std::make_shared<Floors>();
  all->right = number / 2;
  for (std::size_t k = 0; k < number; ++k) {
    simulation::OfficeBuildingOptions plan = planOf(k + 1);
    if (k == all->right + 1) {
      plan.seed = all->right + 1;
      plan.furniture_seed = 1000;
    }
    all->references.push_back(std::make_unique<search::Reference>(simulation::officeBuilding(plan), options.search));
    all->maps.push_back(all->references.back().get());
  }
  const grid::OccupancyGrid& driven = all->references[all->right]->grid();
  const SimulatedSession wanted{drive_seed, kLengthOfDrive};
  all->session.push_back(simulateSession(driven, wanted));
  simulation::DriveOptions drive;
  drive.seed = drive_seed;
  drive.lidar.sigma = 0.03;
  all->T_map_session = simulation::simulateDrive(driven, drive).steps.front().T_map_base;
  return all;
}

double memoryInMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // [kB] on Linux
}

void registerFloors(std::size_t number, std::uint64_t drive_seed) {
  belief::MatchOptions options;
  options.search.exact_deadline = kDeadline;
  const std::string name = "BM_Floors/" + std::to_string(number) + "/" + std::to_string(drive_seed);
  const auto find = [number, drive_seed, options](benchmark::State& state) {
    const std::shared_ptr<Floors> all = floors(number, drive_seed, options);
    for (const search::Reference* map : all->maps) {
      map->at(all->session.front().resolution());  // what depends on the reference maps alone is built at their arrival
      map->seen();
    }
    belief::Answer answer;
    for (auto _ : state) {
      answer = belief::matchAlone(all->maps, all->session.front(), options);
    }
    const search::PlaceDifference error =
        search::difference(answer.search.T_reference_session, all->T_map_session, answer.search.session_centre);
    state.counters["right"] = answer.map == all->right && error.distance < 0.5 ? 1.0 : 0.0;
    state.counters["certified"] = answer.search.certified ? 1.0 : 0.0;
    state.counters["margin"] = answer.search.margin;
    state.counters["memory_MB"] = memoryInMegabytes();
    state.SetLabel(toString(answer.status));
  };
  benchmark::RegisterBenchmark(name.c_str(), find)->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace
}  // namespace map_matcher

int main(int argc, char** argv) {
  for (const std::size_t number : {1, 10, 50}) {
    for (const std::uint64_t drive_seed : {1, 2, 3, 4, 5}) {
      map_matcher::registerFloors(number, drive_seed);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
