#include "map_matcher/parameters/nearest_name.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string_view>
#include <vector>

namespace map_matcher::parameters {
namespace {

/// Number of insertions, deletions and replacements of characters that turn one text into the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearestName(const std::string& name, const std::vector<std::string>& known) {
  const auto distance = [&name](const std::string& other) { return editDistance(name, other); };
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  if (nearest == known.end() || 3 * distance(*nearest) > std::max(name.size(), nearest->size())) {
    return std::nullopt;
  }
  return *nearest;
}

std::optional<std::string> nearestName(const std::string& name, const ParameterList& parameters) {
  std::vector<std::string> known;
  std::transform(parameters.begin(), parameters.end(), std::back_inserter(known),
                 [](const Parameter& parameter) { return parameter.name; });
  return nearestName(name, known);
}

}  // namespace map_matcher::parameters
