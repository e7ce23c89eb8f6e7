#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <vector>

#include "map_matcher/grid/map_file.hpp"
#include "support/ascii_map.hpp"
#include "support/temporary_dir.hpp"

namespace map_matcher::grid {
namespace {

using test::asciiMap;
using test::drawingOf;
using test::TemporaryDir;

constexpr const char* kKeys =
    "resolution: 0.05\norigin: [1, -2, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// A map file of the image `name` with the usual keys and `more`, beside the image.
std::string writeYaml(const TemporaryDir& dir, const std::string& name, const std::string& more = "") {
  return dir.write("map.yaml", "image: " + name + "\n" + kKeys + more);
}

/// Values of the map whose image has one row of the given pixels.
template <typename Pixel>
std::vector<int> valuesOf(const std::vector<Pixel>& pixels, const std::string& more, const std::string& keys = kKeys) {
  const TemporaryDir dir;
  cv::imwrite(dir / "map.png", cv::Mat(pixels, true).reshape(0, 1));
  const OccupancyGrid grid = loadMap(dir.write("map.yaml", "image: map.png\n" + keys + more));
  return {grid.values().begin(), grid.values().end()};
}

std::vector<int> valuesOfGrey(const std::vector<std::uint8_t>& pixels, const std::string& more,
                              const std::string& keys = kKeys) {
  return valuesOf(pixels, more, keys);
}

TEST(LoadMap, ReadsResolutionAndOriginWithYaw) {
  const TemporaryDir dir;
  dir.write("map.pgm", "P2 2 3 255  0 0  0 0  0 0\n");

  const GridGeometry geometry = loadMap(writeYaml(dir, "map.pgm")).geometry();

  EXPECT_EQ(geometry.width, 2);
  EXPECT_EQ(geometry.height, 3);
  EXPECT_DOUBLE_EQ(geometry.resolution, 0.05);
  EXPECT_DOUBLE_EQ(geometry.T_map_grid.x, 1.0);
  EXPECT_DOUBLE_EQ(geometry.T_map_grid.y, -2.0);
  EXPECT_DOUBLE_EQ(geometry.T_map_grid.yaw, 0.5);
}

TEST(LoadMap, PutsTheLastImageRowAtTheBottom) {
  const TemporaryDir dir;
  dir.write("map.pgm", "P2 3 2 255  0 254 205   254 254 0\n");

  const OccupancyGrid grid = loadMap(writeYaml(dir, "map.pgm"));

  EXPECT_EQ(drawingOf(grid), (std::vector<std::string>{"#.?",  //
                                                       "..#"}));
  EXPECT_EQ(grid.at(2, 0), kOccupied);
}

TEST(LoadMap, ComparesWithTheThresholdsAsMapServerDoes) {
  // 0.2 is exactly the occupancy of grey 204 and 0.6 that of grey 102; map_server's comparisons are strict.
  const std::string keys =
      "resolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\nmode: trinary\n";
  EXPECT_EQ(valuesOfGrey({101, 102, 103, 203, 204, 205}, "", keys), (std::vector<int>{100, -1, -1, -1, -1, 0}));
}

TEST(LoadMap, IsTrinaryWithoutAMode) { EXPECT_EQ(valuesOfGrey({0, 128, 255}, ""), (std::vector<int>{100, -1, 0})); }

TEST(LoadMap, TurnsBlackIntoFreeWhenNegated) {
  const std::string keys =
      "resolution: 1\norigin: [0, 0, 0]\nnegate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n";
  EXPECT_EQ(valuesOfGrey({0, 128, 255}, "", keys), (std::vector<int>{0, -1, 100}));
}

TEST(LoadMap, InterpolatesBetweenTheThresholdsInScaleMode) {
  // Occupancy 0.196 to 0.65 becomes 1 to 99 percent; grey 147 is (255 - 147) / 255 = 0.4235, half way.
  EXPECT_EQ(valuesOfGrey({0, 90, 147, 205, 206, 255}, "mode: scale\n"), (std::vector<int>{100, 98, 50, 1, 0, 0}));
}

TEST(LoadMap, SurvivesEqualThresholdsInScaleMode) {
  const std::string keys =
      "resolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.6\nmode: scale\n";
  EXPECT_EQ(valuesOfGrey({101, 102, 103}, "", keys), (std::vector<int>{100, 1, 0}));
}

TEST(LoadMap, TakesTransparentPixelsOfAScaleMapAsUnknown) {
  using Pixel = cv::Vec4b;
  EXPECT_EQ(valuesOf<Pixel>({Pixel(147, 147, 147, 0), Pixel(147, 147, 147, 255)}, "mode: scale\n"),
            (std::vector<int>{-1, 50}));
}

TEST(LoadMap, AveragesTheColoursWithoutAlphaInScaleMode) {
  using Pixel = cv::Vec4b;
  EXPECT_EQ(valuesOf<Pixel>({Pixel(47, 147, 247, 255)}, "mode: scale\n"), (std::vector<int>{50}));
}

TEST(LoadMap, AveragesAlphaWithTheColoursInTrinaryMode) {
  using Pixel = cv::Vec4b;  // 255, 255, 255, 0 is 191 on average: occupancy 0.25; black with alpha 255 is 63.75: 0.75
  EXPECT_EQ(valuesOf<Pixel>({Pixel(255, 255, 255, 0), Pixel(0, 0, 0, 255), Pixel(255, 255, 255, 255)}, ""),
            (std::vector<int>{-1, 100, 0}));
}

TEST(LoadMap, TakesGreyValuesAsPercentInRawMode) {
  EXPECT_EQ(valuesOfGrey({0, 1, 65, 100, 101, 255}, "mode: raw\n"), (std::vector<int>{0, 1, 65, 100, -1, -1}));
}

TEST(LoadMap, NegatesBeforeRaw) {
  const std::string keys =
      "resolution: 1\norigin: [0, 0, 0]\nnegate: true\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: raw\n";
  EXPECT_EQ(valuesOfGrey({255, 190, 0}, "", keys), (std::vector<int>{0, 65, -1}));
}

TEST(LoadMap, ReadsEveryImageFormatAndDepthAlike) {
  const cv::Mat grey = (cv::Mat_<std::uint8_t>(2, 2) << 0, 254, 205, 0);
  cv::Mat colour;
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, colour);
  cv::Mat deep;
  grey.convertTo(deep, CV_16U, 257.0);
  const TemporaryDir dir;
  const std::vector<std::pair<std::string, cv::Mat>> images = {
      {"grey.pgm", grey},     {"grey.png", grey}, {"grey.bmp", grey}, {"colour.png", colour},
      {"colour.bmp", colour}, {"deep.png", deep}, {"deep.pgm", deep}};
  for (const auto& [name, image] : images) {
    ASSERT_TRUE(cv::imwrite(dir / name, image)) << name;

    const OccupancyGrid grid = loadMap(writeYaml(dir, name));

    EXPECT_EQ(drawingOf(grid), (std::vector<std::string>{"#.", "?#"})) << name;
  }
}

TEST(LoadMap, FindsAnImageByItsAbsolutePath) {
  const TemporaryDir images;
  const TemporaryDir dir;
  const std::string image = images.write("map.pgm", "P2 1 1 255 0\n");

  EXPECT_EQ(drawingOf(loadMap(writeYaml(dir, image))), (std::vector<std::string>{"#"}));
}

TEST(LoadMap, FindsAnImageRelativeToTheMapFile) {
  const TemporaryDir dir;
  std::filesystem::create_directory(dir / "maps");
  dir.write("walls.pgm", "P2 1 1 255 0\n");
  const std::string yaml = dir.write("maps/map.yaml", std::string("image: ../walls.pgm\n") + kKeys);

  EXPECT_EQ(drawingOf(loadMap(yaml)), (std::vector<std::string>{"#"}));
}

OccupancyGrid randomGrid(std::mt19937& random, int width, int height) {
  std::uniform_int_distribution<int> value(-1, 100);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  OccupancyGrid grid(GridGeometry{0.02, width, height, {number(random), number(random), number(random)}});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      grid.at(x, y) = static_cast<std::int8_t>(value(random));
    }
  }
  return grid;
}

