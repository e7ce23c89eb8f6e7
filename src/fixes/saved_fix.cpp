#include "map_matcher/fixes/saved_fix.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <system_error>
#include <vector>

#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/pose_covariance.hpp"
#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::fixes {
namespace {

constexpr int kVersion = 1;
constexpr std::size_t kDigits = 16;  // of the digest
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

std::string digestText(std::uint64_t digest) {
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(kDigits) << digest;
  return text.str();
}

std::string listText(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "" : ", ") + parameters::numberText(value);
  }
  return "[" + text + "]";
}

/// Reads the keys of one file.
class FixReader {
 public:
  explicit FixReader(const std::string& path) : path_(path) {
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(path, unreadable)) {
      throw FixFileError(path, "does not exist or is not a file");
    }
    try {
      root_ = YAML::LoadFile(path);
    } catch (const YAML::Exception& error) {
      throw FixFileError(path, std::string("is not readable YAML: ") + error.what());
    }
    if (!root_.IsMap()) {
      throw FixFileError(path, "holds no 'key: value' lines");
    }
  }

  SavedFix read() const {
    if (as<int>("version", "the number of the file's format") != kVersion) {
      fail("version", std::to_string(kVersion));
    }
    SavedFix fix;
    fix.reference_map = as<std::string>("reference_map", "the name of a map");
    fix.reference_digest = readDigest();
    fix.pose.stamp = as<double>("stamp", "a finite number");
    if (!std::isfinite(fix.pose.stamp)) {
      fail("stamp", "a finite number");
    }
    const std::vector<double> pose = numbers("pose", 3);
    fix.pose.T_reference_base = {pose[0], pose[1], grid::normalizeAngle(pose[2])};
    fix.pose.covariance = Eigen::Map<const RowMajor>(numbers("covariance", 9).data());
    const std::string problem = grid::problemWithCovariance(fix.pose.covariance);
    if (!problem.empty()) {
      throw FixFileError(path_, problem);
    }
    return fix;
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& expected) const {
    const YAML::Node node = root_[key];
    throw FixFileError(path_, key + (node ? " is " + YAML::Dump(node) : " is missing") + ", expected " + expected);
  }

  template <typename T>
  T as(const std::string& key, const std::string& expected) const {
    try {
      return root_[key].as<T>();
    } catch (const YAML::Exception&) {
      fail(key, expected);
    }
  }

  std::uint64_t readDigest() const {
    const std::string expected = std::to_string(kDigits) + " hexadecimal digits";
    const auto text = as<std::string>("reference_digest", expected);
    if (text.size() != kDigits || text.find_first_not_of("0123456789abcdef") != std::string::npos) {
      fail("reference_digest", expected);
    }
    return std::stoull(text, nullptr, 16);
  }

  std::vector<double> numbers(const std::string& key, std::size_t count) const {
    const std::string expected = "a list of " + std::to_string(count) + " finite numbers";
    auto values = as<std::vector<double>>(key, expected);
    if (values.size() != count) {
      fail(key, expected);
    }
    for (const double value : values) {
      if (!std::isfinite(value)) {
        fail(key, expected);
      }
    }
    return values;
  }

  std::string path_;
  YAML::Node root_;
};

}  // namespace

SavedFix loadFix(const std::string& path) { return FixReader(path).read(); }

void saveFix(const SavedFix& fix, const std::string& path) {
  const grid::Rigid2& pose = fix.pose.T_reference_base;
  RowMajor covariance = fix.pose.covariance;
  YAML::Emitter name;
  name << YAML::DoubleQuoted << fix.reference_map;
  std::ostringstream text;
  text << "# Where the robot was last, as map_matcher knew it: a hint for the next start in the same map.\n"
       << "version: " << kVersion << "\n"
       << "reference_map: " << name.c_str() << "\n"
       << "reference_digest: \"" << digestText(fix.reference_digest) << "\"\n"
       << "stamp: " << parameters::numberText(fix.pose.stamp) << "  # [s]\n"
       << "pose: " << listText({pose.x, pose.y, pose.yaw})
       << "  # x, y, yaw [m, m, rad]\n"
       // The last one: its closing bracket is the sign that the file is whole.
       << "covariance: " << listText({covariance.data(), covariance.data() + covariance.size()}) << "\n";
  files::writeFile(path, text.str());
}

}  // namespace map_matcher::fixes
