// How long a match takes, split by its steps (the report's figure 9), and what its kernel does per second.
//
//   BM_Match/synthetic_office          55 m x 15 m at 2 cm, a drive drawn by the session mapper, 13,000 session cells
//   BM_Match/<set>/<case>              recorded sessions, where the evaluation data is there (MAP_MATCHER_DATA)
//   BM_BuildReference/...              what depends only on the reference map
//   BM_ScoreTile/<variant>/<level>     one tile of 512 translations; items are cells x translations
//
// Times are of one core; the counters are the means of the stages' own times [ms].

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
#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/mapping/session_mapper.hpp"
#include "map_matcher/search/map_matcher.hpp"
#include "map_matcher/search/score_kernel.hpp"
#include "map_matcher/search/search_reference.hpp"
#include "map_matcher/simulation/drive.hpp"
#include "map_matcher/simulation/office_building.hpp"

namespace map_matcher {
namespace {

namespace fs = std::filesystem;

/// A reference map and a session map of a part of it.
struct MapPair {
  std::string name;
  OccupancyGrid reference;
  OccupancyGrid session;
};

/// The session map of a drive through a generated office, drawn until it has `num_cells` walls.
MapPair syntheticOffice(std::size_t num_cells) {
  OfficeBuildingOptions building_options;
  const OccupancyGrid building = officeBuilding(building_options);
  DriveOptions drive_options;
  drive_options.seed = 3;
  drive_options.lidar.sigma = 0.03;
  const Drive drive = simulateDrive(building, drive_options);
  SessionMapperOptions mapper_options;
  mapper_options.delta = building.resolution();
  mapper_options.max_range = 12.0;  // a session map of about 24 m x 24 m, not one as long as the corridor
  SessionMapper mapper(mapper_options);
  for (const DriveStep& step : drive.steps) {
    const ScanReport report =
        mapper.addScan(step.T_odom_base, step.scans.front(), {drive.T_base_lidar.front(), false});
    if (report.outcome == ScanOutcome::kDrawn && occupiedCells(*mapper.map()).size() >= num_cells) {
      break;
    }
  }
  return {"synthetic_office", building, *mapper.map()};
}

void addStage(benchmark::State& state, const StageReport& stage) {
  state.counters[stage.name + "_init_ms"] += 1e3 * stage.initialization_time;
  state.counters[stage.name + "_rotations_ms"] += 1e3 * stage.rotation_expansion_time;
  state.counters[stage.name + "_dfs_ms"] += 1e3 * stage.depth_first_search_time;
}

void matchPair(benchmark::State& state, const std::shared_ptr<const MapPair>& pair) {
  MapMatcher matcher;
  matcher.setReference(pair->reference);
  MatchResult result;
  for (auto _ : state) {
    result = matcher.match(pair->session);
    for (const StageReport& stage : result.stages) {
      addStage(state, stage);
    }
  }
  for (auto& [name, counter] : state.counters) {
    counter.value /= static_cast<double>(state.iterations());
  }
  state.counters["session_cells"] = result.total_cells;
  state.counters["ratio"] = result.ratio;
  state.counters["rotations"] = result.stages.empty() ? 0 : result.stages.front().rotations;
  state.SetLabel(toString(result.status));
}

void buildReference(benchmark::State& state, const std::shared_ptr<const MapPair>& pair) {
  for (auto _ : state) {
    const SearchReference reference(pair->reference, pair->reference.resolution(), {});
    benchmark::DoNotOptimize(reference.fine().bytes());
  }
  const SearchReference reference(pair->reference, pair->reference.resolution(), {});
  state.counters["megabytes"] = 1e-6 * static_cast<double>(reference.fine().bytes() + reference.coarse().bytes());
}

void scoreTile(benchmark::State& state) {
  const auto variant = static_cast<KernelVariant>(state.range(0));
  const std::vector<KernelVariant> available = availableKernelVariants();
  if (std::find(available.begin(), available.end(), variant) == available.end()) {
    state.SkipWithError("this processor cannot run the variant");
    return;
  }
  std::mt19937 random(1);
  std::vector<Cell> walls(8000);
  for (Cell& wall : walls) {
    wall = {static_cast<int>(random() % 350), static_cast<int>(random() % 160)};
  }
  const PrecomputedGrids grids(350, 160, walls, 4);
  RotatedCells cells;
  for (int k = 0; k < 1000; ++k) {
    cells.x.push_back(static_cast<std::int16_t>(static_cast<int>(random() % 150) - 75));
    cells.y.push_back(static_cast<std::int16_t>(static_cast<int>(random() % 150) - 75));
  }
  const ScoreKernel kernel(variant);
  TileCounts counts;
  for (auto _ : state) {
    kernel.scoreTile(TileShape::kWide, grids.level(static_cast<int>(state.range(1))), cells, {100, 60}, 0, counts);
    benchmark::DoNotOptimize(counts.data());
  }
  state.SetItemsProcessed(state.iterations() * 1000 * tileColumns(TileShape::kWide) * tileRows(TileShape::kWide));
}
BENCHMARK(scoreTile)->Name("BM_ScoreTile")->ArgsProduct({{0, 1, 2}, {0, 2, 4}})->ArgNames({"variant", "level"});

/// The reference of a recorded session lies in the case or in its set.
fs::path referenceOf(const fs::path& recorded) {
  const fs::path own = recorded / "reference.yaml";
  return fs::exists(own) ? own : recorded.parent_path() / "reference.yaml";
}

void registerPair(MapPair pair) {
  const auto shared = std::make_shared<const MapPair>(std::move(pair));
  const auto match = [shared](benchmark::State& state) { matchPair(state, shared); };
  benchmark::RegisterBenchmark(("BM_Match/" + shared->name).c_str(), match)->Unit(benchmark::kMillisecond);
}

void registerReference(const std::string& name, const MapPair& pair) {
  const auto shared = std::make_shared<const MapPair>(pair);
  const auto build = [shared](benchmark::State& state) { buildReference(state, shared); };
  benchmark::RegisterBenchmark(("BM_BuildReference/" + name).c_str(), build)->Unit(benchmark::kMillisecond);
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
      const MapPair pair{set + "/" + path.filename().string(), loadMap(referenceOf(path).string()),
                         loadMap((path / "session.yaml").string())};
      if (path == recorded.front()) {
        registerReference(set, pair);
      }
      registerPair(pair);
    }
  }
}

}  // namespace
}  // namespace map_matcher

int main(int argc, char** argv) {
  const map_matcher::MapPair office = map_matcher::syntheticOffice(13000);
  map_matcher::registerReference(office.name, office);
  map_matcher::registerPair(office);
  const char* data = std::getenv("MAP_MATCHER_DATA");
  if (data != nullptr) {
    map_matcher::registerRecordedSessions(data);
  } else {
    std::cerr << "MAP_MATCHER_DATA is not set: recorded sessions are left out\n";
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
