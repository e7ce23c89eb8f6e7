#include "map_matcher/belief/evidence.hpp"

#include <algorithm>

namespace map_matcher::belief {
namespace {

template <typename Predicate>
const Evidence* firstOf(const std::vector<Evidence>& evidence, const Predicate& predicate) {
  const auto found = std::find_if(evidence.begin(), evidence.end(), predicate);
  return found != evidence.end() ? &*found : nullptr;
}

}  // namespace

const char* toString(Bearing bearing) {
  switch (bearing) {
    case Bearing::kFor:
      return "for";
    case Bearing::kAgainst:
      return "against";
    case Bearing::kSilent:
      return "silent";
  }
  return "unknown";
}

const Evidence* find(const std::vector<Evidence>& evidence, const std::string& name) {
  return firstOf(evidence, [&name](const Evidence& piece) { return piece.name == name; });
}

const Evidence* firstAgainst(const std::vector<Evidence>& evidence) {
  return firstOf(evidence, [](const Evidence& piece) { return piece.bearing == Bearing::kAgainst; });
}

}  // namespace map_matcher::belief
