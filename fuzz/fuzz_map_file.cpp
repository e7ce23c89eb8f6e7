// A map's YAML file and the image that it names, with a zero between them: read, or refused with MapFileError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "file_in_memory.hpp"
#include "map_matcher/grid/map_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = input.find('\0');
  const std::string image = end == std::string::npos ? "" : input.substr(end + 1);
  fuzz::file("map.pgm", image);
  const std::string yaml = fuzz::file("map.yaml", "image: map.pgm\n" + input.substr(0, end));
  try {
    const grid::OccupancyGrid map = grid::loadMap(yaml);
    if (map.values().size() != static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height())) {
      __builtin_trap();
    }
  } catch (const grid::MapFileError&) {
    return 0;
  }
  return 0;
}
