#include "map_matcher/grid/map_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace map_matcher {
namespace {

namespace fs = std::filesystem;

constexpr double kSavedOccupiedThreshold = 0.65;
constexpr double kSavedFreeThreshold = 0.196;
constexpr int kSavedFreeBelow = 25;  // percent, as map_saver's threshold_free
constexpr std::uint8_t kFreeGrey = 254;
constexpr std::uint8_t kUnknownGrey = 205;
constexpr std::uint8_t kOccupiedGrey = 0;

/// What a map_server YAML file says.
struct MapDescription {
  fs::path image;
  GridGeometry geometry;  // without the size
  double occupied_threshold = 0.0;
  double free_threshold = 0.0;
  bool negate = false;
  MapMode mode = MapMode::kTrinary;
};

/// Reads the keys of one YAML file; every error names the file and the key.
class DescriptionReader {
 public:
  explicit DescriptionReader(const std::string& path) : path_(path) {
    if (!fs::is_regular_file(path)) {
      throw MapFileError("map file '" + path + "' does not exist or is not a file");
    }
    try {
      root_ = YAML::LoadFile(path);
    } catch (const YAML::Exception& error) {
      throw MapFileError("map file '" + path + "' is not readable YAML: " + error.what());
    }
    if (!root_.IsMap()) {
      throw MapFileError("map file '" + path + "' holds no 'key: value' lines; expected map_server's YAML format");
    }
  }

  MapDescription read() const {
    MapDescription description;
    description.image = fs::path(get<std::string>("image", "the name of an image file"));
    if (description.image.empty()) {
      fail("image", "''", "the name of an image file");
    }
    if (description.image.is_relative()) {
      description.image = fs::path(path_).parent_path() / description.image;
    }
    description.geometry.resolution = readResolution();
    description.geometry.T_map_grid = readOrigin();
    description.occupied_threshold = readThreshold("occupied_thresh");
    description.free_threshold = readThreshold("free_thresh");
    if (description.free_threshold > description.occupied_threshold) {
      fail("free_thresh", text("free_thresh"),
           "at most occupied_thresh (" + text("occupied_thresh") + "); the two are upside down");
    }
    description.negate = readNegate();
    description.mode = readMode();
    return description;
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& expected) const {
    throw MapFileError("map file '" + path_ + "': " + key + " is " + value + ", expected " + expected);
  }

  std::string text(const std::string& key) const { return YAML::Dump(root_[key]); }

  template <typename T>
  T get(const std::string& key, const std::string& expected) const {
    if (!root_[key]) {
      throw MapFileError("map file '" + path_ + "': " + key + " is missing, expected " + expected);
    }
    try {
      return root_[key].as<T>();
    } catch (const YAML::Exception&) {
      fail(key, text(key), expected);
    }
  }

  double readResolution() const {
    const char* expected = "a positive number of metres per cell";
    const auto value = get<double>("resolution", expected);
    if (!std::isfinite(value) || value <= 0.0) {
      fail("resolution", text("resolution"), expected);
    }
    return value;
  }

  Rigid2 readOrigin() const {
    const char* expected = "[x, y, yaw], three finite numbers in metres and radians";
    const auto values = get<std::vector<double>>("origin", expected);
    if (values.size() != 3 || !std::isfinite(values[0]) || !std::isfinite(values[1]) || !std::isfinite(values[2])) {
      fail("origin", text("origin"), expected);
    }
    return {values[0], values[1], normalizeAngle(values[2])};
  }

  double readThreshold(const std::string& key) const {
    const char* expected = "a probability from 0 to 1";
    const auto value = get<double>(key, expected);
    if (!(value >= 0.0 && value <= 1.0)) {
      fail(key, text(key), expected);
    }
    return value;
  }

  bool readNegate() const {
    const char* expected = "0 or 1";
    const auto value = get<std::string>("negate", expected);
    if (value == "0" || value == "false" || value == "False") {
      return false;
    }
    if (value == "1" || value == "true" || value == "True") {
      return true;
    }
    fail("negate", text("negate"), expected);
  }

  MapMode readMode() const {
    if (!root_["mode"]) {
      return MapMode::kTrinary;
    }
    const char* expected = "trinary, scale or raw";
    const auto value = get<std::string>("mode", expected);
    if (value == "trinary") {
      return MapMode::kTrinary;
    }
    if (value == "scale") {
      return MapMode::kScale;
    }
    if (value == "raw") {
      return MapMode::kRaw;
    }
    fail("mode", text("mode"), expected);
  }

  std::string path_;
  YAML::Node root_;
};

/// Image with 8 bits a channel and 1, 3 or 4 channels.
cv::Mat readImage(const fs::path& path, const std::string& yaml_path) {
  const std::string context = "map file '" + yaml_path + "': image '" + path.string() + "' ";
  if (!fs::is_regular_file(path)) {
    throw MapFileError(context + "does not exist or is not a file");
  }
  cv::Mat image;
  try {
    image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw MapFileError(context + "cannot be decoded: " + error.what());
  }
  if (image.empty()) {
    throw MapFileError(context + "cannot be decoded or has no pixels; expected a PGM, PNG or BMP of at least 1 x 1");
  }
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
  /// map_server averages the alpha channel too, unless the mode is trinary.
  double mean(const std::uint8_t* pixel, int channels) const {
    const int averaged = channels == 4 && description_.mode == MapMode::kTrinary ? 3 : channels;
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

void writeDescription(const OccupancyGrid& grid, const fs::path& yaml_path, const fs::path& image, MapMode mode) {
  const GridGeometry& geometry = grid.geometry();
  std::ofstream out(yaml_path);
  out << std::setprecision(17) << "image: " << image.filename().string() << "\nresolution: " << geometry.resolution
      << "\norigin: [" << geometry.T_map_grid.x << ", " << geometry.T_map_grid.y << ", " << geometry.T_map_grid.yaw
      << "]\nnegate: 0\noccupied_thresh: " << kSavedOccupiedThreshold << "\nfree_thresh: " << kSavedFreeThreshold
      << "\nmode: " << (mode == MapMode::kRaw ? "raw" : "trinary") << "\n";
  if (!out.flush()) {
    throw MapFileError("map file '" + yaml_path.string() + "' cannot be written");
  }
}

}  // namespace

OccupancyGrid loadMap(const std::string& yaml_path) {
  MapDescription description = DescriptionReader(yaml_path).read();
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

void saveMap(const OccupancyGrid& grid, const std::string& yaml_path, MapMode mode) {
  if (mode == MapMode::kScale) {
    throw MapFileError("map file '" + yaml_path + "': mode scale cannot be written, expected trinary or raw");
  }
  const fs::path image_path = fs::path(yaml_path).replace_extension(".pgm");
  cv::Mat image(grid.height(), grid.width(), CV_8UC1);
  for (int y = 0; y < grid.height(); ++y) {
    std::uint8_t* row = image.ptr<std::uint8_t>(grid.height() - 1 - y);
    for (int x = 0; x < grid.width(); ++x) {
      row[x] = greyOf(grid.at(x, y), mode);
    }
  }
  bool written = false;
  try {
    written = cv::imwrite(image_path.string(), image);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) {
    throw MapFileError("image '" + image_path.string() + "' cannot be written");
  }
  writeDescription(grid, yaml_path, image_path, mode);
}

}  // namespace map_matcher
