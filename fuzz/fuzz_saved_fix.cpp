// A saved fix: read whole and with a covariance that a pose can have, or refused with FixFileError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "file_in_memory.hpp"
#include "map_matcher/fixes/saved_fix.hpp"
#include "map_matcher/grid/pose_covariance.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  const std::string path = fuzz::file("fix.yaml", std::string(reinterpret_cast<const char*>(data), size));
  try {
    const fixes::SavedFix fix = fixes::loadFix(path);
    if (!grid::problemWithCovariance(fix.pose.covariance).empty()) {
      __builtin_trap();
    }
  } catch (const fixes::FixFileError&) {
    return 0;
  }
  return 0;
}
