#include "map_matcher/simulation/path_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>

namespace map_matcher::simulation {
namespace {

constexpr double kCellSize = 0.1;    // [m] of the planning grid, unless the map's cells are larger
constexpr double kComfort = 0.5;     // [m] more clearance than required is not worth a detour
constexpr float kDiscomfort = 4.0F;  // price of a way at the required clearance, above 1 for a comfortable one
constexpr int kNearestCells = 2;     // [cells] how far a point's nearest cell to stand in may be

/// The straight ones first; each diagonal one lies between those 4 and 3 places before it, as on a circle.
constexpr std::array<grid::Cell, 8> kNeighbours{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
constexpr std::size_t kFirstDiagonal = 4;

/// Cells to go on from, the one with the smallest estimate first, then that with the smallest index. Both are kept in
/// one number: estimates are not negative, and the bits of such floats are in the order of their values.
class OpenCells {
 public:
  bool empty() const { return entries_.empty(); }

  void push(float estimate, std::uint32_t index) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &estimate, sizeof bits);
    entries_.push(std::uint64_t{bits} << 32U | index);
  }

  std::pair<float, std::uint32_t> pop() {
    const std::uint64_t entry = entries_.top();
    entries_.pop();
    const auto bits = static_cast<std::uint32_t>(entry >> 32U);
    float estimate = 0.0F;
    std::memcpy(&estimate, &bits, sizeof estimate);
    return {estimate, static_cast<std::uint32_t>(entry)};
  }

 private:
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> entries_;
};

/// Planning cells that cover the grid.
grid::GridGeometry planningGeometry(const grid::GridGeometry& grid) {
  grid::GridGeometry geometry = grid;
  geometry.resolution = std::max(kCellSize, grid.resolution);
  geometry.width = static_cast<int>(std::ceil(grid.width * grid.resolution / geometry.resolution));
  geometry.height = static_cast<int>(std::ceil(grid.height * grid.resolution / geometry.resolution));
  return geometry;
}

/// Length of the shortest way between two cells where nothing is in the way [cells]: a lower bound of every cost.
float octileDistance(const grid::Cell& a, const grid::Cell& b) {
  const auto dx = static_cast<float>(std::abs(a.x - b.x));
  const auto dy = static_cast<float>(std::abs(a.y - b.y));
  return std::max(dx, dy) + (std::sqrt(2.0F) - 1.0F) * std::min(dx, dy);
}

}  // namespace

PathPlanner::PathPlanner(const World& world, double required_clearance)
    : world_(world), required_clearance_(required_clearance), geometry_(planningGeometry(world.geometry())) {
  if (!std::isfinite(required_clearance) || required_clearance <= 0.0) {
    throw std::invalid_argument("required_clearance is " + std::to_string(required_clearance) +
                                ", expected a positive number of metres");
  }
  measureCosts();
  findPlaces();
}

grid::Cell PathPlanner::cellOf(std::size_t index) const {
  const auto width = static_cast<std::size_t>(geometry_.width);
  return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

void PathPlanner::measureCosts() {
  costs_.assign(static_cast<std::size_t>(geometry_.width) * static_cast<std::size_t>(geometry_.height), 0.0F);
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    const Eigen::Vector2d centre = geometry_.cellCentre(cellOf(i));
    if (world_.isClear(centre, required_clearance_)) {
      const double spare = std::max(0.0, world_.clearance(centre) - required_clearance_);
      const auto lacking = static_cast<float>(std::max(0.0, 1.0 - spare / kComfort));
      costs_[i] = 1.0F + (kDiscomfort - 1.0F) * lacking * lacking;
    }
  }
}

void PathPlanner::findPlaces() {
  cv::Mat1b free(geometry_.height, geometry_.width, std::uint8_t{0});
  std::transform(costs_.begin(), costs_.end(), free.begin(),
                 [](float cost) { return cost > 0.0F ? std::uint8_t{255} : std::uint8_t{0}; });
  cv::Mat1i labels;
  cv::Mat1i statistics;
  cv::Mat1d centroids;
  const int num_labels = cv::connectedComponentsWithStats(free, labels, statistics, centroids, 4);
  int largest = 0;
  int largest_area = 0;
  for (int label = 1; label < num_labels; ++label) {
    if (statistics(label, cv::CC_STAT_AREA) > largest_area) {
      largest = label;
      largest_area = statistics(label, cv::CC_STAT_AREA);
    }
  }
  for (std::size_t i = 0; largest != 0 && i < costs_.size(); ++i) {
    const grid::Cell cell = cellOf(i);
    if (labels(cell.y, cell.x) == largest) {
      places_.push_back(geometry_.cellCentre(cell));
    }
  }
}

std::optional<grid::Cell> PathPlanner::freeCellNear(const Eigen::Vector2d& p_map) const {
  const grid::Cell centre = geometry_.cellAt(p_map);
  std::optional<grid::Cell> nearest;
  // From nearer than the clearance the straight line to the cell is free.
  double nearest_distance = required_clearance_;
  for (int y = centre.y - kNearestCells; y <= centre.y + kNearestCells; ++y) {
    for (int x = centre.x - kNearestCells; x <= centre.x + kNearestCells; ++x) {
      const double distance = (geometry_.cellCentre({x, y}) - p_map).norm();
      if (isFree({x, y}) && distance < nearest_distance) {
        nearest = grid::Cell{x, y};
        nearest_distance = distance;
      }
    }
  }
  return nearest;
}

