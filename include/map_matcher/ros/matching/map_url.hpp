/// \file
/// Map files as map_server's services name them.
#pragma once

#include <string>

namespace map_matcher::ros_matching {

/// The path that a map's URL names: a path as it is, or that of file:///path. Throws std::invalid_argument for any
/// other URL.
std::string pathOfMapUrl(const std::string& url);

/// Throws std::invalid_argument, with the path and the folder, unless the YAML file of a map and the image that it
/// names lie below the folder `root`, whatever links lead there; "" is any folder. Throws grid::MapFileError for a YAML
/// file below it that cannot be read.
void requireMapBelow(const std::string& root, const std::string& yaml_path);

}  // namespace map_matcher::ros_matching
