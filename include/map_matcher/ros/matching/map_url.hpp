/// \file
/// Map files as map_server's services name them.
#pragma once

#include <string>

namespace map_matcher::ros_matching {

/// The path that a map's URL names: a path as it is, or that of file:///path. Throws std::invalid_argument for any
/// other URL.
std::string pathOfMapUrl(const std::string& url);

}  // namespace map_matcher::ros_matching
