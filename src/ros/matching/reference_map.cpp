#include "map_matcher/ros/matching/reference_map.hpp"

#include <algorithm>

namespace map_matcher::ros_matching {

belief::ReferenceMaps searched(const ReferenceMapList& references) {
  belief::ReferenceMaps maps;
  for (const ReferenceMapPtr& reference : references) {
    maps.push_back(&reference->map);
  }
  return maps;
}

ReferenceMapList::const_iterator findFrame(const ReferenceMapList& references, const std::string& frame) {
  return std::find_if(references.begin(), references.end(),
                      [&frame](const ReferenceMapPtr& reference) { return reference->frame == frame; });
}

ReferenceMapPtr onlyOne(const ReferenceMapList& references) {
  return references.size() == 1 ? references.front() : nullptr;
}

std::string frameTexts(const ReferenceMapList& references) {
  std::string texts;
  for (const ReferenceMapPtr& reference : references) {
    texts += (texts.empty() ? "\"" : ", \"") + reference->frame + "\"";
  }
  return texts;
}

}  // namespace map_matcher::ros_matching
