#include "map_matcher/simulation/furnishing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "map_matcher/simulation/furnisher.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {
namespace {

constexpr std::uint64_t kFurnitureStream = 2;  // of the seed
constexpr std::uint64_t kMovingStream = 2;     // of the seed of changes
constexpr double kPassage = 0.85;              // [m] between pieces in a room
constexpr double kCorridorPassage = 1.35;      // [m] between pieces in a corridor

/// A cupboard, shelf or shaft of random size [m].
Furniture block(double min_width, double max_width, double min_depth, double max_depth, RandomNumbers& random) {
  const double width = random.uniform(min_width, max_width);
  const double depth = random.uniform(min_depth, max_depth);
  return wallBlock(width, depth);
}

void furnishOffice(Furnisher& room) {
  RandomNumbers& random = room.random();
  const double area = room.floor().area();
  const auto num_desks = static_cast<int>(std::clamp(area / 8.0, 1.0, 4.0));
  for (int i = 0; i < num_desks; ++i) {
    room.placeAtAnyWall(random.chance(0.3) ? deskPairFromWall(random) : deskAtWall(random));
  }
  for (int i = 0; i < 3; ++i) {
    room.placeAtAnyWall(block(0.8, 1.9, 0.35, 0.45, random));
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
  room.placeAtAnyWall(block(0.5, 0.9, 0.5, 0.8, random));
}

void furnishLaboratory(Furnisher& room) {
  RandomNumbers& random = room.random();
  for (double area = room.floor().area(); area > 10.0; area -= 10.0) {
    room.placeFree(workbench(random));
    room.placeAtAnyWall(block(1.2, 3.0, 0.6, 0.8, random));
  }
  room.placeAtAnyWall(deskAtWall(random));
}

void furnishStore(Furnisher& room) {
  RandomNumbers& random = room.random();
  for (int i = 0; i < 5; ++i) {
    room.placeAtAnyWall(block(0.6, 2.6, 0.35, 0.6, random));
  }
}

/// What a room is used for goes by its size.
void furnishRoom(Furnisher& room) {
  RandomNumbers& random = room.random();
  if (random.chance(0.3)) {  // a shaft
    room.placeAtAnyWall(block(0.5, 1.1, 0.4, 0.8, random));
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
    hall.placeAtAnyWall(random.chance(0.4) ? deskPairFromWall(random) : block(0.8, 2.4, 0.35, 0.5, random));
  }
  for (double area = hall.floor().area(); area > 12.0; area -= 12.0) {
    if (!hall.placeFree(deskCluster(2, random))) {
      hall.placeFree(deskCluster(1, random));
    }
  }
  hall.placeFree(pillar(random));
  hall.placeFree(pillar(random));
  for (int i = 0; i < 4; ++i) {
    hall.placeAtAnyWall(random.chance(0.3) ? deskAtWall(random) : block(0.8, 2.4, 0.35, 0.5, random));
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
    corridor.placeAtWall(random.chance(0.25) ? plantAtWall(random) : block(0.5, 2.2, 0.3, 0.45, random),
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

/// What stands in a space, beside another one that it is a copy of.
FurnishedSpace copied(const FurnishedSpace& original, double distance) {
  FurnishedSpace copy = original;
  copy.floor.x_min += distance;
  copy.floor.x_max += distance;
  for (Furniture& piece : copy.pieces) {
    piece = placed(piece, {distance, 0.0, 0.0});
  }
  return copy;
}

}  // namespace

std::uint64_t furnitureSeedOf(const OfficeBuildingOptions& options) {
  return options.furniture_seed == 0 ? options.seed : options.furniture_seed;
}

std::vector<FurnishedSpace> furnish(const FloorPlan& plan, const OfficeBuildingOptions& options) {
  RandomNumbers random(furnitureSeedOf(options), kFurnitureStream);
  RandomNumbers moving(options.change_seed, kMovingStream);
  const std::vector<Rectangle> kept_free = keptFree(plan);
  std::vector<FurnishedSpace> spaces;
  for (const Space& space : plan.spaces) {
    if (space.copy_of && options.copied_furniture) {
      const double distance = space.walls.x_min - plan.spaces[*space.copy_of].walls.x_min;
      spaces.push_back(copied(spaces[*space.copy_of], distance));
      continue;
    }
    const bool is_corridor = space.kind == SpaceKind::kCorridor;
    Furnisher furnisher(floorOf(space, plan, options), kept_free, is_corridor ? kCorridorPassage : kPassage, random);
    if (space.kind == SpaceKind::kRoom) {
      placeDoorLeaves(furnisher, plan.doors);
    }
    furnishSpace(space.kind, furnisher);
    for (const Door& door : plan.doors) {
      if (door.is_shut) {
        furnisher.removeDoorLeaf(door);
      }
    }
    if (options.moved_furniture > 0.0) {
      furnisher.move(options.moved_furniture, moving);
    }
    spaces.push_back(furnisher.space());
  }
  return spaces;
}

}  // namespace map_matcher::simulation
