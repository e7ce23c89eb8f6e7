#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "map_matcher/ros/matching/map_url.hpp"
#include "support/thrown_text.hpp"

namespace map_matcher::ros_matching {
namespace {

TEST(MapUrl, NamesAPath) {
  EXPECT_EQ(pathOfMapUrl("/maps/floor1.yaml"), "/maps/floor1.yaml");
  EXPECT_EQ(pathOfMapUrl("maps/floor1.yaml"), "maps/floor1.yaml");
  EXPECT_EQ(pathOfMapUrl("file:///maps/floor1.yaml"), "/maps/floor1.yaml");
}

TEST(MapRoot, HoldsTheMapAndItsImageWhateverLinksLeadThere) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "map_root";
  fs::remove_all(folder);
  fs::create_directories(folder / "maps");
  const auto write = [](const fs::path& path, const std::string& image) {
    std::ofstream(path) << "image: " << image
                        << "\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
  };
  write(folder / "maps/inside.yaml", "inside.pgm");
  write(folder / "maps/image_outside.yaml", "../outside.pgm");
  write(folder / "outside.yaml", "outside.pgm");
  fs::create_symlink(folder / "outside.yaml", folder / "maps/link.yaml");
  const std::string root = folder / "maps";
  const auto problem = [&root](const fs::path& path) {
    return test::thrownText<std::invalid_argument>([&] { requireMapBelow(root, path); });
  };

  EXPECT_NO_THROW(requireMapBelow(root, folder / "maps/inside.yaml"));
  EXPECT_NO_THROW(requireMapBelow(root + "/", folder / "maps/../maps/inside.yaml"));
  EXPECT_NO_THROW(requireMapBelow("", folder / "outside.yaml"));
  for (const fs::path& path : {folder / "outside.yaml", folder / "maps/../outside.yaml", folder / "maps/link.yaml",
                               folder / "maps/image_outside.yaml", fs::path(root + "_beside/map.yaml")}) {
    EXPECT_NE(problem(path).find("expected a map below ~map_root"), std::string::npos) << path;
  }
}

TEST(MapUrl, OfAnotherKindIsRefusedByItsName) {
  EXPECT_EQ(test::thrownText<std::invalid_argument>([] { pathOfMapUrl("http://maps/floor1.yaml"); }),
            "map_url is \"http://maps/floor1.yaml\", expected a path or file:///PATH");
}

}  // namespace
}  // namespace map_matcher::ros_matching
