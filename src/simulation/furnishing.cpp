#include "map_matcher/simulation/furnishing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher {
namespace {

constexpr std::uint64_t kFurnitureStream = 2;  // of the seed
constexpr double kPassage = 0.85;              // [m] between pieces in a room
constexpr double kCorridorPassage = 1.35;      // [m] between pieces in a corridor
constexpr int kTrials = 60;                    // places tried for a piece
constexpr double kTouch = 1e-6;                // [m] nearer is touching

enum class Side { kBottom, kRight, kTop, kLeft };

/// Furnishes one space. Every place* function tries some random places, leaves the piece out when none is free,
/// and tells which.
class Furnisher {
 public:
  Furnisher(const Rectangle& floor, std::vector<Rectangle> kept_free, double passage, RandomNumbers& random)
      : kept_free_(std::move(kept_free)), passage_(passage), random_(random) {
    space_.floor = floor;
  }

  bool placeAtWall(const Furniture& piece, const std::vector<Side>& sides) {
    for (int i = 0; i < kTrials; ++i) {
      if (add(placed(piece, randomPoseAtWall(piece, sides[random_.index(sides.size())])))) {
        return true;
      }
    }
    return false;
  }

  bool placeAtAnyWall(const Furniture& piece) {
    return placeAtWall(piece, {Side::kBottom, Side::kRight, Side::kTop, Side::kLeft});
  }

  bool placeFree(const Furniture& piece) {
    const Rectangle& floor = space_.floor;
    for (int i = 0; i < kTrials; ++i) {
      const double yaw = random_.chance(0.5) ? 0.5 * M_PI : 0.0;
      const double x = random_.uniform(floor.x_min, floor.x_max);
      const double y = random_.uniform(floor.y_min, floor.y_max);
      if (add(placed(piece, {x, y, yaw}))) {
        return true;
      }
    }
    return false;
  }

  /// Stands a door's leaf open on this side of it, when it is in nobody's way there.
  void placeDoorLeaf(const Door& door) {
    const int across = door.in_wall_along_x ? 1 : 0;
    const bool is_beyond = space_.floor.centre()[across] < door.centre[across];
    const double yaw = (door.in_wall_along_x ? 0.0 : -0.5 * M_PI) + (is_beyond ? M_PI : 0.0);
    const Rigid2 T_plan_door{door.centre.x(), door.centre.y(), normalizeAngle(yaw)};
    const double jamb = random_.chance(0.5) ? 0.5 : -0.5;
    Furniture leaf = placed(doorLeaf(door.width - 0.05, std::copysign(random_.uniform(0.05, 0.5), jamb)),
                            T_plan_door * Rigid2{jamb * door.width, 0.0, 0.0});
    if (isClear(leaf.footprint)) {
      space_.pieces.push_back(std::move(leaf));
    }
  }

  RandomNumbers& random() { return random_; }
  const Rectangle& floor() const { return space_.floor; }
  FurnishedSpace take() { return std::move(space_); }

 private:
  Rigid2 randomPoseAtWall(const Furniture& piece, Side side) {
    const Rectangle& floor = space_.floor;
    const bool along_x = side == Side::kBottom || side == Side::kTop;
    const double low = (along_x ? floor.x_min : floor.y_min) + 0.5 * piece.footprint.width();
    const double high = (along_x ? floor.x_max : floor.y_max) - 0.5 * piece.footprint.width();
    const double corner = random_.uniform();
    const double along = corner < 0.25 ? low : corner < 0.5 ? high : random_.uniform(low, std::max(low, high));
    switch (side) {
      case Side::kBottom:
        return {along, floor.y_min, 0.0};
      case Side::kRight:
        return {floor.x_max, along, 0.5 * M_PI};
      case Side::kTop:
        return {along, floor.y_max, M_PI};
      case Side::kLeft:
        return {floor.x_min, along, -0.5 * M_PI};
    }
    return {};
  }

  bool add(Furniture piece) {
    if (!fits(piece.footprint)) {
      return false;
    }
    space_.pieces.push_back(std::move(piece));
    return true;
  }

