#include "map_matcher/simulation/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "map_matcher/parameters/number_text.hpp"
#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {
namespace {

constexpr std::uint64_t kPlanStream = 1;  // of the seed
constexpr std::uint64_t kDoorStream = 1;  // of the seed of changes
constexpr double kWideDoor = 1.2;         // [m] from which a door is never shut
constexpr double kApproachDepth = 1.1;    // [m] of empty floor before and behind a door
constexpr double kJambWall = 0.25;        // [m] of wall between a door and the corner of a room
constexpr double kSmallestRoom = 2.4;     // [m] along the corridor
constexpr double kRoomDepth = 4.2;        // [m] at least between corridor and outer wall

/// Rooms side by side between the corridor and the outer wall.
struct Strip {
  Rectangle area;
  bool corridor_is_above;
};

/// Draws the plan from the large to the small: hall, corridors and foyer, strips of rooms, rooms, doors.
class PlanDrawer {
 public:
  explicit PlanDrawer(const OfficeBuildingOptions& options) : options_(options), random_(options.seed, kPlanStream) {
    plan_.length = options.length;
    plan_.width = options.width;
  }

  FloorPlan draw() {
    chooseCorridors();
    addHall();
    for (const Strip& strip : addCorridorsAndFoyer()) {
      options_.copied_rooms > 0.0 ? addCopiedRooms(strip) : addRooms(strip);
    }
    shutDoors();
    return std::move(plan_);
  }

 private:
  /// The corridor is higher on one side of the foyer than on the other.
  void chooseCorridors() {
    corridor_width_ = random_.uniform(1.9, 2.3);
    const double room_depth = plan_.width - corridor_width_;
    const double jog = std::min(random_.uniform(1.2, 1.9), room_depth - 2.0 * kRoomDepth);
    const double lower = random_.uniform(kRoomDepth, room_depth - kRoomDepth - jog);
    const bool rises = random_.chance(0.5);
    left_y_ = rises ? lower : lower + jog;
    right_y_ = rises ? lower + jog : lower;
    foyer_x_ = plan_.length * random_.uniform(0.36, 0.58);
    foyer_width_ = random_.uniform(4.6, 6.4);
    foyer_is_below_ = random_.chance(0.5);
  }

  /// The hall takes the whole width at one end; the corridor ends at its double door.
  void addHall() {
    const double depth = random_.uniform(4.8, 6.8);
    const bool at_right = random_.chance(0.5);
    x_min_ = at_right ? 0.0 : depth;
    x_max_ = at_right ? plan_.length - depth : plan_.length;
    const Rectangle walls{at_right ? x_max_ : 0.0, 0.0, at_right ? plan_.length : x_min_, plan_.width};
    plan_.spaces.push_back({SpaceKind::kHall, walls});
    const double corridor_y = at_right ? right_y_ : left_y_;
    plan_.doors.push_back({{at_right ? x_max_ : x_min_, corridor_y + 0.5 * corridor_width_}, 1.5, false});
  }

  std::vector<Strip> addCorridorsAndFoyer() {
    const double left_top = left_y_ + corridor_width_;
    const double right_top = right_y_ + corridor_width_;
    const double bottom = std::min(left_y_, right_y_);
    const double top = std::max(left_top, right_top);
    const double x1 = foyer_x_;
    const double x2 = foyer_x_ + foyer_width_;
    plan_.spaces.push_back({SpaceKind::kFoyer,
                            {x1, foyer_is_below_ ? 0.0 : bottom, x2,  //
                             foyer_is_below_ ? top : plan_.width}});
    // The corridors reach a little into the foyer: they are open to it.
    constexpr double kOverlap = 0.5;
    plan_.spaces.push_back({SpaceKind::kCorridor, {x_min_, left_y_, x1 + kOverlap, left_top}});
    plan_.spaces.push_back({SpaceKind::kCorridor, {x2 - kOverlap, right_y_, x_max_, right_top}});
    plan_.passages.push_back({x1 - kApproachDepth, left_y_, x1 + kApproachDepth, left_top});
    plan_.passages.push_back({x2 - kApproachDepth, right_y_, x2 + kApproachDepth, right_top});

    const Strip beside_foyer = foyer_is_below_ ? Strip{{x1, top, x2, plan_.width}, false}  //
                                               : Strip{{x1, 0.0, x2, bottom}, true};
    return {{{x_min_, 0.0, x1, left_y_}, true},
            {{x_min_, left_top, x1, plan_.width}, false},
            {{x2, 0.0, x_max_, right_y_}, true},
            {{x2, right_top, x_max_, plan_.width}, false},
            beside_foyer};
  }

