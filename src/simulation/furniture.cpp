#include "map_matcher/simulation/furniture.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::simulation {
namespace {

constexpr double kChairSpace = 0.85;  // [m] that a chair and who sits on it take in front of a table
constexpr double kLegSize = 0.05;     // [m]

Solid box(double x, double y, double width, double depth, double yaw = 0.0) {
  return {{x, y, yaw}, {0.5 * width, 0.5 * depth}, false};
}

/// A box that reaches into the wall behind it, so that rounding to cells leaves no slit.
Solid boxAtWall(double x, double width, double depth) {
  constexpr double kIntoWall = 0.1;
  return box(x, 0.5 * (depth - kIntoWall), width, depth + kIntoWall);
}

Solid post(double x, double y, double radius) { return {{x, y, 0.0}, {radius, radius}, true}; }

/// A swivel chair near (x, y), turned and moved a little: its foot with five short arms.
void addSwivelChair(std::vector<Solid>& solids, double x, double y, RandomNumbers& random) {
  const grid::Rigid2 foot{x + random.uniform(-0.08, 0.08), y + random.uniform(-0.05, 0.05),
                          random.uniform(-M_PI, M_PI)};
  for (int i = 0; i < 5; ++i) {
    const grid::Rigid2 arm = foot * grid::Rigid2{0.0, 0.0, i * 2.0 * M_PI / 5.0} * grid::Rigid2{0.13, 0.0, 0.0};
    solids.push_back({arm, {0.13, 0.5 * kLegSize}, false});
  }
}

/// A chair on four legs.
void addChair(std::vector<Solid>& solids, double x, double y, RandomNumbers& random) {
  const grid::Rigid2 chair{x + random.uniform(-0.06, 0.06), y + random.uniform(-0.06, 0.06),
                           random.uniform(-0.35, 0.35)};
  for (const double leg_x : {-0.2, 0.2}) {
    for (const double leg_y : {-0.2, 0.2}) {
      solids.push_back({chair * grid::Rigid2{leg_x, leg_y, 0.0}, {0.5 * kLegSize, 0.5 * kLegSize}, false});
    }
  }
}

/// A desk with its back at y = 0 that is worked at from y > 0, or mirrored (`facing` -1): a modesty panel, a drawer
/// unit on one side and a leg on the other.
void addDesk(std::vector<Solid>& solids, double x, double y, double width, double facing, RandomNumbers& random) {
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const double drawers = random.uniform(0.4, 0.48);
  solids.push_back(box(x, y + facing * 0.06, width, 0.04));
  solids.push_back(box(x + side * 0.5 * (width - drawers), y + facing * 0.38, drawers, 0.62));
  solids.push_back(box(x - side * (0.5 * width - 0.03), y + facing * 0.36, 0.05, 0.6));
  addSwivelChair(solids, x - side * 0.15, y + facing * random.uniform(0.75, 0.95), random);
}

}  // namespace

Furniture placed(const Furniture& piece, const grid::Rigid2& T_plan_piece) {
  Furniture result;
  result.is_fixed = piece.is_fixed;
  for (const Solid& solid : piece.solids) {
    result.solids.push_back({T_plan_piece * solid.pose, solid.half_size, solid.is_round});
  }
  const Eigen::Vector2d a = T_plan_piece * Eigen::Vector2d(piece.footprint.x_min, piece.footprint.y_min);
  const Eigen::Vector2d b = T_plan_piece * Eigen::Vector2d(piece.footprint.x_max, piece.footprint.y_max);
  result.footprint = {std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()), std::max(a.y(), b.y())};
  return result;
}

Furniture wallBlock(double width, double depth) {
  return {{boxAtWall(0.0, width, depth)}, {-0.5 * width, 0.0, 0.5 * width, depth}};
}

Furniture deskAtWall(RandomNumbers& random) {
  const double width = random.uniform(1.3, 1.8);
  Furniture piece;
  addDesk(piece.solids, 0.0, 0.0, width, 1.0, random);
  piece.footprint = {-0.5 * width, 0.0, 0.5 * width, 0.55 + kChairSpace};
  return piece;
}

Furniture deskPairFromWall(RandomNumbers& random) {
  // Desks along y, their backs to x = 0.
  const double width = random.uniform(1.4, 1.7);
  const grid::Rigid2 turned{0.0, 0.5 * width, 0.5 * M_PI};
  Furniture piece;
  addDesk(piece.solids, 0.0, 0.0, width, 1.0, random);
  addDesk(piece.solids, 0.0, 0.0, width, -1.0, random);
  piece.footprint = {-0.5 * width, -0.55 - kChairSpace, 0.5 * width, 0.55 + kChairSpace};
  return placed(piece, turned);
}

