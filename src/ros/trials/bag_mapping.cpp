#include "map_matcher/ros/trials/bag_mapping.hpp"

#include <rosbag/view.h>

#include <algorithm>
#include <sstream>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/ros/bags/bag_scan_queue.hpp"

namespace map_matcher::ros_trials {
namespace {

/// Goes through a bag once. Scans wait until their transforms have come.
class BagMapping {
 public:
  BagMapping(const BagMappingRequest& request, const std::function<void(const ros_mapping::SessionSnapshot&)>& on_map)
      : request_(request), on_map_(on_map), mapping_(request.options) {
    ros_bags::openBag(bag_, request.bag);
    const ros_bags::BagTopics topics = ros_bags::topicsOf(bag_);
    chooseTopics(topics);
    ros_bags::requireTransforms(request.bag, topics, request.options.odom_frame);
    rosbag::View all(bag_);
    result_.begin = all.getBeginTime();
    checkTimes(all.getEndTime() - all.getBeginTime());
  }

  BagMappingResult run() {
    ros_bags::BagScanQueue queue(bag_, request_.bag, [&](const sensor_msgs::LaserScan& scan, std::size_t laser) {
      add(scan, queue.tf(), laser);
    });
    const ros::Time first =
        result_.begin + ros::Duration(std::max(0.0, request_.from - ros_bags::BagScanQueue::kPatience));
    const std::vector<std::string>& scans = result_.scan_topics;
    std::vector<std::string> topics = scans;
    topics.emplace_back("/tf");
    rosbag::View view(bag_, rosbag::TopicQuery(topics), first, last());
    ros_bags::forEachMessage(bag_, view, [&](const rosbag::MessageInstance& message) {
      const auto topic = std::find(scans.begin(), scans.end(), message.getTopic());
      if (topic != scans.end() && isAskedFor(message.getTime())) {
        ++result_.scans;
        queue.addScan(message, static_cast<std::size_t>(topic - scans.begin()));
      }
      queue.read(message);
    });
    queue.finish();
    result_.scans_without_tf = queue.withoutTransforms();
    result_.scans_refused = queue.refused();
    result_.last_problem = queue.lastProblem();
    finish();
    return result_;
  }

 private:
  void chooseTopics(const ros_bags::BagTopics& topics) {
    std::vector<std::string>& chosen = result_.scan_topics;
    const std::vector<std::string> only{""};
    for (const std::string& asked : request_.scan_topics.empty() ? only : request_.scan_topics) {
      chosen.push_back(ros_bags::chooseScanTopic(request_.bag, topics, asked));
      if (std::count(chosen.begin(), chosen.end(), chosen.back()) > 1) {
        throw ros_bags::BagError("the topic of scans " + chosen.back() + " is given twice, expected different ones");
      }
    }
  }

  std::string topicsText() const {
    std::string text;
    for (const std::string& topic : result_.scan_topics) {
      text += (text.empty() ? "" : ", ") + topic;
    }
    return text;
  }

  ros::Time last() const {
    return request_.until ? result_.begin + ros::Duration(*request_.until + ros_bags::BagScanQueue::kPatience)
                          : ros::TIME_MAX;
  }

  void checkTimes(const ros::Duration& duration) const {
    if (!(request_.from >= 0.0) || request_.from > duration.toSec()) {
      throw ros_bags::BagError("the begin is " + std::to_string(request_.from) + " s, expected 0 to " +
                               std::to_string(duration.toSec()) + " s, as long as bag '" + request_.bag + "' lasts");
    }
    if (request_.until && !(*request_.until > request_.from && *request_.until < 1e9)) {
      throw ros_bags::BagError("the end is " + std::to_string(*request_.until) + " s, expected more than the begin, " +
                               std::to_string(request_.from) + " s");
    }
  }

  bool isAskedFor(const ros::Time& recorded) const {
    const double time = (recorded - result_.begin).toSec();
    return time >= request_.from && (!request_.until || time <= *request_.until);
  }

  void add(const sensor_msgs::LaserScan& scan, const tf2::BufferCore& tf, std::size_t laser) {
    const ros_mapping::MappingUpdate update = mapping_.addScan(scan, tf, laser);
    result_.path.push_back({scan.header.stamp.toSec(), mapping_.mapper().T_session_base()});
    result_.scans_drawn += update.report.outcome == mapping::ScanOutcome::kDrawn ? 1 : 0;
    result_.scans_not_fitting += update.report.outcome == mapping::ScanOutcome::kNotFitting ? 1 : 0;
    drawn_since_map_ = drawn_since_map_ || update.report.outcome == mapping::ScanOutcome::kDrawn;
    if (update.snapshot) {
      on_map_(*update.snapshot);
      drawn_since_map_ = false;
    }
  }

  void finish() {
    if (result_.scans_drawn == 0) {
      std::ostringstream text;
      text << "bag '" << request_.bag << "': none of the " << result_.scans << " scans of " << topicsText()
           << " could be drawn";
      text << (result_.last_problem.empty() ? "" : ": " + result_.last_problem);
      throw ros_bags::BagError(text.str());
    }
    if (drawn_since_map_) {
      on_map_(*mapping_.snapshot());
    }
  }

  const BagMappingRequest& request_;
  const std::function<void(const ros_mapping::SessionSnapshot&)>& on_map_;
  ros_mapping::SessionMapping mapping_;
  rosbag::Bag bag_;
  BagMappingResult result_;
  bool drawn_since_map_ = false;
};

}  // namespace

BagMappingResult mapBag(const BagMappingRequest& request,
                        const std::function<void(const ros_mapping::SessionSnapshot&)>& on_map) {
  return BagMapping(request, on_map).run();
}

}  // namespace map_matcher::ros_trials