  /// Walls between the rooms of a strip [m], its ends included.
  std::vector<double> divide(double x_min, double x_max) {
    std::vector<double> widths;
    double sum = 0.0;
    while (x_max - x_min - sum > 0.0) {
      const double kind = random_.uniform();
      widths.push_back(kind < 0.25  ? random_.uniform(kSmallestRoom, 3.3)
                       : kind < 0.7 ? random_.uniform(3.4, 4.8)
                                    : random_.uniform(5.2, 8.0));
      sum += widths.back();
    }
    // Stretch what fits, or squeeze what is too much: whichever changes the rooms less.
    if (widths.size() > 1 && sum - (x_max - x_min) > 0.5 * widths.back()) {
      sum -= widths.back();
      widths.pop_back();
    }
    std::vector<double> walls{x_min};
    for (const double width : widths) {
      walls.push_back(walls.back() + width * (x_max - x_min) / sum);
    }
    walls.back() = x_max;
    return walls;
  }

  void addRooms(const Strip& strip) {
    const std::vector<double> walls = divide(strip.area.x_min, strip.area.x_max);
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
      const Rectangle room{walls[i], strip.area.y_min, walls[i + 1], strip.area.y_max};
      const Rectangle front = addInnerRoom(room, strip.corridor_is_above);
      plan_.spaces.push_back({SpaceKind::kRoom, front});
      addCorridorDoors(front, strip.corridor_is_above ? front.y_max : front.y_min);
      if (i > 0 && random_.chance(0.2)) {
        addConnectingDoor(front);
      }
    }
  }

  /// Rooms of the same width with their doors at the same place; what is left over is added to the last one.
  void addCopiedRooms(const Strip& strip) {
    const double width = options_.copied_rooms;
    const auto num_rooms = std::max(1, static_cast<int>(strip.area.width() / width + 1e-9));
    const double door = doorPosition(0.0, std::min(width, strip.area.width()), options_.door_width);
    const std::size_t first = plan_.spaces.size();
    for (int i = 0; i < num_rooms; ++i) {
      const bool is_last = i + 1 == num_rooms;
      const double left = strip.area.x_min + i * width;
      const Rectangle room{left, strip.area.y_min, is_last ? strip.area.x_max : left + width, strip.area.y_max};
      const bool is_copy = i > 0 && room.width() < width + 1e-9;
      plan_.spaces.push_back({SpaceKind::kRoom, room, is_copy ? std::make_optional(first) : std::nullopt});
      plan_.doors.push_back(
          {{left + door, strip.corridor_is_above ? room.y_max : room.y_min}, options_.door_width, true});
    }
  }

  void shutDoors() {
    RandomNumbers random(options_.change_seed, kDoorStream);
    for (Door& door : plan_.doors) {
      door.is_shut = random.chance(options_.shut_doors) && door.width < kWideDoor;
    }
  }

  /// Some deep rooms have another room behind them; returns what is left of the room in front.
  Rectangle addInnerRoom(const Rectangle& room, bool corridor_is_above) {
    if (room.height() < 5.4 || room.width() < 3.2 || !random_.chance(0.35)) {
      return room;
    }
    const double depth = random_.uniform(2.5, room.height() - 2.7);
    Rectangle inner = room;
    Rectangle front = room;
    const double wall = corridor_is_above ? room.y_min + depth : room.y_max - depth;
    (corridor_is_above ? inner.y_max : inner.y_min) = wall;
    (corridor_is_above ? front.y_min : front.y_max) = wall;
    plan_.spaces.push_back({SpaceKind::kRoom, inner});
    plan_.doors.push_back(
        {{doorPosition(room.x_min, room.x_max, options_.door_width), wall}, options_.door_width, true});
    return front;
  }

