#include "map_matcher/ros/scrubbing/removal_display.hpp"

#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <visualization_msgs/Marker.h>

#include <cmath>

namespace map_matcher::ros_scrubbing {
namespace {

constexpr int kCorners = 24;         // of a circle
constexpr double kLineWidth = 0.05;  // [m]

sensor_msgs::PointCloud2 cloudOf(const std_msgs::Header& header, const scrubbing::ScanScrubber& scrubber,
                                 const std::vector<std::uint32_t>& beams) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(beams.size());
  sensor_msgs::PointCloud2Iterator<float> position(cloud, "x");
  for (const std::uint32_t beam : beams) {
    const Eigen::Vector2d point = scrubber.point(beam);
    position[0] = static_cast<float>(point.x());
    position[1] = static_cast<float>(point.y());
    position[2] = 0.0F;
    ++position;
  }
  return cloud;
}

geometry_msgs::Point cornerOf(const scrubbing::Disc& disc, int corner) {
  const double angle = 2.0 * M_PI * corner / kCorners;
  geometry_msgs::Point point;
  point.x = disc.centre.x() + disc.radius * std::cos(angle);
  point.y = disc.centre.y() + disc.radius * std::sin(angle);
  return point;
}

visualization_msgs::Marker circlesOf(const std_msgs::Header& header, const std::vector<scrubbing::Disc>& discs) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = "removal_circles";
  marker.type = visualization_msgs::Marker::LINE_LIST;
  marker.action = discs.empty() ? visualization_msgs::Marker::DELETE : visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = kLineWidth;
  marker.color.r = 0.9F;
  marker.color.b = 0.9F;
  marker.color.a = 1.0F;
  marker.points.reserve(discs.size() * 2 * kCorners);
  for (const scrubbing::Disc& disc : discs) {
    for (int corner = 0; corner < kCorners; ++corner) {
      marker.points.push_back(cornerOf(disc, corner));
      marker.points.push_back(cornerOf(disc, corner + 1));
    }
  }
  return marker;
}

}  // namespace

RemovalDisplay::RemovalDisplay(ros::NodeHandle node)
    : points_(node.advertise<sensor_msgs::PointCloud2>("removed_points", 10)),
      circles_(node.advertise<visualization_msgs::Marker>("removal_circles", 10)) {}

void RemovalDisplay::show(const std_msgs::Header& header, const scrubbing::ScanScrubber& scrubber,
                          const std::vector<std::uint32_t>& beams, const std::vector<scrubbing::Disc>& discs) {
  if (points_.getNumSubscribers() > 0) {
    points_.publish(cloudOf(header, scrubber, beams));
  }
  if (circles_.getNumSubscribers() > 0) {
    circles_.publish(circlesOf(header, discs));
  }
}

}  // namespace map_matcher::ros_scrubbing
