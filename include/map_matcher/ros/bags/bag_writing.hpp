/// \file
/// Writing bags that are there whole or not at all.
#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>

#include <functional>
#include <memory>
#include <string>

#include "map_matcher/files/output_file.hpp"

namespace map_matcher::ros_bags {

/// A bag that is written under a pending name (OutputFile) and takes its own when it is closed. Nothing is left behind
/// of one that is not.
class BagWriter {
 public:
  /// Throws BagError when the bag cannot be written.
  explicit BagWriter(const std::string& path,
                     rosbag::compression::CompressionType compression = rosbag::compression::Uncompressed);

  /// Adds a message. Throws BagError when it cannot be written.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    access([&] { bag_->write(topic, time, message); });
  }

  /// Adds a message of another bag as it is. Throws BagError when it cannot be written, and what rosbag throws when it
  /// cannot be read.
  void copy(const rosbag::MessageInstance& message);

  /// Completes the bag, in the place of a file that has its name. Throws BagError when it cannot be written.
  void close();

 private:
  /// Gives up a bag. One that cannot be closed is left alone: its destructor would try again, and end the process.
  struct GiveUp {
    void operator()(rosbag::Bag* bag) const;
  };

  void access(const std::function<void()>& action) const;

  std::string path_;
  files::OutputFile file_;
  std::unique_ptr<rosbag::Bag, GiveUp> bag_;
};

}  // namespace map_matcher::ros_bags
