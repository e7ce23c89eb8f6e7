#include "picture_file.hpp"

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "map_matcher/files/output_file.hpp"

namespace map_matcher::evaluation {

void writePicture(const std::string& path, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  bool is_encoded = false;
  try {
    is_encoded = cv::imencode(std::filesystem::path(path).extension().string(), image, bytes);
  } catch (const cv::Exception&) {
    is_encoded = false;
  }
  if (!is_encoded) {
    throw std::runtime_error("picture '" + path + "' cannot be written; expected a path ending in .png");
  }
  files::writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace map_matcher::evaluation
