// A YAML file of parameters: they keep to their ranges, or what is wrong is told with std::invalid_argument.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "file_in_memory.hpp"
#include "map_matcher/belief/match_options.hpp"
#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/parameters/yaml_parameters.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  const std::string path = fuzz::file("parameters.yaml", std::string(reinterpret_cast<const char*>(data), size));
  belief::MatchOptions options;
  const parameters::ParameterList parameters = parametersOf(options);
  try {
    parameters::loadYamlParameters(path, parameters);
  } catch (const std::invalid_argument&) {
    return 0;
  }
  if (!parameters::problemsOf(parameters).empty()) {
    __builtin_trap();
  }
  return 0;
}