/// A* from the start to the first goal that is found; `cost_to_go` is a lower bound of the cost from a cell to a goal.
/// The start came from itself.
template <typename IsGoal, typename CostToGo>
PathPlanner::Search PathPlanner::explore(const grid::Cell& start, const IsGoal& is_goal,
                                         const CostToGo& cost_to_go) const {
  std::vector<float> spent(costs_.size(), std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> came_from(costs_.size(), WayField::kNone);
  OpenCells open;
  const auto first = static_cast<std::uint32_t>(indexOf(start));
  spent[first] = 0.0F;
  came_from[first] = first;
  open.push(cost_to_go(start), first);

  while (!open.empty()) {
    const auto [estimate, index] = open.pop();
    const grid::Cell cell = cellOf(index);
    if (estimate > spent[index] + cost_to_go(cell)) {
      continue;  // a cheaper way to this cell was found after the entry was made
    }
    if (is_goal(cell)) {
      return {std::move(came_from), cell};
    }
    const std::array<bool, 8> may_step = stepsFrom(cell);
    for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
      if (!may_step[k]) {
        continue;
      }
      const grid::Cell next{cell.x + kNeighbours[k].x, cell.y + kNeighbours[k].y};
      const auto next_index = static_cast<std::uint32_t>(indexOf(next));
      const float length = k < kFirstDiagonal ? 1.0F : std::sqrt(2.0F);
      const float cost = spent[index] + length * 0.5F * (costs_[index] + costs_[next_index]);
      if (cost < spent[next_index]) {
        spent[next_index] = cost;
        came_from[next_index] = index;
        open.push(cost + cost_to_go(next), next_index);
      }
    }
  }
  return {std::move(came_from), std::nullopt};
}

/// To which of kNeighbours one can go from a cell: a diagonal step must not cut a corner.
std::array<bool, 8> PathPlanner::stepsFrom(const grid::Cell& cell) const {
  std::array<bool, 8> may_step{};
  for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
    const bool is_open = k < kFirstDiagonal || (may_step[k - kFirstDiagonal] && may_step[(k + 1) % kFirstDiagonal]);
    may_step[k] = is_open && isFree({cell.x + kNeighbours[k].x, cell.y + kNeighbours[k].y});
  }
  return may_step;
}

std::optional<Path> PathPlanner::plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) const {
  if (world_.clearance(start) <= 0.0 || !world_.isClear(goal, required_clearance_)) {
    return std::nullopt;
  }
  const std::optional<grid::Cell> first = freeCellNear(start);
  const std::optional<grid::Cell> last = freeCellNear(goal);
  if (!first || !last) {
    return std::nullopt;
  }
  const Search found = explore(
      *first, [&](const grid::Cell& cell) { return cell == *last; },
      [&](const grid::Cell& cell) { return octileDistance(cell, *last); });
  if (!found.reached) {
    return std::nullopt;
  }
  Path path = pathTo(*last, *first, found.came_from);
  path.insert(path.begin(), start);
  path.push_back(goal);
  return path;
}

std::optional<Path> PathPlanner::planToNearest(const Eigen::Vector2d& start,
                                               const std::function<bool(const Eigen::Vector2d&)>& is_goal) const {
  const std::optional<grid::Cell> first = freeCellNear(start);
  if (!first) {
    return std::nullopt;
  }
  const Search found = explore(
      *first, [&](const grid::Cell& cell) { return is_goal(geometry_.cellCentre(cell)); },
      [](const grid::Cell&) { return 0.0F; });
  if (!found.reached) {
    return std::nullopt;
  }
  Path path = pathTo(*found.reached, *first, found.came_from);
  path.insert(path.begin(), start);
  return path;
}

Path PathPlanner::pathTo(const grid::Cell& reached, const grid::Cell& first,
                         const std::vector<std::uint32_t>& came_from) const {
  Path path;
  for (std::size_t index = indexOf(reached); index != indexOf(first); index = came_from[index]) {
    path.push_back(geometry_.cellCentre(cellOf(index)));
  }
  path.push_back(geometry_.cellCentre(first));
  std::reverse(path.begin(), path.end());
  return path;
}

WayField PathPlanner::waysTo(const Eigen::Vector2d& goal) const {
  const std::optional<grid::Cell> last = world_.isClear(goal, required_clearance_) ? freeCellNear(goal) : std::nullopt;
  if (!last) {
    return WayField(geometry_, std::vector<std::uint32_t>(costs_.size(), WayField::kNone));
  }
  // A way costs the same in both directions.
  const Search found = explore(
      *last, [](const grid::Cell&) { return false; }, [](const grid::Cell&) { return 0.0F; });
  return WayField(geometry_, found.came_from);
}

double PathPlanner::coveredArea() const {
  std::vector<bool> covered(costs_.size(), false);
  const auto reach = static_cast<int>(std::ceil(required_clearance_ / geometry_.resolution));
  for (const Eigen::Vector2d& place : places_) {
    const grid::Cell centre = geometry_.cellAt(place);
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const grid::Cell cell{centre.x + x, centre.y + y};
        if (geometry_.contains(cell) && std::hypot(x, y) * geometry_.resolution <= required_clearance_) {
          covered[indexOf(cell)] = true;
        }
      }
    }
  }
  const auto num_covered = static_cast<double>(std::count(covered.begin(), covered.end(), true));
  return num_covered * geometry_.resolution * geometry_.resolution;
}

}  // namespace map_matcher::simulation
