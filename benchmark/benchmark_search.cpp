// How long a match takes, split by its steps (the report's figure 9), and what its kernel does per second.
//
//   BM_TwoStages/synthetic_office      55 m x 15 m at 2 cm, a drive drawn by the session mapper, 13,000 session cells
//   BM_TwoStages/<set>/<case>          recorded sessions, where the evaluation data is there (MAP_MATCHER_DATA)
//   BM_Certified/<pair>/<threads>      the same and others with proof, runner-up and refinement:
//     willow, campus                     simulated drives of 15 m and 30 m in these maps
//     stranger_in_intel                  a recorded session of another building
//   BM_BuildReference/<pair>           what depends only on the reference map
//   BM_ScoreTile/<variant>/<level>     one tile of 512 translations; items are cells x translations
//
// Times of BM_TwoStages are of one core; the counters are the means of the stages' own times [ms].

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/grid/map_file.hpp"
#include "map_matcher/search/counting/score_kernel.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/simulation/office_building.hpp"
#include "map_pairs.hpp"

namespace map_matcher {
namespace {

namespace fs = std::filesystem;

/// The session map of a drive through a generated office, drawn until it has `num_cells` walls.
MapPair syntheticOffice(std::size_t num_cells) {
  const grid::OccupancyGrid building = simulation::officeBuilding({});
  SimulatedSession wanted;
  wanted.num_cells = num_cells;
  return {"synthetic_office", building, simulateSession(building, wanted)};
}

void buildReference(benchmark::State& state, const std::shared_ptr<const MapPair>& pair) {
  for (auto _ : state) {
    const search::SearchReference reference(pair->reference, pair->reference.resolution(), {});
    benchmark::DoNotOptimize(reference.fine().bytes());
  }
  const search::SearchReference reference(pair->reference, pair->reference.resolution(), {});
  state.counters["two_stages_megabytes"] =
      1e-6 * static_cast<double>(reference.fine().bytes() + reference.coarse().bytes());
  state.counters["exact_megabytes"] = 1e-6 * static_cast<double>(reference.exact().bytes() + reference.walls().bytes());
}

void scoreTile(benchmark::State& state) {
  const auto variant = static_cast<search::KernelVariant>(state.range(0));
  const std::vector<search::KernelVariant> available = search::availableKernelVariants();
  if (std::find(available.begin(), available.end(), variant) == available.end()) {
    state.SkipWithError("this processor cannot run the variant");
    return;
  }
  std::mt19937 random(1);
  std::vector<grid::Cell> walls(8000);
  for (grid::Cell& wall : walls) {
    wall = {static_cast<int>(random() % 350), static_cast<int>(random() % 160)};
  }
  const search::PrecomputedGrids grids(350, 160, walls, 4);
  search::RotatedCells cells;
  for (int k = 0; k < 1000; ++k) {
    cells.x.push_back(static_cast<std::int16_t>(static_cast<int>(random() % 150) - 75));
    cells.y.push_back(static_cast<std::int16_t>(static_cast<int>(random() % 150) - 75));
  }
  const search::ScoreKernel kernel(variant);
  std::vector<search::TileScore> scores;
  for (auto _ : state) {
    kernel.scoreTile(grids.level(static_cast<int>(state.range(1))), cells, {100, 60}, {}, 900, scores);
    benchmark::DoNotOptimize(scores.data());
  }
  state.SetItemsProcessed(state.iterations() * 1000 * search::kTileColumns * search::kTileRows);
}

void registerKernels() {
  for (const int variant : {0, 1, 2}) {
    for (const int level : {0, 2, 4}) {
      benchmark::RegisterBenchmark("BM_ScoreTile", scoreTile)->Args({variant, level})->ArgNames({"variant", "level"});
    }
  }
}

/// The reference of a recorded session lies in the case or in its set.
fs::path referenceOf(const fs::path& recorded) {
  const fs::path own = recorded / "reference.yaml";
  return fs::exists(own) ? own : recorded.parent_path() / "reference.yaml";
}

using SharedPair = std::shared_ptr<const MapPair>;

void registerTwoStages(const SharedPair& pair) {
  search::SearchOptions options;
  options.search = "two_stage";
  options.threads = 1;
  const auto match = [pair, options](benchmark::State& state) { matchPair(state, pair, options); };
  benchmark::RegisterBenchmark(("BM_TwoStages/" + pair->name).c_str(), match)->Unit(benchmark::kMillisecond);
}

void registerCertified(const SharedPair& pair) {
  for (const int threads : {1, 2}) {
    search::SearchOptions options;
    options.threads = threads;
    options.exact_deadline = 60.0;
    const auto match = [pair, options](benchmark::State& state) { matchPair(state, pair, options); };
    benchmark::RegisterBenchmark(("BM_Certified/" + pair->name + "/" + std::to_string(threads)).c_str(), match)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  }
}

void registerReference(const std::string& name, const SharedPair& pair) {
  const auto build = [pair](benchmark::State& state) { buildReference(state, pair); };
  benchmark::RegisterBenchmark(("BM_BuildReference/" + name).c_str(), build)->Unit(benchmark::kMillisecond);
}

void registerAll(const std::string& reference_name, MapPair pair) {
  const auto shared = std::make_shared<const MapPair>(std::move(pair));
  registerReference(reference_name, shared);
  registerTwoStages(shared);
  registerCertified(shared);
}

/// Drives through maps at hand, and a session map in a map that it does not belong to.
void registerOtherMaps(const fs::path& data) {
  const grid::OccupancyGrid willow = grid::loadMap((data / "maps/willow-full-0.05.yaml").string());
  registerAll("willow", {"willow", willow, simulateSession(willow, {3, 15.0})});
  const grid::OccupancyGrid campus = grid::loadMap((data / "maps/freiburg-campus.yaml").string());
  registerAll("campus", {"campus", campus, simulateSession(campus, {3, 30.0, 1000000, 30.0})});
  registerCertified(std::make_shared<const MapPair>(
      MapPair{"stranger_in_intel", grid::loadMap((data / "maps/intel.yaml").string()),
              grid::loadMap((data / "sessions/freiburg-101-4m/07/session.yaml").string())}));
}

void registerRecordedSessions(const fs::path& data) {
  for (const std::string set : {"asl_office_d0", "asl_office_d0.3", "intel", "wean"}) {
    std::vector<fs::path> recorded;
    for (const auto& entry : fs::directory_iterator(data / "sessions" / set)) {
      if (entry.is_directory()) {
        recorded.push_back(entry.path());
      }
    }
    std::sort(recorded.begin(), recorded.end());
    for (const fs::path& path : recorded) {
      const auto pair = std::make_shared<const MapPair>(MapPair{set + "/" + path.filename().string(),
                                                                grid::loadMap(referenceOf(path).string()),
                                                                grid::loadMap((path / "session.yaml").string())});
      if (path == recorded.front()) {
        registerReference(set, pair);
      }
      registerTwoStages(pair);
      registerCertified(pair);
    }
  }
}

}  // namespace
}  // namespace map_matcher

int main(int argc, char** argv) {
  map_matcher::registerKernels();
  map_matcher::registerAll("synthetic_office", map_matcher::syntheticOffice(13000));
  const char* data = std::getenv("MAP_MATCHER_DATA");
  if (data != nullptr) {
    map_matcher::registerRecordedSessions(data);
    map_matcher::registerOtherMaps(data);
  } else {
    std::cerr << "MAP_MATCHER_DATA is not set: recorded sessions are left out\n";
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
