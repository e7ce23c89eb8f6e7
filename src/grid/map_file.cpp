#include "map_matcher/grid/map_file.hpp"

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <system_error>

#include "image_size.hpp"
#include "map_description.hpp"
#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_limits.hpp"

namespace map_matcher::grid {
namespace {

namespace fs = std::filesystem;

constexpr int kSavedFreeBelow = 25;  // percent, as map_saver's threshold_free
constexpr std::uint8_t kFreeGrey = 254;
constexpr std::uint8_t kUnknownGrey = 205;
constexpr std::uint8_t kOccupiedGrey = 0;

/// The image as it is; empty when OpenCV cannot read it or refuses its size.
cv::Mat decode(const fs::path& path) {
  try {
    return cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

void requireFewPixels(std::int64_t width, std::int64_t height, const std::string& context) {
  if (height > 0 && width > kMostMapCells / height) {
    throw MapFileError(context + "has " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels, expected at most " + std::to_string(kMostMapCells) + " in all");
  }
}

/// Image with 8 bits a channel and 1, 3 or 4 channels.
cv::Mat readImage(const fs::path& path, const std::string& yaml_path) {
  const std::string context = "map file '" + yaml_path + "': image '" + path.string() + "' ";
  std::error_code unreadable;
  if (!fs::is_regular_file(path, unreadable)) {
    throw MapFileError(context + "does not exist or is not a file");
  }
  if (const std::optional<ImageSize> size = imageSize(path)) {
    requireFewPixels(size->width, size->height, context);
  }
  cv::Mat image = decode(path);
  if (image.empty()) {
    throw MapFileError(context +
                       "cannot be decoded or has no pixels; expected a PGM, PNG or BMP of at least 1 x 1 and " +
                       "at most 2^20 pixels a side");
  }
  requireFewPixels(image.cols, image.rows, context);
  if (image.depth() == CV_16U) {
    image.convertTo(image, CV_8U, 1.0 / 257.0);
  }
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3 && image.channels() != 4)) {
    throw MapFileError(context + "has an unsupported pixel format; expected 8 or 16 bits, grey or colour");
  }
  return image;
}

/// Turns one pixel into occupancy exactly as map_server does.
class PixelToOccupancy {
 public:
  explicit PixelToOccupancy(const MapDescription& description) : description_(description) {}

  std::int8_t operator()(const std::uint8_t* pixel, int channels) const {
    const bool transparent = channels == 4 && pixel[3] == 0;
    const double grey = description_.negate ? 255.0 - mean(pixel, channels) : mean(pixel, channels);
    if (description_.mode == MapMode::kRaw) {
      return grey > 100.0 ? kUnknown : static_cast<std::int8_t>(grey);
    }
    const double occupancy = (255.0 - grey) / 255.0;
    if (occupancy > description_.occupied_threshold) {
      return kOccupied;
    }
    if (occupancy < description_.free_threshold) {
      return kFree;
    }
    if (description_.mode == MapMode::kTrinary || transparent) {
      return kUnknown;
    }
    const double range = description_.occupied_threshold - description_.free_threshold;
    const double share = range > 0.0 ? (occupancy - description_.free_threshold) / range : 0.0;
    return static_cast<std::int8_t>(1.0 + 98.0 * share);
  }

 private:
  /// map_server averages the alpha channel with the colours when the mode is trinary, and only then.
  double mean(const std::uint8_t* pixel, int channels) const {
    const int averaged = channels == 4 && description_.mode != MapMode::kTrinary ? 3 : channels;
    double sum = 0.0;
    for (int c = 0; c < averaged; ++c) {
      sum += pixel[c];
    }
    return sum / averaged;
  }

  const MapDescription& description_;
};

std::uint8_t greyOf(std::int8_t value, MapMode mode) {
  if (mode == MapMode::kRaw) {
    return value == kUnknown ? std::uint8_t{255} : static_cast<std::uint8_t>(value);
  }
  if (value >= kDefaultOccupiedThreshold) {
    return kOccupiedGrey;
  }
  return value >= kFree && value < kSavedFreeBelow ? kFreeGrey : kUnknownGrey;
}

/// The grid as a PGM file.
std::string imageBytes(const OccupancyGrid& grid, MapMode mode) {
  std::string bytes = "P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n";
  bytes.reserve(bytes.size() + grid.values().size());
  for (int y = grid.height() - 1; y >= 0; --y) {
    for (int x = 0; x < grid.width(); ++x) {
      bytes.push_back(static_cast<char>(greyOf(grid.at(x, y), mode)));
    }
  }
  return bytes;
}

}  // namespace

OccupancyGrid loadMap(const std::string& yaml_path) {
  MapDescription description = readDescription(yaml_path);
  const cv::Mat image = readImage(description.image, yaml_path);
  description.geometry.width = image.cols;
  description.geometry.height = image.rows;

  OccupancyGrid grid(description.geometry);
  const PixelToOccupancy to_occupancy(description);
  for (int y = 0; y < grid.height(); ++y) {
    const std::uint8_t* row = image.ptr<std::uint8_t>(grid.height() - 1 - y);
    for (int x = 0; x < grid.width(); ++x) {
      grid.at(x, y) = to_occupancy(row + static_cast<std::ptrdiff_t>(x) * image.channels(), image.channels());
    }
  }
  return grid;
}

std::string imageNamedBy(const std::string& yaml_path) { return readDescription(yaml_path).image.string(); }

std::string imageWrittenWith(const std::string& yaml_path) {
  return fs::path(yaml_path).replace_extension(".pgm").string();
}

void saveMap(const OccupancyGrid& grid, const std::string& yaml_path, MapMode mode) {
  if (mode == MapMode::kScale) {
    throw MapFileError("map file '" + yaml_path + "': mode scale cannot be written, expected trinary or raw");
  }
  const std::string image_path = imageWrittenWith(yaml_path);
  if (files::isSameFile(image_path, yaml_path)) {
    throw MapFileError("map file '" + yaml_path + "' has the name of its image, expected a name ending in .yaml");
  }
  try {
    files::OutputFile image(image_path);
    files::OutputFile description(yaml_path);
    image.write(imageBytes(grid, mode));
    description.write(descriptionText(grid.geometry(), mode, image_path));
    image.commit();
    description.commit();
  } catch (const files::OutputFileError& error) {
    throw MapFileError(error.what());
  }
}

}  // namespace map_matcher::grid
