#include "support/source_dir.hpp"

namespace map_matcher::test {

std::filesystem::path sourceDir() { return MAP_MATCHER_SOURCE_DIR; }

std::string sourceFile(const std::string& relative_path) { return (sourceDir() / relative_path).string(); }

}  // namespace map_matcher::test
