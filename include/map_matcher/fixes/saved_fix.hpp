/// \file
/// The last place of the robot, kept in a file from one start to the next.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "map_matcher/fixes/pose_estimate.hpp"

namespace map_matcher::fixes {

/// A file that holds no fix; the message names the file, the key, its value and what was expected.
class FixFileError : public std::runtime_error {
 public:
  FixFileError(const std::string& path, const std::string& problem)
      : std::runtime_error("fix file '" + path + "': " + problem) {}
};

/// Where the robot was, and in which map.
struct SavedFix {
  std::string reference_map;           ///< Name of the reference map, for people.
  std::uint64_t reference_digest = 0;  ///< Of its cells, by which it is known again.
  PoseEstimate pose;
};

/// Reads a file that saveFix() wrote. Throws FixFileError when there is none, and for one that is not whole.
SavedFix loadFix(const std::string& path);

/// Writes the fix as YAML; the file is there whole or not at all. Throws files::OutputFileError.
void saveFix(const SavedFix& fix, const std::string& path);

}  // namespace map_matcher::fixes
