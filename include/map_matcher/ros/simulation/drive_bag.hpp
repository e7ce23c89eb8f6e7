/// \file
/// Writes a simulated drive as the bag that a robot would have recorded.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "map_matcher/ros/bags/bag_writing.hpp"
#include "map_matcher/ros/simulation/drive_messages.hpp"
#include "map_matcher/simulation/drive.hpp"

namespace map_matcher::ros_simulation {

/// A bag that cannot be written; the text names the file and the reason.
class DriveBagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes the messages of a drive (DriveMessages) step by step, so that a long one need not fit into memory. They are
/// recorded as they arrive, on the topics of the options below "/". The same steps give the same bag.
class DriveBagWriter {
 public:
  /// Begins the file. Throws DriveBagError when it cannot be written, std::invalid_argument as DriveMessages does.
  DriveBagWriter(const std::string& path, const DriveDescription& drive, const DriveMessageOptions& options = {});

  /// Adds the next step. Throws DriveBagError when it cannot be written.
  void write(const simulation::DriveStep& step);

  /// Completes the file, which does not have its name before, and replaces one that has. Throws DriveBagError when it
  /// cannot be written.
  void close();

 private:
  DriveMessages messages_;
  std::unique_ptr<ros_bags::BagWriter> bag_;
  std::uint32_t num_steps_ = 0;
};

/// Writes the whole drive, as DriveBagWriter does.
void writeDriveBag(const simulation::Drive& drive, const std::string& path, const DriveMessageOptions& options = {});

}  // namespace map_matcher::ros_simulation
