/// \file
/// Poses in sentences.
#pragma once

#include <sstream>
#include <string>

#include "map_matcher/grid/rigid2.hpp"

namespace map_matcher::belief {

inline std::string poseText(const grid::Rigid2& pose) {
  std::ostringstream out;
  out << "(" << pose.x << " m, " << pose.y << " m, " << pose.yaw << " rad)";
  return out.str();
}

}  // namespace map_matcher::belief
