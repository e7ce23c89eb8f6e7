/// \file
/// The YAML half of a map file. Private to map_file.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "map_matcher/grid/map_file.hpp"

namespace map_matcher::grid {

/// What a map_server YAML file says.
struct MapDescription {
  std::filesystem::path image;      ///< Absolute, or relative to the working directory.
  GridGeometry geometry;            ///< Resolution and origin; the size is the image's.
  double occupied_threshold = 0.0;  ///< Occupancy above which a cell is occupied, 0 to 1.
  double free_threshold = 0.0;      ///< Occupancy below which a cell is free, 0 to occupied_threshold.
  bool negate = false;              ///< Whether white is occupied.
  MapMode mode = MapMode::kTrinary;
};

/// Reads and checks every key. Throws MapFileError that names the file, the key, its value and what was expected.
MapDescription readDescription(const std::string& yaml_path);

/// The YAML file for an image in the same directory.
std::string descriptionText(const GridGeometry& geometry, MapMode mode, const std::filesystem::path& image);

}  // namespace map_matcher::grid
