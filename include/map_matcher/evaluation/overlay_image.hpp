/// \file
/// The picture of a match: figure 8 of the report.
#pragma once

#include <optional>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"
#include "map_matcher/search/search_options.hpp"

namespace map_matcher::evaluation {

/// Draws the reference map in grey and, when there is a pose, the occupied session cells at it: red where they lie on
/// walls of the reference by search::splitByMatch() with `options`, blue where they do not. The picture shows the walls
/// and cells with a margin of 1 m, north up in the reference grid's axes, and is enlarged to at least 1000 pixels along
/// its longer side. The format follows the ending of `path` (.png recommended). Throws std::runtime_error when the file
/// cannot be written.
void writeOverlayImage(const std::string& path, const grid::OccupancyGrid& reference,
                       const grid::OccupancyGrid& session, const std::optional<grid::Rigid2>& T_reference_session,
                       const search::SearchOptions& options = {});

}  // namespace map_matcher::evaluation
