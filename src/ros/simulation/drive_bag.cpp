#include "map_matcher/ros/simulation/drive_bag.hpp"

#include "map_matcher/ros/bags/bag_reading.hpp"

namespace map_matcher::ros_simulation {
namespace {

/// Runs `access`; an error of the bag becomes one of the drive's bag.
template <typename Access>
void accessBag(const Access& access) {
  try {
    access();
  } catch (const ros_bags::BagError& error) {
    throw DriveBagError(error.what());
  }
}

/// The name of a topic where there is no node to resolve it.
std::string resolved(const std::string& topic) { return topic.rfind('/', 0) == 0 ? topic : "/" + topic; }

}  // namespace

DriveBagWriter::DriveBagWriter(const std::string& path, const DriveDescription& drive,
                               const DriveMessageOptions& options)
    : messages_(drive, options) {
  accessBag([&] { bag_ = std::make_unique<ros_bags::BagWriter>(path); });
}

void DriveBagWriter::write(const simulation::DriveStep& step) {
  accessBag([&] {
    messages_.visit(step, num_steps_++, [&](const std::string& topic, const ros::Time& arrival, const auto& message) {
      bag_->write(resolved(topic), arrival, message);
    });
  });
}

void DriveBagWriter::close() {
  accessBag([&] { bag_->close(); });
}

void writeDriveBag(const simulation::Drive& drive, const std::string& path, const DriveMessageOptions& options) {
  const double period = drive.steps.size() > 1 ? drive.steps[1].time : 0.0;
  DriveBagWriter writer(path, {drive.T_base_lidar, period}, options);
  for (const simulation::DriveStep& step : drive.steps) {
    writer.write(step);
  }
  writer.close();
}

}  // namespace map_matcher::ros_simulation