  void addCorridorDoors(const Rectangle& room, double wall) {
    const double widest = room.width() - 2.0 * kJambWall - options_.wall_thickness;
    if (widest > 2.0 && random_.chance(0.1)) {  // a niche, open to the corridor
      const double width = std::min(widest, random_.uniform(1.8, 2.8));
      plan_.doors.push_back({{doorPosition(room.x_min, room.x_max, width), wall}, width, true});
      return;
    }
    if (room.width() > 6.0 && random_.chance(0.6)) {  // a door at either end
      const double middle = room.centre().x();
      plan_.doors.push_back({{doorPosition(room.x_min, middle, options_.door_width), wall}, options_.door_width, true});
      plan_.doors.push_back({{doorPosition(middle, room.x_max, options_.door_width), wall}, options_.door_width, true});
      return;
    }
    const double width = std::min(widest, options_.door_width * (random_.chance(0.15) ? 1.5 : 1.0));
    plan_.doors.push_back({{doorPosition(room.x_min, room.x_max, width), wall}, width, true});
  }

  /// Doors are near a corner of their room more often than not.
  double doorPosition(double x_min, double x_max, double width) {
    const double margin = kJambWall + 0.5 * (options_.wall_thickness + width);
    const double low = x_min + margin;
    const double high = x_max - margin;
    const double side = random_.uniform();
    const double near = std::min(high - low, 0.5);
    return side < 0.35  ? random_.uniform(low, low + near)
           : side < 0.7 ? random_.uniform(high - near, high)
                        : random_.uniform(low, high);
  }

  /// A door through the room's left wall, where the room and its neighbour both are.
  void addConnectingDoor(const Rectangle& room) {
    const auto neighbour = std::find_if(plan_.spaces.begin(), plan_.spaces.end(), [&](const Space& space) {
      return space.kind == SpaceKind::kRoom && space.walls.x_max == room.x_min &&
             separation(space.walls, {room.x_min, room.y_min, room.x_min, room.y_max}) <= 0.0;
    });
    if (neighbour == plan_.spaces.end()) {
      return;
    }
    const double low = std::max(room.y_min, neighbour->walls.y_min);
    const double high = std::min(room.y_max, neighbour->walls.y_max);
    if (high - low > 2.0 * kJambWall + options_.door_width + options_.outer_wall_thickness) {
      plan_.doors.push_back({{room.x_min, doorPosition(low, high, options_.door_width)}, options_.door_width, false});
    }
  }

  const OfficeBuildingOptions& options_;
  RandomNumbers random_;
  FloorPlan plan_;
  double corridor_width_ = 0.0;  // [m]
  double left_y_ = 0.0;          // lower side of the corridor left of the foyer [m]
  double right_y_ = 0.0;         // and right of it
  double foyer_x_ = 0.0;         // left side of the foyer [m]
  double foyer_width_ = 0.0;     // along x [m]
  bool foyer_is_below_ =
      false;            // whether the foyer reaches from the corridors to the lower outer wall, or the upper one
  double x_min_ = 0.0;  // of everything but the hall [m]
  double x_max_ = 0.0;
};

}  // namespace

Rectangle Door::approach() const {
  const double along = 0.5 * width;
  return in_wall_along_x ? Rectangle{centre.x() - along, centre.y() - kApproachDepth, centre.x() + along,
                                     centre.y() + kApproachDepth}
                         : Rectangle{centre.x() - kApproachDepth, centre.y() - along, centre.x() + kApproachDepth,
                                     centre.y() + along};
}

FloorPlan drawFloorPlan(const OfficeBuildingOptions& options) {
  OfficeBuildingOptions checked = options;
  std::vector<std::string> problems = parameters::problemsOf(parametersOf(checked));
  if (options.copied_rooms > 0.0 && options.copied_rooms < kSmallestRoom) {
    problems.push_back("copied_rooms is " + parameters::numberText(options.copied_rooms) + ", expected 0 or at least " +
                       parameters::numberText(kSmallestRoom) + " m");
  }
  parameters::throwIfAny(problems);
  return PlanDrawer(options).draw();
}

}  // namespace map_matcher::simulation
