/// \file
/// Which files a program reads and which it writes.
#pragma once

#include <string>
#include <vector>

namespace map_matcher::tools {

/// The files that a program reads and writes, by the options that name them. Empty names are passed over.
class FileRoles {
 public:
  FileRoles& reads(const std::string& option, const std::string& path);
  FileRoles& writes(const std::string& option, const std::string& path);

  /// A map file, with its image. Throws MapFileError for a map file that cannot be read.
  FileRoles& readsMap(const std::string& option, const std::string& yaml_path);
  FileRoles& writesMap(const std::string& option, const std::string& yaml_path);

  /// Throws std::invalid_argument when a file that is written is read or written by another option as well, under
  /// whatever name.
  void requireDistinct() const;

 private:
  struct Named {
    std::string option;
    std::string path;
  };
  static void add(std::vector<Named>& files, const std::string& option, const std::string& path);

  std::vector<Named> read_;
  std::vector<Named> written_;
};

}  // namespace map_matcher::tools
