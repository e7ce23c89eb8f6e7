#include "image_size.hpp"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace map_matcher::grid {
namespace {

constexpr std::size_t kHeaderBytes = 4096;  // comments of a PGM file included

std::int64_t byteAt(const std::string& bytes, std::size_t index) { return static_cast<unsigned char>(bytes[index]); }

std::int64_t bigEndian(const std::string& bytes, std::size_t begin) {
  return byteAt(bytes, begin) << 24 | byteAt(bytes, begin + 1) << 16 | byteAt(bytes, begin + 2) << 8 |
         byteAt(bytes, begin + 3);
}

std::int64_t littleEndian(const std::string& bytes, std::size_t begin) {
  return byteAt(bytes, begin + 3) << 24 | byteAt(bytes, begin + 2) << 16 | byteAt(bytes, begin + 1) << 8 |
         byteAt(bytes, begin);
}

/// A number of the header of a PGM or PPM file, in which comments run from # to the end of the line.
std::optional<std::int64_t> nextNumber(std::istream& header) {
  while ((header >> std::ws).peek() == '#') {
    header.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  std::int64_t number = 0;
  return header >> number ? std::optional<std::int64_t>(number) : std::nullopt;
}

}  // namespace

std::optional<ImageSize> imageSize(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kHeaderBytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  constexpr std::size_t kPngSize = 16;
  constexpr std::size_t kBmpSize = 18;
  if (bytes.rfind("\x89PNG", 0) == 0 && bytes.size() >= kPngSize + 8) {
    return ImageSize{bigEndian(bytes, kPngSize), bigEndian(bytes, kPngSize + 4)};
  }
  if (bytes.rfind("BM", 0) == 0 && bytes.size() >= kBmpSize + 8) {
    const auto height = static_cast<std::int32_t>(littleEndian(bytes, kBmpSize + 4));  // negative from the top down
    return ImageSize{littleEndian(bytes, kBmpSize), std::abs(std::int64_t{height})};
  }
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    std::istringstream header(bytes.substr(2));
    const std::optional<std::int64_t> width = nextNumber(header);
    const std::optional<std::int64_t> height = nextNumber(header);
    return width && height ? std::optional<ImageSize>(ImageSize{*width, *height}) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace map_matcher::grid
