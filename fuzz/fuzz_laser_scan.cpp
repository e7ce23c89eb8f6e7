// Three sensor_msgs/LaserScan of one laser: scrubbed, merged and drawn, or refused with MessageError.
#include <boost/make_shared.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/mapping/session_mapping.hpp"
#include "map_matcher/scan/scan_merging.hpp"
#include "map_matcher/scrubbing/range_removal.hpp"
#include "messages.hpp"

namespace map_matcher {
namespace {

constexpr int kScans = 3;

void scrub(const sensor_msgs::LaserScanConstPtr& message, const std::vector<scrubbing::Disc>& discs) {
  const scrubbing::RawScan raw = ros_common::rawScanOf(message);
  scrubbing::ScanScrubber scrubber;
  const auto removal = scrubbing::removeRanges(raw.layout, *raw.ranges, discs, {}, scrubber);
  const auto scrubbed = ros_common::scrubbedMessage(message, removal);
  if (scrubbed->ranges.size() != message->ranges.size() || removal.removed.size() > message->ranges.size()) {
    __builtin_trap();
  }
  for (const std::uint32_t beam : removal.removed) {
    if (!std::isinf(scrubbed->ranges.at(beam))) {
      __builtin_trap();
    }
  }
}

void merge(const std::vector<sensor_msgs::LaserScanConstPtr>& messages, const scan::LaserMount& first,
           const scan::LaserMount& last) {
  std::vector<scan::MovingScan> scans;
  for (const sensor_msgs::LaserScanConstPtr& message : messages) {
    scans.push_back({ros_common::fromMessage(*message), first.T_base_laser, last.T_base_laser, first.upside_down});
  }
  constexpr float kRounding = 1e-3F;
  const scan::PlanarScan merged = scan::mergeScans(scans, {180, 0.05, 20.0});
  for (const float range : merged.ranges) {
    if (!std::isinf(range) && !(range >= 0.05F - kRounding && range <= 20.0F + kRounding)) {
      __builtin_trap();
    }
  }
}

void draw(const std::vector<sensor_msgs::LaserScanConstPtr>& messages, const tf2::BufferCore& tf) {
  ros_mapping::SessionMappingOptions options;
  options.mapper.delta = 0.2;
  options.mapper.max_urange = 20.0;  // else most of the time goes into maps that grow
  ros_mapping::SessionMapping mapping(options);
  for (const sensor_msgs::LaserScanConstPtr& message : messages) {
    try {
      mapping.addScan(*message, tf);
    } catch (const std::runtime_error&) {  // MessageError, tf2::TransformException, a stamp that ROS cannot add to
      continue;
    }
  }
  mapping.snapshot();
}

}  // namespace
}  // namespace map_matcher

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  fuzz::Bytes bytes(data, size);
  tf2::BufferCore tf;
  fuzz::takeTf(bytes, tf);
  const geometry_msgs::Transform first = fuzz::takeTransform(bytes);
  const geometry_msgs::Transform last = fuzz::takeTransform(bytes);
  std::vector<scrubbing::Disc> discs;
  for (int k = bytes.choose(3); k > 0; --k) {
    discs.push_back({{fuzz::takeCoordinate(bytes), fuzz::takeCoordinate(bytes)}, 0.3});
  }
  std::vector<sensor_msgs::LaserScanConstPtr> scans;
  for (int k = 0; k < kScans; ++k) {
    scans.push_back(boost::make_shared<const sensor_msgs::LaserScan>(fuzz::takeScan(bytes)));
  }
  draw(scans, tf);
  try {
    for (const sensor_msgs::LaserScanConstPtr& scan : scans) {
      scrub(scan, discs);
    }
    merge(scans, ros_common::laserMountFrom(first), ros_common::laserMountFrom(last));
  } catch (const ros_common::MessageError&) {
    return 0;
  }
  return 0;
}
