#include "map_matcher/ros/drive_bag.hpp"

namespace map_matcher {
namespace {

/// Runs `access`; what rosbag throws becomes an error that names the file.
template <typename Access>
void accessBag(const std::string& path, const Access& access) {
  try {
    access();
  } catch (const rosbag::BagException& error) {
    throw DriveBagError("bag '" + path + "' cannot be written: " + error.what());
  }
}

/// The name of a topic where there is no node to resolve it.
std::string resolved(const std::string& topic) { return topic.rfind('/', 0) == 0 ? topic : "/" + topic; }

}  // namespace

DriveBagWriter::DriveBagWriter(const std::string& path, const DriveDescription& drive,
                               const DriveMessageOptions& options)
    : path_(path), messages_(drive, options) {
  accessBag(path_, [&] { bag_.open(path_, rosbag::bagmode::Write); });
}

void DriveBagWriter::write(const DriveStep& step) {
  accessBag(path_, [&] {
    messages_.visit(step, num_steps_++, [&](const std::string& topic, const ros::Time& arrival, const auto& message) {
      bag_.write(resolved(topic), arrival, message);
    });
  });
}

void DriveBagWriter::close() {
  accessBag(path_, [&] { bag_.close(); });
}

void writeDriveBag(const Drive& drive, const std::string& path, const DriveMessageOptions& options) {
  const double period = drive.steps.size() > 1 ? drive.steps[1].time : 0.0;
  DriveBagWriter writer(path, {drive.T_base_lidar, period}, options);
  for (const DriveStep& step : drive.steps) {
    writer.write(step);
  }
  writer.close();
}

}  // namespace map_matcher
