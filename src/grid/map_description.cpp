#include "map_description.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <sstream>
#include <system_error>
#include <vector>

#include "map_matcher/grid/map_limits.hpp"
#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::grid {
namespace {

namespace fs = std::filesystem;

constexpr double kSavedOccupiedThreshold = 0.65;
constexpr double kSavedFreeThreshold = 0.196;

/// Reads the keys of one YAML file; every error names the file and the key.
class DescriptionReader {
 public:
  explicit DescriptionReader(const std::string& path) : path_(path) {
    std::error_code unreadable;
    if (!fs::is_regular_file(path, unreadable)) {
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
    description.image = readImagePath();
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
    if (!root_[key] || root_[key].IsNull()) {
      throw MapFileError("map file '" + path_ + "': " + key + " is missing, expected " + expected);
    }
    try {
      return root_[key].as<T>();
    } catch (const YAML::Exception&) {
      fail(key, text(key), expected);
    }
  }

  fs::path readImagePath() const {
    const char* expected = "the name of an image file";
    const fs::path image = get<std::string>("image", expected);
    if (image.empty()) {
      fail("image", text("image"), expected);
    }
    return fs::path(path_).parent_path() / image;  // an absolute image path stays as it is
  }

  double readResolution() const {
    const std::string expected = "a positive number of metres per cell, " + parameters::numberText(kMinMapResolution) +
                                 " to " + parameters::numberText(kMaxMapResolution);
    const auto value = get<double>("resolution", expected);
    if (!(value >= kMinMapResolution && value <= kMaxMapResolution)) {
      fail("resolution", text("resolution"), expected);
    }
    return value;
  }

  Rigid2 readOrigin() const {
    const std::string expected = "[x, y, yaw], three finite numbers in metres and radians, x and y within " +
                                 parameters::numberText(kMaxMapOrigin) + " m";
    const auto values = get<std::vector<double>>("origin", expected);
    if (values.size() != 3 || !(std::abs(values[0]) <= kMaxMapOrigin) || !(std::abs(values[1]) <= kMaxMapOrigin) ||
        !std::isfinite(values[2])) {
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
    if (!root_["mode"]) {  // map_server's files had none before there was a choice
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

/// A string as YAML reads it back, whatever characters it holds.
std::string quoted(const std::string& text) {
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

}  // namespace

MapDescription readDescription(const std::string& yaml_path) { return DescriptionReader(yaml_path).read(); }

std::string descriptionText(const GridGeometry& geometry, MapMode mode, const fs::path& image) {
  const Rigid2& origin = geometry.T_map_grid;
  std::ostringstream out;
  out << "image: " << quoted(image.filename().string())
      << "\nresolution: " << parameters::numberText(geometry.resolution) << "\norigin: ["
      << parameters::numberText(origin.x) << ", " << parameters::numberText(origin.y) << ", "
      << parameters::numberText(origin.yaw)
      << "]\nnegate: 0\noccupied_thresh: " << parameters::numberText(kSavedOccupiedThreshold)
      << "\nfree_thresh: " << parameters::numberText(kSavedFreeThreshold)
      << "\nmode: " << (mode == MapMode::kRaw ? "raw" : "trinary") << "\n";
  return out.str();
}

}  // namespace map_matcher::grid
