/// \file
/// Which scans of several lasers belong together.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace map_matcher::scan {

/// When scans belong together. In seconds, above 0.
struct ScanSetTimes {
  double max_age = 0.1;   ///< Scans of one set are no farther apart.
  double patience = 0.1;  ///< So long after its stamp a scan waits for those of other lasers.
  double silence = 1.0;   ///< A laser whose newest scan is so much older than another's is not waited for.
};

/// Puts the scans of several lasers together, a set for each scan of the leading laser: the first one in their order
/// that is not silent. Of each other laser the scan nearest in time belongs to it. `Scan` is what is handed in and out.
template <typename Scan>
class ScanSets {
 public:
  /// A set: the stamp [s] of the leading laser's scan, and a scan of each laser, none of one that has no fitting scan.
  struct Set {
    double stamp = 0.0;
    std::vector<std::optional<Scan>> scans;
  };

  ScanSets(std::size_t num_lasers, const ScanSetTimes& times) : times_(times), lasers_(num_lasers) {}

  /// Takes a scan of a laser with its stamp [s]. A stamp before that laser's last one by more than a second begins
  /// anew, since time went back; one that is only out of order is left out. Returns whether time went back.
  bool add(std::size_t laser, double stamp, Scan scan) {
    bool went_back = false;
    std::deque<Entry>& entries = lasers_[laser];
    if (!entries.empty() && stamp <= entries.back().stamp) {
      if (entries.back().stamp - stamp <= kWentBack) {
        return false;
      }
      clear();
      went_back = true;
    }
    entries.push_back({stamp, std::move(scan)});
    if (entries.size() > kMostKept) {
      entries.pop_front();
    }
    return went_back;
  }

  /// The next set, if it is complete or has waited long enough at the time `now` [s].
  std::optional<Set> next(double now) {
    const std::deque<Entry>& leading = lasers_[leader()];
    for (const Entry& head : leading) {
      if (last_ && head.stamp <= *last_) {
        continue;
      }
      if (now - head.stamp <= times_.patience && isAwaited(head.stamp)) {
        return std::nullopt;
      }
      last_ = head.stamp;
      Set set = around(head.stamp);
      forgetBefore(head.stamp - times_.max_age);
      return set;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    double stamp;
    Scan scan;
  };

  static constexpr double kWentBack = 1.0;      // [s]
  static constexpr std::size_t kMostKept = 50;  // scans of a laser

  void clear() {
    for (std::deque<Entry>& entries : lasers_) {
      entries.clear();
    }
    last_.reset();
  }

  std::optional<double> newest() const {
    std::optional<double> stamp;
    for (const std::deque<Entry>& entries : lasers_) {
      if (!entries.empty() && (!stamp || entries.back().stamp > *stamp)) {
        stamp = entries.back().stamp;
      }
    }
    return stamp;
  }

  bool isSilent(const std::deque<Entry>& entries) const {
    return entries.empty() || entries.back().stamp + times_.silence < *newest();
  }

  std::size_t leader() const {
    for (std::size_t laser = 0; laser < lasers_.size(); ++laser) {
      if (!lasers_[laser].empty() && !isSilent(lasers_[laser])) {
        return laser;
      }
    }
    return 0;
  }

  /// Whether a laser that is not silent may still have a scan nearer to the stamp.
  bool isAwaited(double stamp) const {
    for (const std::deque<Entry>& entries : lasers_) {
      if (!isSilent(entries) && entries.back().stamp < stamp) {
        return true;
      }
    }
    return false;
  }

  Set around(double stamp) const {
    Set set{stamp, {}};
    for (const std::deque<Entry>& entries : lasers_) {
      const Entry* nearest = nullptr;
      for (const Entry& entry : entries) {
        const double age = distance(entry.stamp, stamp);
        if (age <= times_.max_age && (nearest == nullptr || age < distance(nearest->stamp, stamp))) {
          nearest = &entry;
        }
      }
      set.scans.push_back(nearest == nullptr ? std::nullopt : std::optional<Scan>(nearest->scan));
    }
    return set;
  }

  static double distance(double a, double b) { return a < b ? b - a : a - b; }

  /// A laser's last scan stays: it tells whether the laser is silent.
  void forgetBefore(double stamp) {
    for (std::deque<Entry>& entries : lasers_) {
      while (entries.size() > 1 && entries.front().stamp < stamp) {
        entries.pop_front();
      }
    }
  }

  ScanSetTimes times_;
  std::vector<std::deque<Entry>> lasers_;  // by laser, in the order of their stamps
  std::optional<double> last_;             // stamp of the last set
};

}  // namespace map_matcher::scan
