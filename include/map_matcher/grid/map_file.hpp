/// \file
/// Map files as map_server reads and writes them: a YAML file beside an image.
#pragma once

#include <stdexcept>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::grid {

/// A map file that cannot be read or written; the message names the file, the key, its value and what was expected.
class MapFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How the grey values of the image stand for occupancy (map_server's `mode`).
enum class MapMode {
  kTrinary,  ///< Occupied above occupied_thresh, free below free_thresh, unknown between.
  kScale,    ///< As trinary, but 1 to 99 percent between the thresholds; transparent pixels are unknown.
  kRaw,      ///< The grey value is the occupancy [percent]; above 100 is unknown.
};

/// Reads a map_server YAML file and the PGM, PNG or BMP image it names (relative to the YAML file, or absolute).
/// Throws MapFileError, also for a map that does not keep to the limits of map_limits.hpp; of too large an image no
/// more than the header is read.
OccupancyGrid loadMap(const std::string& yaml_path);

/// Path of the image that a YAML file names. Throws MapFileError as loadMap() does for the YAML file.
std::string imageNamedBy(const std::string& yaml_path);

/// Writes `yaml_path` and, beside it, an image of the same name ending in .pgm. kTrinary rounds every value to free
/// (below 25), unknown or occupied (65 and above) as map_saver does; kRaw keeps every value. kScale is not written.
/// Both files are there whole or not at all (OutputFile); what was there before is replaced. Throws MapFileError.
void saveMap(const OccupancyGrid& grid, const std::string& yaml_path, MapMode mode = MapMode::kTrinary);

/// Path of the image that saveMap() writes beside `yaml_path`.
std::string imageWrittenWith(const std::string& yaml_path);

}  // namespace map_matcher::grid
