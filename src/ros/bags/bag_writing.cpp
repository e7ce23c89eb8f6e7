#include "map_matcher/ros/bags/bag_writing.hpp"

#include <rosbag/exceptions.h>

#include <cerrno>
#include <system_error>

#include "map_matcher/ros/bags/bag_reading.hpp"

namespace map_matcher::ros_bags {
namespace {

files::OutputFile begun(const std::string& path) {
  try {
    return files::OutputFile(path);
  } catch (const files::OutputFileError& error) {
    throw BagError("bag '" + path + "' cannot be written: " + error.reason());
  }
}

}  // namespace

BagWriter::BagWriter(const std::string& path, rosbag::compression::CompressionType compression)
    : path_(path), file_(begun(path)), bag_(new rosbag::Bag) {
  access([&] {
    bag_->open(file_.pendingPath(), rosbag::bagmode::Write);
    bag_->setCompression(compression);
  });
}

void BagWriter::GiveUp::operator()(rosbag::Bag* bag) const {
  try {
    bag->close();
  } catch (const rosbag::BagException&) {
    return;
  }
  delete bag;
}

void BagWriter::copy(const rosbag::MessageInstance& message) {
  static_cast<void>(message.size());  // reads it, so that what fails below is the writing
  access([&] { bag_->write(message.getTopic(), message.getTime(), message, message.getConnectionHeader()); });
}

void BagWriter::close() {
  rosbag::Bag* bag = bag_.release();  // one that failed to close must not be closed again
  access([bag] { bag->close(); });
  delete bag;
  try {
    file_.commit();
  } catch (const files::OutputFileError& error) {
    throw BagError("bag '" + path_ + "' cannot be written: " + error.reason());
  }
}

void BagWriter::access(const std::function<void()>& action) const {
  errno = 0;
  try {
    action();
  } catch (const rosbag::BagException& error) {
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : error.what();
    throw BagError("bag '" + path_ + "' cannot be written: " + reason);
  }
}

}  // namespace map_matcher::ros_bags
