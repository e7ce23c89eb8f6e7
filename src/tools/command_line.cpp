#include "command_line.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <variant>

namespace map_matcher::tools {
namespace {

std::string optionName(const std::string& parameter) {
  std::string name = "--" + parameter;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

void addOptions(CLI::App& app, const ParameterList& parameters) {
  for (const Parameter& parameter : parameters) {
    const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
    const std::string help = parameter.description + " [" + rangeText(parameter) + unit + "]";
    std::visit([&](auto* value) { app.add_option(optionName(parameter.name), *value, help)->capture_default_str(); },
               parameter.value);
  }
}

int run(CLI::App& app, int argc, char** argv, const std::function<int()>& program) {
  try {
    app.parse(argc, argv);
    return program();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return kBadInput;
  }
}

}  // namespace map_matcher::tools
