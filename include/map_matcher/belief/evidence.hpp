/// \file
/// What speaks for a place, or against it.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "map_matcher/belief/match_status.hpp"

namespace map_matcher::belief {

/// Which way a piece of evidence points.
enum class Bearing {
  kFor,      ///< The place may be right.
  kAgainst,  ///< The place may not be relied on.
  kSilent,   ///< Nothing can be told: not measured, too little seen, or not asked for.
};

/// "for", "against" or "silent".
const char* toString(Bearing bearing);

/// One thing that is known about a place. Messages, JSON output and tables are made from lists of these, so that a new
/// kind of evidence is one file of belief/, its line in judge(), and its test.
struct Evidence {
  std::string name;                                         ///< under_scored, of one meaning and unit for good.
  double value = std::numeric_limits<double>::quiet_NaN();  ///< What was measured; NaN: nothing.
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< What it is held against; NaN: nothing.
  Bearing bearing = Bearing::kSilent;
  MatchStatus objection = MatchStatus::kMatched;  ///< What the match comes to if this is what speaks against it.
  std::string text;                               ///< One sentence with the figures, without a full stop.
};

/// The piece of `evidence` that is called `name`; nullptr when there is none.
const Evidence* find(const std::vector<Evidence>& evidence, const std::string& name);

/// The first piece that speaks against the place; nullptr when none does.
const Evidence* firstAgainst(const std::vector<Evidence>& evidence);

}  // namespace map_matcher::belief
