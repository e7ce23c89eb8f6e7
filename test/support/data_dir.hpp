/// \file
/// Where the optional evaluation data lies: real maps and logs that the tests use when they are there.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "support/source_dir.hpp"

namespace map_matcher::test {

/// The directory of the evaluation data: the environment variable MAP_MATCHER_DATA, else ../shared/data beside the
/// source directory. std::nullopt when there is none; the test then calls GTEST_SKIP().
inline std::optional<std::filesystem::path> dataDir() {
  const char* chosen = std::getenv("MAP_MATCHER_DATA");
  const std::filesystem::path dir =
      chosen != nullptr ? std::filesystem::path(chosen) : sourceDir().parent_path() / "shared" / "data";
  std::error_code unreadable;
  if (!std::filesystem::is_directory(dir, unreadable)) {
    return std::nullopt;
  }
  return dir;
}

}  // namespace map_matcher::test
