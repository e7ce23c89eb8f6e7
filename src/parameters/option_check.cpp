#include "map_matcher/parameters/option_check.hpp"

#include <stdexcept>

namespace map_matcher::parameters {

std::vector<std::string> problemsOf(const ParameterList& parameters) {
  std::vector<std::string> problems;
  for (const Parameter& parameter : parameters) {
    std::string problem = problemWith(parameter);
    if (!problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
  return problems;
}

void throwIfAny(const std::vector<std::string>& problems) {
  if (problems.empty()) {
    return;
  }
  std::string text;
  for (const std::string& problem : problems) {
    text += (text.empty() ? "" : "; ") + problem;
  }
  throw std::invalid_argument(text);
}

}  // namespace map_matcher::parameters
