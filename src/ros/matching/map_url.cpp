#include "map_matcher/ros/matching/map_url.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "map_matcher/grid/map_file.hpp"

namespace map_matcher::ros_matching {
namespace {

/// Without links, as far as the path exists.
std::filesystem::path resolved(const std::string& path) {
  std::error_code unreadable;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, unreadable), unreadable);
}

void requireBelow(const std::string& root, const std::string& path) {
  const std::filesystem::path folder = resolved(root + "/.");
  const std::filesystem::path file = resolved(path);
  const auto [end_of_folder, end_of_file] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  if (end_of_folder != folder.end() && !end_of_folder->empty()) {
    throw std::invalid_argument("'" + path + "' does not lie in '" + root + "', expected a map below ~map_root");
  }
}

}  // namespace

std::string pathOfMapUrl(const std::string& url) {
  const std::string scheme = "file://";
  if (url.rfind(scheme, 0) == 0) {
    return url.substr(scheme.size());
  }
  if (url.find("://") != std::string::npos) {
    throw std::invalid_argument("map_url is \"" + url + "\", expected a path or file:///PATH");
  }
  return url;
}

void requireMapBelow(const std::string& root, const std::string& yaml_path) {
  if (root.empty()) {
    return;
  }
  requireBelow(root, yaml_path);
  requireBelow(root, grid::imageNamedBy(yaml_path));
}

}  // namespace map_matcher::ros_matching
