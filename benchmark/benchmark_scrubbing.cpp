// How long a scan takes to scrub: finding the beams near people, which is all that the lidar_scrubber adds to a scan
// besides its copy.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "map_matcher/scrubbing/scan_scrubber.hpp"

namespace {

namespace scan = map_matcher::scan;
namespace scrubbing = map_matcher::scrubbing;

constexpr double kRangeMax = 20.0;  // [m]

/// A field of view of 270 degrees, as the SICK TiM571's.
scan::ScanLayout layoutOf(int beams) { return {-0.75 * M_PI, 1.5 * M_PI / (beams - 1), 0.05, kRangeMax}; }

std::vector<float> randomRanges(int beams, std::mt19937& random) {
  std::uniform_real_distribution<float> range(0.5F, 12.0F);
  std::vector<float> ranges;
  for (int i = 0; i < beams; ++i) {
    ranges.push_back(range(random));
  }
  return ranges;
}

/// People in a crowd: within a few metres of the robot, some so near that half of the scan is theirs.
std::vector<scrubbing::Disc> crowd(int people, std::mt19937& random) {
  std::uniform_real_distribution<double> distance(0.35, 8.0);
  std::uniform_real_distribution<double> direction(-M_PI, M_PI);
  std::vector<scrubbing::Disc> discs;
  for (int i = 0; i < people; ++i) {
    const double r = distance(random);
    const double angle = direction(random);
    discs.push_back({{r * std::cos(angle), r * std::sin(angle)}, 0.3});
  }
  return discs;
}

void BM_BeamsInside(benchmark::State& state) {
  std::mt19937 random;
  const auto beams = static_cast<int>(state.range(0));
  const scan::ScanLayout layout = layoutOf(beams);
  const std::vector<float> ranges = randomRanges(beams, random);
  const std::vector<scrubbing::Disc> discs = crowd(static_cast<int>(state.range(1)), random);
  scrubbing::ScanScrubber scrubber;
  for (auto _ : state) {
    benchmark::DoNotOptimize(scrubber.beamsInside(layout, ranges, discs).data());
  }
}
BENCHMARK(BM_BeamsInside)
    ->ArgNames({"beams", "people"})
    ->Args({811, 0})
    ->Args({811, 30})
    ->Args({811, 150})
    ->Args({8192, 200})
    ->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
