#include "map_matcher/evaluation/overlay_image.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "map_matcher/grid/occupied_cells.hpp"
#include "map_matcher/search/matched_cells.hpp"
#include "picture_file.hpp"

namespace map_matcher::evaluation {
namespace {

constexpr double kMargin = 1.0;                  // around walls and cells [m]
constexpr int kWantedPixels = 1000;              // along the longer side, at least
const cv::Scalar kMatchedColour(0, 0, 230);      // BGR: red
const cv::Scalar kUnmatchedColour(230, 120, 0);  // blue
const cv::Vec3b kWallColour(60, 60, 60);
const cv::Vec3b kFreeColour(255, 255, 255);
const cv::Vec3b kUnknownColour(215, 215, 215);

/// Cells of the reference grid that the picture shows, with the size of a cell in pixels.
struct View {
  cv::Rect cells;
  int scale;
};

using Points = std::vector<Eigen::Vector2d>;

/// Points of the session map frame in cells of the reference grid.
Points toReferenceCells(const grid::OccupancyGrid& reference, const grid::Rigid2& T_reference_session,
                        const Points& points, double reference_cell_offset) {
  const grid::Rigid2 T_reference_grid = grid::cornerOf(reference.geometry(), reference_cell_offset);
  const grid::Rigid2 T_grid_session = T_reference_grid.inverse() * T_reference_session;
  Points cells;
  for (const Eigen::Vector2d& p : points) {
    cells.emplace_back(T_grid_session * p / reference.resolution());
  }
  return cells;
}

View chooseView(const grid::OccupancyGrid& reference, const std::vector<Points>& overlays,
                std::int8_t occupied_threshold) {
  std::vector<cv::Point> shown;
  for (const grid::Cell& wall : grid::occupiedCells(reference, occupied_threshold)) {
    shown.emplace_back(wall.x, wall.y);
  }
  for (const Points& overlay : overlays) {
    for (const Eigen::Vector2d& p : overlay) {
      shown.emplace_back(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    }
  }
  cv::Rect box = shown.empty() ? cv::Rect(0, 0, reference.width(), reference.height()) : cv::boundingRect(shown);
  const int margin = static_cast<int>(std::ceil(kMargin / reference.resolution()));
  box = cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
  const int longer = std::max(box.width, box.height);
  return {box, std::max(1, (kWantedPixels + longer - 1) / longer)};
}

cv::Vec3b colourOf(const grid::OccupancyGrid& reference, int x, int y, std::int8_t occupied_threshold) {
  if (!reference.geometry().contains({x, y}) || reference.at(x, y) == grid::kUnknown) {
    return kUnknownColour;
  }
  return reference.at(x, y) >= occupied_threshold ? kWallColour : kFreeColour;
}

cv::Mat drawReference(const grid::OccupancyGrid& reference, const View& view, std::int8_t occupied_threshold) {
  cv::Mat image(view.cells.height, view.cells.width, CV_8UC3);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const int y = view.cells.y + image.rows - 1 - row;
      image.at<cv::Vec3b>(row, column) = colourOf(reference, view.cells.x + column, y, occupied_threshold);
    }
  }
  cv::Mat enlarged;
  cv::resize(image, enlarged, cv::Size(), view.scale, view.scale, cv::INTER_NEAREST);
  return enlarged;
}

void drawCells(cv::Mat& image, const Points& cells, const View& view, const cv::Scalar& colour) {
  const int half = std::max(1, view.scale / 2);
  for (const Eigen::Vector2d& p : cells) {
    const int column = static_cast<int>(std::lround((p.x() - view.cells.x) * view.scale));
    const int row = image.rows - static_cast<int>(std::lround((p.y() - view.cells.y) * view.scale));
    cv::rectangle(image, cv::Point(column - half, row - half), cv::Point(column + half, row + half), colour,
                  cv::FILLED);
  }
}

}  // namespace

void writeOverlayImage(const std::string& path, const grid::OccupancyGrid& reference,
                       const grid::OccupancyGrid& session, const std::optional<grid::Rigid2>& T_reference_session,
                       const search::SearchOptions& options) {
  Points matched;
  Points unmatched;
  if (T_reference_session) {
    const search::MatchedCells cells = search::splitByMatch(reference, session, *T_reference_session, options);
    const double offset = options.reference_map_cell_offset;
    matched = toReferenceCells(reference, *T_reference_session, cells.matched, offset);
    unmatched = toReferenceCells(reference, *T_reference_session, cells.unmatched, offset);
  }
  const auto occupied_threshold = static_cast<std::int8_t>(options.occupied_threshold);
  const View view = chooseView(reference, {matched, unmatched}, occupied_threshold);
  cv::Mat image = drawReference(reference, view, occupied_threshold);
  drawCells(image, unmatched, view, kUnmatchedColour);
  drawCells(image, matched, view, kMatchedColour);
  writePicture(path, image);
}

}  // namespace map_matcher::evaluation
