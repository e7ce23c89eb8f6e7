#include "map_matcher/ros/matching/map_url.hpp"

#include <stdexcept>

namespace map_matcher::ros_matching {

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

}  // namespace map_matcher::ros_matching
