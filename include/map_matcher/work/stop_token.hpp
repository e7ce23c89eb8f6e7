/// \file
/// Cancelling a search from another thread.
#pragma once

#include <atomic>
#include <memory>

namespace map_matcher::work {

/// Copyable handle on a flag; every copy sees the same flag. Thread-safe.
class StopToken {
 public:
  void requestStop() { flag_->store(true, std::memory_order_relaxed); }
  bool stopRequested() const { return flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace map_matcher::work
