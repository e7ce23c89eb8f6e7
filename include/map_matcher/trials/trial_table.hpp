/// \file
/// The queries of a trial as a table.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/trials/trial_query.hpp"

namespace map_matcher::trials {

/// The queries as CSV with a header line, a row each: session, time, session_age, travelled; status, matched, ratio,
/// search_time; for both stages ratio, initialization_time, rotation_expansion_time, depth_first_search_time;
/// certified, hit_ratio, upper_bound, margin of the exact search and exact_time, which it took; alignment_x, _y, _yaw
/// and their errors against the true alignment of the maps (report figure 10b); heading_drift, the error of the robot's
/// heading in the session map, which bends walls that are parallel in truth; the robot's estimated and true pose and
/// the error between them; occupied and falsely_occupied cells; the maps
/// around the robot; evidence, each piece as name:bearing; drive; the best place that was found, believed or not, as
/// candidate_x, _y, _yaw, with its errors: candidate_error and candidate_rotation_error of the robot's pose,
/// candidate_map_error and candidate_map_rotation_error of the middle of the session map. Then all else that answers
/// tell in numbers, as `answer.<name>`, and the value of each piece of evidence, as `evidence.<name>`. Units are s, m,
/// rad and cells; what is not known is empty.
std::string toCsv(const std::vector<TrialQuery>& queries);

}  // namespace map_matcher::trials
