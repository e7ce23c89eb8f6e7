/// \file
/// Where the sources of this package lie: tests read its configuration and run its scripts.
#pragma once

#include <filesystem>
#include <string>

namespace map_matcher::test {

/// The directory of CMakeLists.txt.
std::filesystem::path sourceDir();

/// The path of a file below sourceDir().
std::string sourceFile(const std::string& relative_path);

}  // namespace map_matcher::test
