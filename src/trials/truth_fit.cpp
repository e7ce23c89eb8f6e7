#include "map_matcher/trials/truth_fit.hpp"

#include <cmath>
#include <sstream>

#include "map_matcher/mapping/beams.hpp"

namespace map_matcher::trials {
namespace {

constexpr double kNear = 0.3;    // [m] from a wall
constexpr double kEnough = 0.5;  // share that fits
constexpr int kEvery = 10;       // moments

double shareOf(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 1.0; }

}  // namespace

TruthFit::TruthFit(const grid::OccupancyGrid& reference)
    : geometry_(reference.geometry()), near_walls_(reference, kNear) {}

void TruthFit::add(const TrialMoment& moment) {
  if (moments_++ % kEvery != 0 || !moment.T_reference_base) {
    return;
  }
  ++poses_;
  const grid::Rigid2& T_reference_base = *moment.T_reference_base;
  poses_inside_ += geometry_.contains(geometry_.cellAt(T_reference_base.translation())) ? 1 : 0;
  for (const scan::MountedScan& scan : moment.scans) {
    for (const mapping::Beam& beam : mapping::castBeams(scan.scan, scan.mount, {}).beams) {
      points_ += beam.hit ? 1 : 0;
      points_near_walls_ += beam.hit && near_walls_.isNearWall(T_reference_base * beam.end) ? 1 : 0;
    }
  }
}

std::optional<std::string> TruthFit::problem() const {
  std::ostringstream text;
  if (shareOf(poses_inside_, poses_) < kEnough) {
    text << "only " << poses_inside_ << " of " << poses_ << " true poses that were looked at lie within the map";
  } else if (shareOf(points_near_walls_, points_) < kEnough) {
    text << "at the true poses only " << std::lround(100.0 * shareOf(points_near_walls_, points_))
         << " % of the scans' points lie within " << kNear << " m of a wall of the map";
  } else {
    return std::nullopt;
  }
  text << ", expected most of them: the map may be another building's, or the truth in another frame than the map";
  return text.str();
}

}  // namespace map_matcher::trials
