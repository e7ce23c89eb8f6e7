#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/source_dir.hpp"

namespace map_matcher {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kSource = test::sourceDir();

/// The rooms below ros/, and the rooms whose headers each may include besides its own.
const std::map<std::string, Names> kRooms = {
    {"parameters", {}},
    {"files", {}},
    {"work", {}},
    {"grid", {"files", "parameters"}},
    {"scan", {"grid"}},
    {"search", {"grid", "parameters", "work"}},
    {"belief", {"grid", "parameters", "search", "work"}},
    {"fixes", {"files", "grid", "parameters"}},
    {"scrubbing", {"grid", "parameters", "scan"}},
    {"mapping", {"grid", "parameters", "scan"}},
    {"localization", {"grid", "parameters", "scan"}},
    {"simulation", {"grid", "parameters", "scan"}},
    {"evaluation", {"files", "grid", "parameters", "search"}},
    {"trials",
     {"belief", "evaluation", "files", "grid", "localization", "mapping", "parameters", "scan", "scrubbing", "search",
      "simulation"}},
};

/// The rooms in search/ that may not include the headers of others in it.
const std::map<std::string, Names> kUnknownToSearchRooms = {
    {"search/counting", {"exact", "refinement", "two_stage"}},
    {"search/refinement", {"exact", "two_stage"}},
};

/// Directories that know ROS, or whose programs may.
const Names kRosDirectories = {"nodes", "ros", "tools"};

/// An include line of a source file.
struct Include {
  fs::path file;        ///< Relative to the source directory.
  std::string header;   ///< What is included.
  bool system = false;  ///< Whether it stands in angle brackets.

  std::string library() const { return header.substr(0, header.find('/')); }
  bool isPrivate() const { return header.rfind("map_matcher/", 0) != 0; }
  bool inDirectory() const { return header.find('/') != std::string::npos; }
};

std::vector<fs::path> filesBelow(const fs::path& directory) {
  std::vector<fs::path> files;
  if (fs::is_directory(directory)) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
      if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp") {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

std::vector<Include> includesOf(const fs::path& file) {
  static const std::regex line_format(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::ifstream in(file);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, line_format)) {
      includes.push_back({file.lexically_relative(kSource), match[2], match[1] == "<"});
    }
  }
  return includes;
}

std::vector<Include> includesOfRoom(const std::string& room) {
  std::vector<Include> includes;
  for (const fs::path& directory : {kSource / "include/map_matcher" / room, kSource / "src" / room}) {
    for (const fs::path& file : filesBelow(directory)) {
      const std::vector<Include> more = includesOf(file);
      includes.insert(includes.end(), more.begin(), more.end());
    }
  }
  return includes;
}

/// Whether a room below ros/ may include a header that is not the project's own.
bool mayInclude(const std::string& room, const Include& include) {
  const bool source = include.file.extension() == ".cpp";
  const std::string library = include.library();
  if (!include.inDirectory()) {
    return true;  // the standard library
  }
  if (library == "Eigen") {
    return true;
  }
  if (library == "mrpt") {
    return source && room == "localization";
  }
  return source && Names{"nlohmann", "opencv2", "yaml-cpp"}.count(library) == 1;
}

TEST(Rooms, AreAllListedHere) {
  for (const fs::path& parent : {kSource / "include/map_matcher", kSource / "src"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(parent)) {
      const std::string name = entry.path().filename().string();
      EXPECT_TRUE(kRooms.count(name) + kRosDirectories.count(name) == 1)
          << entry.path() << " is in no room; expected one of kRooms or kRosDirectories";
    }
  }
}

TEST(Rooms, HaveIncludesToCheck) {
  EXPECT_GT(includesOfRoom("grid").size(), 20U);
  EXPECT_GT(includesOfRoom("search").size(), 20U);
}

TEST(Rooms, IncludeOnlyTheStandardLibraryEigenAndTheirOwnTools) {
  for (const auto& [room, known] : kRooms) {
    for (const Include& include : includesOfRoom(room)) {
      if (include.system) {
        EXPECT_TRUE(mayInclude(room, include))
            << include.file << " includes <" << include.header << ">; expected std, Eigen, or in a .cpp file OpenCV, "
            << "yaml-cpp, nlohmann and in localization MRPT; ROS only in ros/, nodes/ and tools/";
      }
    }
  }
}

TEST(Rooms, KnowOnlyTheRoomsBelowThem) {
  const std::regex project_header("map_matcher/([a-z]+)/([a-z_]+/)?[a-z0-9_]+\\.hpp");
  std::smatch match;
  for (const auto& [room, known] : kRooms) {
    for (const Include& include : includesOfRoom(room)) {
      if (include.system || include.isPrivate()) {
        continue;
      }
      ASSERT_TRUE(std::regex_match(include.header, match, project_header))
          << include.file << " includes \"" << include.header << "\"; expected a header of a room";
      EXPECT_TRUE(match[1] == room || known.count(match[1]) == 1)
          << include.file << " of " << room << " includes \"" << include.header << "\" of a room it may not know";
    }
  }
}

TEST(Rooms, InTheSearchKnowNoneThatUsesThem) {
  for (const auto& [room, unknown] : kUnknownToSearchRooms) {
    const std::vector<Include> includes = includesOfRoom(room);
    EXPECT_FALSE(includes.empty()) << room;
    for (const Include& include : includes) {
      for (const std::string& other : unknown) {
        EXPECT_EQ(include.header.find("/" + other + "/"), std::string::npos)
            << include.file << " includes \"" << include.header << "\" of a room it may not know";
      }
    }
  }
}

TEST(Rooms, SharePrivateHeadersWithNoOther) {
  for (const auto& [room, known] : kRooms) {
    for (const Include& include : includesOfRoom(room)) {
      if (!include.system && include.isPrivate()) {
        const fs::path header = (include.file.parent_path() / include.header).lexically_normal();
        EXPECT_EQ(header.string().rfind("src/" + room + "/", 0), 0U)
            << include.file << " includes \"" << include.header << "\", a private header of another room";
        EXPECT_TRUE(fs::exists(kSource / header)) << header;
      }
    }
  }
}

TEST(Headers, AreIncludedOnce) {
  for (const fs::path& file : filesBelow(kSource / "include")) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NE(text.find("#pragma once"), std::string::npos) << file << " has no #pragma once";
  }
}

}  // namespace
}  // namespace map_matcher
