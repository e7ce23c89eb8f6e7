#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "map_matcher/grid/map_file.hpp"
#include "support/temporary_dir.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::grid {
namespace {

using test::TemporaryDir;

constexpr const char* kGoodMap =
    "image: map.pgm\nresolution: 0.05\norigin: [1, -2, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// A map file that must be refused, and what the message has to name besides the file.
struct BadMap {
  std::string name;
  std::string yaml;
  std::vector<std::string> named;
};

/// The good map with the line of one key replaced or added.
std::string withLine(const std::string& line) {
  const std::string key = line.substr(0, line.find(':') + 1);
  std::string keys = kGoodMap;
  const std::size_t begin = keys.find(key);
  if (begin == std::string::npos) {
    return keys + line + "\n";
  }
  return keys.replace(begin, keys.find('\n', begin) - begin, line);
}

/// The good map without one key.
std::string without(const std::string& key) {
  std::string keys = kGoodMap;
  const std::size_t begin = keys.find(key + ":");
  return keys.erase(begin, keys.find('\n', begin) + 1 - begin);
}

class BadMapFile : public testing::TestWithParam<BadMap> {};

TEST_P(BadMapFile, IsRefusedWithItsKeyItsValueAndWhatWasExpected) {
  const TemporaryDir dir;
  dir.write("map.pgm", "P2 1 1 255 0\n");
  const std::string path = dir.write("map.yaml", GetParam().yaml);

  try {
    loadMap(path);
    FAIL() << "the map was accepted";
  } catch (const MapFileError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(path), std::string::npos) << message;
    for (const std::string& part : GetParam().named) {
      EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
    }
  }
}

const BadMap kBadMaps[] = {
    {"Empty", "", {"expected", "key: value"}},
    {"NotYaml", "image: [", {"YAML"}},
    {"List", "- image\n- resolution\n", {"expected", "key: value"}},
    {"ImageMissing", without("image"), {"image is missing", "name of an image file"}},
    {"ImageNull", withLine("image:"), {"image is missing", "name of an image file"}},
    {"ImageEmpty", withLine("image: ''"), {"image is", "expected the name of an image file"}},
    {"ImageAbsent", withLine("image: absent.pgm"), {"absent.pgm", "does not exist"}},
    {"ImageIsDirectory", withLine("image: ."), {"is not a file"}},
    {"ImageNameTooLong", withLine("image: " + std::string(300, 'a') + ".pgm"), {"does not exist"}},
    {"ResolutionMissing", without("resolution"), {"resolution is missing", "positive number of metres"}},
    {"ResolutionZero", withLine("resolution: 0"), {"resolution is 0", "expected a positive number of metres"}},
    {"ResolutionNegative", withLine("resolution: -0.05"), {"resolution is -0.05", "positive number of metres"}},
    {"ResolutionNan", withLine("resolution: .nan"), {"resolution is .nan", "positive number of metres"}},
    {"ResolutionInfinite", withLine("resolution: .inf"), {"resolution is .inf", "positive number of metres"}},
    {"ResolutionTooFine", withLine("resolution: 1e-9"), {"resolution is 1e-9", "0.001 to 10"}},
    {"ResolutionTooCoarse", withLine("resolution: 1e9"), {"resolution is 1e9", "0.001 to 10"}},
    {"ResolutionText", withLine("resolution: 5cm"), {"resolution is 5cm", "positive number of metres"}},
    {"OriginMissing", without("origin"), {"origin is missing", "[x, y, yaw]"}},
    {"OriginTooShort", withLine("origin: [1, 2]"), {"origin is [1, 2]", "[x, y, yaw]"}},
    {"OriginNan", withLine("origin: [1, .nan, 0]"), {"origin is [1, .nan, 0]", "[x, y, yaw]"}},
    {"OriginTooFar", withLine("origin: [1e300, 0, 0]"), {"origin is [1e300, 0, 0]", "within 1000000 m"}},
    {"OriginText", withLine("origin: here"), {"origin is here", "[x, y, yaw]"}},
    {"NegateMissing", without("negate"), {"negate is missing", "0 or 1"}},
    {"NegateTwo", withLine("negate: 2"), {"negate is 2", "0 or 1"}},
    {"OccupiedMissing", without("occupied_thresh"), {"occupied_thresh is missing", "0 to 1"}},
    {"OccupiedAboveOne", withLine("occupied_thresh: 65"), {"occupied_thresh is 65", "0 to 1"}},
    {"FreeMissing", without("free_thresh"), {"free_thresh is missing", "0 to 1"}},
    {"FreeNegative", withLine("free_thresh: -0.1"), {"free_thresh is -0.1", "0 to 1"}},
    {"FreeNan", withLine("free_thresh: .nan"), {"free_thresh is .nan", "0 to 1"}},
    {"UpsideDown", withLine("free_thresh: 0.7"), {"free_thresh is 0.7", "0.65", "upside down"}},
    {"ModeUnknown", withLine("mode: binary"), {"mode is binary", "trinary, scale or raw"}},
};

