// Drives a simulated robot through a map and writes what it measured into a bag.

#include <cstddef>
#include <iostream>
#include <string>

#include "command_line.hpp"
#include "drive_arguments.hpp"
#include "file_roles.hpp"
#include "map_matcher/ros/simulation/drive_bag.hpp"
#include "map_matcher/simulation/drive.hpp"

namespace {

namespace grid = map_matcher::grid;
namespace ros_simulation = map_matcher::ros_simulation;
namespace simulation = map_matcher::simulation;

struct Arguments {
  map_matcher::tools::DriveArguments drive;
  std::string bag;
};

/// What was driven.
class Summary {
 public:
  void add(const simulation::DriveStep& step) {
    if (num_steps_ == 0) {
      start_ = step.T_map_base;
      num_people_ = step.people.size();
    } else {
      length_ += (step.T_map_base.translation() - last_.T_map_base.translation()).norm();
    }
    ++num_steps_;
    last_.T_map_base = step.T_map_base;
    last_.time = step.time;
  }

  void print(const std::string& bag, const simulation::DriveSimulation& simulation) const {
    std::cout << bag << ": " << num_steps_ * simulation.lidarPoses().size() << " scans in " << last_.time << " s, "
              << length_ << " m driven from (" << start_.x << ", " << start_.y << ", " << start_.yaw << "), "
              << simulation.visited().size() << " waypoints reached";
    if (simulation.hasPeople()) {
      std::cout << ", " << num_people_ << " people";
    }
    std::cout << '\n';
  }

 private:
  std::size_t num_steps_ = 0;
  std::size_t num_people_ = 0;
  double length_ = 0.0;  // [m]
  grid::Rigid2 start_;
  simulation::DriveStep last_;
};

void simulate(const Arguments& arguments) {
  map_matcher::tools::FileRoles files;
  arguments.drive.addFiles(files);
  files.writes("--bag", arguments.bag).requireDistinct();
  const simulation::DriveOptions options = arguments.drive.options();
  simulation::DriveSimulation simulation(arguments.drive.map(), options);
  ros_simulation::DriveMessageOptions bag_options;
  bag_options.score_threshold = options.detector.score_threshold;
  ros_simulation::DriveBagWriter bag(arguments.bag, {simulation.lidarPoses(), 1.0 / options.rate}, bag_options);
  Summary summary;
  while (const auto step = simulation.next()) {
    bag.write(*step);
    summary.add(*step);
  }
  bag.close();
  summary.print(arguments.bag, simulation);
}

}  // namespace

int main(int argc, char** argv) {
  map_matcher::tools::CommandLine command_line(
      "simulate_drive",
      "Drives a simulated robot through a map, among people with --people or --density, and writes scans, odometry, "
      "tf, ground truth and detections of people into a bag.",
      "Exit status: 0 written, 2 bad input.");
  Arguments arguments{{argc, argv}, ""};
  command_line.add("--bag", &arguments.bag, "Bag to write").required();
  arguments.drive.describe(command_line);
  return map_matcher::tools::run(command_line, argc, argv, [&] {
    simulate(arguments);
    return map_matcher::tools::kDone;
  });
}