TEST(SaveMap, KeepsEveryValueAndTheGeometryInRawMode) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const OccupancyGrid grid = randomGrid(random, 1 + static_cast<int>(seed), 7);
    const TemporaryDir dir;

    saveMap(grid, dir / "map.yaml", MapMode::kRaw);
    const OccupancyGrid loaded = loadMap(dir / "map.yaml");

    EXPECT_EQ(loaded.values(), grid.values());
    EXPECT_EQ(loaded.resolution(), grid.resolution());
    EXPECT_EQ(loaded.geometry().T_map_grid.x, grid.geometry().T_map_grid.x);
    EXPECT_EQ(loaded.geometry().T_map_grid.y, grid.geometry().T_map_grid.y);
    EXPECT_EQ(loaded.geometry().T_map_grid.yaw, grid.geometry().T_map_grid.yaw);
  }
}

TEST(SaveMap, RoundsAsMapSaverInTrinaryMode) {
  const OccupancyGrid grid(GridGeometry{0.05, 8, 1, {}}, {-1, 0, 24, 25, 64, 65, 99, 100});
  const TemporaryDir dir;

  saveMap(grid, dir / "map.yaml");

  EXPECT_EQ(loadMap(dir / "map.yaml").values(), (std::vector<std::int8_t>{-1, 0, 0, -1, -1, 100, 100, 100}));
}

TEST(SaveMap, KeepsADrawnMap) {
  const std::vector<std::string> drawing = {"####?",  //
                                            "#..#?",  //
                                            "#...?"};
  const TemporaryDir dir;

  saveMap(asciiMap(drawing), dir / "map.yaml");

  EXPECT_EQ(drawingOf(loadMap(dir / "map.yaml")), drawing);
}

TEST(SaveMap, QuotesNamesThatYamlWouldMisread) {
  const TemporaryDir dir;
  const std::string path = dir / "office #2: \"north\".yaml";

  saveMap(asciiMap({"#."}), path);

  EXPECT_EQ(drawingOf(loadMap(path)), (std::vector<std::string>{"#."}));
}

void expectNotSaved(const std::string& path, MapMode mode, const std::string& named) {
  try {
    saveMap(asciiMap({"#."}), path, mode);
    FAIL() << path << " was written";
  } catch (const MapFileError& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
  }
}

TEST(SaveMap, SaysWhatCannotBeWritten) {
  const TemporaryDir dir;
  std::filesystem::create_directory(dir / "taken.yaml");
  expectNotSaved(dir / "absent/map.yaml", MapMode::kTrinary, dir / "absent/map.pgm");
  expectNotSaved(dir / "taken.yaml", MapMode::kTrinary, dir / "taken.yaml");
  expectNotSaved(dir / "map.yaml", MapMode::kScale, "scale");
  expectNotSaved(dir / "map.pgm", MapMode::kTrinary, ".yaml");
}

}  // namespace
}  // namespace map_matcher::grid
