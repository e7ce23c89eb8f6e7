/// \file
/// A folder for the files that a fuzzed reader reads.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace map_matcher::fuzz {

/// A folder of this process, in memory where there is a file system for that; it is removed at the process's end.
inline const std::filesystem::path& folder() {
  struct Folder {
    Folder() {
      const std::filesystem::path memory = "/dev/shm";
      const std::filesystem::path parent =
          std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
      path = parent / ("map_matcher_fuzz_" + std::to_string(getpid()));
      std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path;
  };
  static const Folder folder;
  return folder.path;
}

/// Writes a file there and returns its path.
inline std::string file(const std::string& name, const std::string& content) {
  const std::filesystem::path path = folder() / name;
  std::ofstream(path, std::ios::binary) << content;
  return path.string();
}

}  // namespace map_matcher::fuzz