Furniture kitchenette(RandomNumbers& random) {
  const double width = random.uniform(2.2, 3.2);
  const double refrigerator = random.uniform(0.6, 0.75);
  Furniture piece;
  piece.solids = {boxAtWall(-0.5 * refrigerator, width - refrigerator, 0.6),
                  boxAtWall(0.5 * (width - refrigerator), refrigerator, 0.68)};
  piece.footprint = {-0.5 * width, 0.0, 0.5 * width, 0.7};
  piece.is_fixed = true;
  return piece;
}

Furniture sofa(RandomNumbers& random) {
  const double width = random.uniform(1.5, 2.2);
  Furniture piece = wallBlock(width, random.uniform(0.8, 0.95));
  if (random.chance(0.6)) {
    const double table_y = piece.footprint.y_max + random.uniform(0.55, 0.65);
    const double table_x = random.uniform(-0.2, 0.2);
    piece.solids.push_back(box(table_x, table_y, 0.8, 0.45, random.uniform(-0.15, 0.15)));
    piece.footprint.y_max = table_y + 0.32;
  }
  return piece;
}

Furniture plantAtWall(RandomNumbers& random) {
  const double radius = random.uniform(0.16, 0.24);
  return {{post(0.0, radius, radius)}, {-radius, 0.0, radius, 2.0 * radius}};
}

Furniture doorLeaf(double length, double lean) {
  constexpr double kThickness = 0.04;
  const grid::Rigid2 leaf{0.5 * length * std::sin(lean), 0.5 * length * std::cos(lean), 0.5 * M_PI - lean};
  return {{{leaf, {0.5 * length, 0.5 * kThickness}, false}},
          {std::min(0.0, length * std::sin(lean)), 0.0, std::max(0.0, length * std::sin(lean)), length}};
}

Furniture meetingTable(int chairs_per_side, RandomNumbers& random) {
  const double length = chairs_per_side * random.uniform(0.68, 0.76) + 0.2;
  const double depth = random.uniform(0.9, 1.2);
  Furniture piece;
  for (const double end : {-1.0, 1.0}) {  // two feet under the table
    piece.solids.push_back(box(end * (0.5 * length - 0.35), 0.0, 0.1, 0.6 * depth));
    for (int i = 0; i < chairs_per_side; ++i) {
      const double x = (i + 0.5) * (length - 0.2) / chairs_per_side - 0.5 * (length - 0.2);
      if (random.chance(0.9)) {
        addChair(piece.solids, x, end * (0.5 * depth + random.uniform(0.1, 0.3)), random);
      }
    }
  }
  const double sitting = 0.5 * depth + 0.55;
  piece.footprint = {-0.5 * length, -sitting, 0.5 * length, sitting};
  return piece;
}

Furniture deskCluster(int desks_per_side, RandomNumbers& random) {
  const double width = random.uniform(1.4, 1.65);
  Furniture piece;
  for (int i = 0; i < desks_per_side; ++i) {
    const double x = (i - 0.5 * (desks_per_side - 1)) * width;
    addDesk(piece.solids, x, 0.0, width, 1.0, random);
    addDesk(piece.solids, x, 0.0, width, -1.0, random);
  }
  const double half_length = 0.5 * desks_per_side * width;
  piece.footprint = {-half_length, -0.55 - kChairSpace, half_length, 0.55 + kChairSpace};
  return piece;
}

Furniture roundTable(RandomNumbers& random) {
  const double radius = random.uniform(0.45, 0.6);
  const auto num_stools = 3 + static_cast<int>(random.index(3));
  const double first = random.uniform(0.0, 2.0 * M_PI);
  Furniture piece;
  piece.solids.push_back(post(0.0, 0.0, random.uniform(0.18, 0.25)));
  for (int i = 0; i < num_stools; ++i) {
    const double angle = first + i * 2.0 * M_PI / num_stools;
    piece.solids.push_back(post((radius + 0.15) * std::cos(angle), (radius + 0.15) * std::sin(angle), 0.16));
  }
  const double reach = radius + 0.35;
  piece.footprint = {-reach, -reach, reach, reach};
  return piece;
}

Furniture workbench(RandomNumbers& random) {
  const double length = random.uniform(1.8, 2.8);
  const double depth = random.uniform(0.75, 1.0);
  return {{box(0.0, 0.0, length, depth)}, {-0.5 * length, -0.5 * depth, 0.5 * length, 0.5 * depth}};
}

Furniture pillar(RandomNumbers& random) {
  const double half = random.uniform(0.18, 0.28);
  const Rectangle footprint{-half, -half, half, half};
  return random.chance(0.5) ? Furniture{{post(0.0, 0.0, half)}, footprint, true}
                            : Furniture{{box(0.0, 0.0, 2.0 * half, 2.0 * half)}, footprint, true};
}

}  // namespace map_matcher::simulation
