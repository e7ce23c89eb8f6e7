#include "file_roles.hpp"

#include <stdexcept>

#include "map_matcher/files/output_file.hpp"
#include "map_matcher/grid/map_file.hpp"

namespace map_matcher::tools {

void FileRoles::add(std::vector<Named>& files, const std::string& option, const std::string& path) {
  if (!path.empty() && path != "-") {
    files.push_back({option, path});
  }
}

FileRoles& FileRoles::reads(const std::string& option, const std::string& path) {
  add(read_, option, path);
  return *this;
}

FileRoles& FileRoles::writes(const std::string& option, const std::string& path) {
  add(written_, option, path);
  return *this;
}

FileRoles& FileRoles::readsMap(const std::string& option, const std::string& yaml_path) {
  if (!yaml_path.empty()) {
    add(read_, option, yaml_path);
    add(read_, "the image of " + option, grid::imageNamedBy(yaml_path));
  }
  return *this;
}

FileRoles& FileRoles::writesMap(const std::string& option, const std::string& yaml_path) {
  if (!yaml_path.empty()) {
    add(written_, option, yaml_path);
    add(written_, "the image of " + option, grid::imageWrittenWith(yaml_path));
  }
  return *this;
}

void FileRoles::requireDistinct() const {
  std::vector<Named> others = read_;
  for (const Named& file : written_) {
    for (const Named& other : others) {
      if (files::isSameFile(file.path, other.path)) {
        throw std::invalid_argument(file.option + " is '" + file.path + "', the same file as " + other.option + ", '" +
                                    other.path + "'; expected another file");
      }
    }
    others.push_back(file);
  }
}

}  // namespace map_matcher::tools