INSTANTIATE_TEST_SUITE_P(LoadBadMap, BadMapFile, testing::ValuesIn(kBadMaps),
                         [](const auto& tested) { return tested.param.name; });

/// A file that is no image.
struct BadImage {
  std::string name;
  std::string bytes;
};

class BadImageFile : public testing::TestWithParam<BadImage> {};

TEST_P(BadImageFile, IsRefusedByName) {
  const TemporaryDir dir;
  const std::string image = dir.write("map.pgm", GetParam().bytes);
  try {
    loadMap(dir.write("map.yaml", kGoodMap));
    FAIL() << "the map was accepted";
  } catch (const MapFileError& error) {
    EXPECT_NE(std::string(error.what()).find(image), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
  }
}

const BadImage kBadImages[] = {
    {"Empty", ""},
    {"Text", "this is no image"},
    {"ZeroByZero", "P5 0 0 255\n"},
    {"ZeroHeight", "P5 3 0 255\n"},
    {"Truncated", "P5 4 4 255\nabc"},
    {"Huge", "P5 2000000000 2000000000 255\n"},
    {"TooManyPixels", "P5\n# 400 million\n20000 20000\n255\n"},
    {"NegativeSize", "P5 -3 -3 255\n"},
};

INSTANTIATE_TEST_SUITE_P(LoadBadMap, BadImageFile, testing::ValuesIn(kBadImages),
                         [](const auto& tested) { return tested.param.name; });

/// The first bytes of an image of 20,000 x 20,000 pixels.
const BadImage kLargeImages[] = {
    {"Pgm", "P5\n# 400 million\n20000 20000\n255\n"},
    {"Png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x4e\x20\0\0\x4e\x20\x8\0\0\0\0", 29)},
    {"Bmp", "BM" + std::string(12, '\0') + std::string("\x28\0\0\0\x20\x4e\0\0\xe0\xb1\xff\xff\1\0\x8\0", 16)},
};

class LargeImageFile : public testing::TestWithParam<BadImage> {};

TEST_P(LargeImageFile, IsRefusedByItsHeader) {
  const TemporaryDir dir;
  dir.write("map.pgm", GetParam().bytes);
  const std::string map = dir.write("map.yaml", kGoodMap);

  const std::string refusal = test::thrownText<MapFileError>([&] { loadMap(map); });

  EXPECT_NE(refusal.find("has 20000 x 20000 pixels, expected at most 268435456 in all"), std::string::npos) << refusal;
}

INSTANTIATE_TEST_SUITE_P(LoadBadMap, LargeImageFile, testing::ValuesIn(kLargeImages),
                         [](const auto& tested) { return tested.param.name; });

TEST(LoadBadMap, NamesAMapFileThatDoesNotExist) {
  const TemporaryDir dir;
  for (const std::string& path : {dir / "absent.yaml", dir / ".", dir / std::string(300, 'a')}) {
    try {
      loadMap(path);
      FAIL() << path << " was accepted";
    } catch (const MapFileError& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace map_matcher::grid
