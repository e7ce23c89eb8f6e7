/// \file
/// How large an image is, before it is decoded. Private to map_file.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace map_matcher::grid {

/// Width and height [pixels].
struct ImageSize {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// The size that the header of a PGM, PPM, PNG or BMP file tells; nothing for other files.
std::optional<ImageSize> imageSize(const std::filesystem::path& path);

}  // namespace map_matcher::grid