  bool fits(const Rectangle& footprint) const {
    const Rectangle& floor = space_.floor;
    for (const double gap : {footprint.x_min - floor.x_min, footprint.y_min - floor.y_min,
                             floor.x_max - footprint.x_max, floor.y_max - footprint.y_max}) {
      if (gap < -kTouch || (gap > kTouch && gap < passage_)) {
        return false;
      }
    }
    return isClear(footprint);
  }

  /// Whether a footprint leaves the floor that is kept free and a passage to every piece.
  bool isClear(const Rectangle& footprint) const {
    return std::all_of(kept_free_.begin(), kept_free_.end(),
                       [&](const Rectangle& kept) { return separation(footprint, kept) >= -kTouch; }) &&
           std::all_of(space_.pieces.begin(), space_.pieces.end(),
                       [&](const Furniture& piece) { return separation(footprint, piece.footprint) >= passage_; });
  }

  FurnishedSpace space_;
  std::vector<Rectangle> kept_free_;
  double passage_;
  RandomNumbers& random_;
};

void furnishOffice(Furnisher& room) {
  RandomNumbers& random = room.random();
  const double area = room.floor().area();
  const auto num_desks = static_cast<int>(std::clamp(area / 8.0, 1.0, 4.0));
  for (int i = 0; i < num_desks; ++i) {
    room.placeAtAnyWall(random.chance(0.3) ? deskPairFromWall(random) : deskAtWall(random));
  }
  for (int i = 0; i < 3; ++i) {
    room.placeAtAnyWall(wallBlock(random.uniform(0.8, 1.9), random.uniform(0.35, 0.45)));
  }
  room.placeAtAnyWall(plantAtWall(random));
}

void furnishMeetingRoom(Furnisher& room) {
  RandomNumbers& random = room.random();
  const double length = std::max(room.floor().width(), room.floor().height());
  auto num_chairs = static_cast<int>(std::clamp((length - 1.9) / 0.72, 2.0, 8.0));
  while (num_chairs >= 2 && !room.placeFree(meetingTable(num_chairs, random))) {
    --num_chairs;
  }
  room.placeAtAnyWall(wallBlock(random.uniform(1.0, 2.0), 0.45));
  room.placeAtAnyWall(plantAtWall(random));
}

void furnishKitchen(Furnisher& room) {
  RandomNumbers& random = room.random();
  room.placeAtAnyWall(kitchenette(random));
  room.placeAtAnyWall(sofa(random));
  for (double area = room.floor().area(); area > 9.0; area -= 9.0) {
    room.placeFree(roundTable(random));
  }
  room.placeAtAnyWall(wallBlock(random.uniform(0.5, 0.9), random.uniform(0.5, 0.8)));
}

void furnishLaboratory(Furnisher& room) {
  RandomNumbers& random = room.random();
  for (double area = room.floor().area(); area > 10.0; area -= 10.0) {
    room.placeFree(workbench(random));
    room.placeAtAnyWall(wallBlock(random.uniform(1.2, 3.0), random.uniform(0.6, 0.8)));
  }
  room.placeAtAnyWall(deskAtWall(random));
}

void furnishStore(Furnisher& room) {
  RandomNumbers& random = room.random();
  for (int i = 0; i < 5; ++i) {
    room.placeAtAnyWall(wallBlock(random.uniform(0.6, 2.6), random.uniform(0.35, 0.6)));
  }
}

/// What a room is used for goes by its size.
void furnishRoom(Furnisher& room) {
  RandomNumbers& random = room.random();
  if (random.chance(0.3)) {  // a shaft
    room.placeAtAnyWall(wallBlock(random.uniform(0.5, 1.1), random.uniform(0.4, 0.8)));
  }
  const double area = room.floor().area();
  const double use = random.uniform();
  if (area < 8.0) {
    use < 0.5 ? furnishStore(room) : furnishOffice(room);
  } else if (area < 20.0) {
    use < 0.7 ? furnishOffice(room) : use < 0.85 ? furnishMeetingRoom(room) : furnishStore(room);
  } else {
    use < 0.4    ? furnishOffice(room)
    : use < 0.65 ? furnishMeetingRoom(room)
    : use < 0.85 ? furnishLaboratory(room)
                 : furnishKitchen(room);
  }
}

void furnishHall(Furnisher& hall) {
  RandomNumbers& random = hall.random();
  for (int i = 0; i < 3; ++i) {
    hall.placeAtAnyWall(random.chance(0.4) ? deskPairFromWall(random)
                                           : wallBlock(random.uniform(0.8, 2.4), random.uniform(0.35, 0.5)));
  }
  for (double area = hall.floor().area(); area > 12.0; area -= 12.0) {
    if (!hall.placeFree(deskCluster(2, random))) {
      hall.placeFree(deskCluster(1, random));
    }
  }
  hall.placeFree(pillar(random));
  hall.placeFree(pillar(random));
  for (int i = 0; i < 4; ++i) {
    hall.placeAtAnyWall(random.chance(0.3) ? deskAtWall(random)
                                           : wallBlock(random.uniform(0.8, 2.4), random.uniform(0.35, 0.5)));
  }
  hall.placeAtAnyWall(plantAtWall(random));
}

void furnishFoyer(Furnisher& foyer) {
  RandomNumbers& random = foyer.random();
  foyer.placeFree(pillar(random));
  foyer.placeFree(pillar(random));
  foyer.placeAtAnyWall(sofa(random));
  foyer.placeAtAnyWall(sofa(random));
  foyer.placeFree(workbench(random));  // the reception
  foyer.placeFree(roundTable(random));
  foyer.placeAtAnyWall(kitchenette(random));
  foyer.placeAtAnyWall(plantAtWall(random));
}

/// Lockers, copiers and plants along the two long walls.
void furnishCorridor(Furnisher& corridor) {
  RandomNumbers& random = corridor.random();
  for (double length = corridor.floor().width(); length > 4.0; length -= 4.0) {
    corridor.placeAtWall(
        random.chance(0.25) ? plantAtWall(random) : wallBlock(random.uniform(0.5, 2.2), random.uniform(0.3, 0.45)),
        {Side::kBottom, Side::kTop});
  }
}

void furnishSpace(SpaceKind kind, Furnisher& space) {
  switch (kind) {
    case SpaceKind::kCorridor:
      return furnishCorridor(space);
    case SpaceKind::kFoyer:
      return furnishFoyer(space);
    case SpaceKind::kHall:
      return furnishHall(space);
    case SpaceKind::kRoom:
      return furnishRoom(space);
  }
}

/// Doors of a room open into it, and many of them stand open.
void placeDoorLeaves(Furnisher& room, const std::vector<Door>& doors) {
  for (const Door& door : doors) {
    const bool leads_here = separation(door.approach(), room.floor()) < 0.0;
    if (leads_here && door.width < 1.2 && room.random().chance(0.6)) {
      room.placeDoorLeaf(door);
    }
  }
}

Rectangle floorOf(const Space& space, const FloorPlan& plan, const OfficeBuildingOptions& options) {
  const double inner = 0.5 * options.wall_thickness;
  const double outer = options.outer_wall_thickness;
  const Rectangle& walls = space.walls;
  return {walls.x_min + (walls.x_min <= 0.0 ? outer : inner), walls.y_min + (walls.y_min <= 0.0 ? outer : inner),
          walls.x_max - (walls.x_max >= plan.length ? outer : inner),
          walls.y_max - (walls.y_max >= plan.width ? outer : inner)};
}

std::vector<Rectangle> keptFree(const FloorPlan& plan) {
  std::vector<Rectangle> kept = plan.passages;
  for (const Door& door : plan.doors) {
    kept.push_back(door.approach());
  }
  return kept;
}

}  // namespace

std::vector<FurnishedSpace> furnish(const FloorPlan& plan, const OfficeBuildingOptions& options) {
  RandomNumbers random(options.seed, kFurnitureStream);
  const std::vector<Rectangle> kept_free = keptFree(plan);
  std::vector<FurnishedSpace> spaces;
  for (const Space& space : plan.spaces) {
    const bool is_corridor = space.kind == SpaceKind::kCorridor;
    Furnisher furnisher(floorOf(space, plan, options), kept_free, is_corridor ? kCorridorPassage : kPassage, random);
    if (space.kind == SpaceKind::kRoom) {
      placeDoorLeaves(furnisher, plan.doors);
    }
    furnishSpace(space.kind, furnisher);
    spaces.push_back(furnisher.take());
  }
  return spaces;
}

}  // namespace map_matcher
