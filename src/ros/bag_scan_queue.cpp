#include "map_matcher/ros/bag_scan_queue.hpp"

#include <tf2/exceptions.h>

#include <stdexcept>

namespace map_matcher {

void BagScanQueue::releaseBefore(const ros::Time& deadline) {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    try {
      use_(*waiting_.front().scan);
    } catch (const tf2::TransformException& error) {
      if (waiting_.front().recorded >= deadline) {
        return;
      }
      ++without_transforms_;
      last_problem_ = error.what();
    } catch (const std::runtime_error& error) {
      ++refused_;
      last_problem_ = error.what();
    }
  }
}

}  // namespace map_matcher
