/// \file
/// Everything that was found of a session map, before it is judged.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/belief/free_space.hpp"
#include "map_matcher/search/search_result.hpp"

namespace map_matcher::belief {

/// A place that the session map may lie at.
struct Candidate {
  search::Place place;
  FreeSpace space;      ///< How both maps' walls lie in the other one's free space there.
  std::size_t map = 0;  ///< The reference map that it is in, by its number.
  double worth = 0.0;   ///< worthOf() it, and what else speaks for it.
};

/// What a search found in one or several reference maps.
struct Findings {
  /// Of the reference map with the candidate that is worth most, whose pose is its pose, and whose runner_up, margin
  /// and runner_up_proven are about what the candidates are worth instead of their hits. Of a search without proof: as
  /// it was.
  search::SearchResult search;
  std::size_t map = 0;                  ///< The number of that reference map.
  std::vector<Candidate> candidates{};  ///< Those of an exact search, the one worth most first.
  double elsewhere_bound = 1.0;         ///< No other place in any of the maps is worth more; proven.
  double elsewhere_worth = 1.0;         ///< The same with what is known beside the map, as the candidates have it.
  std::vector<search::SearchResult> results{};  ///< Of all the reference maps, by their numbers; of an exact search.
  bool followed = false;                        ///< Whether only the place in use was looked at, without a proof.
};

/// What a place with these hits is worth: its share of hits, less half the share of the reference map's walls that the
/// session saw through. People and moved furniture are no argument against a place: they are the same everywhere.
double worthOf(double hit_ratio, const FreeSpace& space);

/// By how much the first candidate is ahead of all others: in what it is worth, or in hits if that is more, since walls
/// that a session sees through everywhere, as in a map that is out of date, tell no place from another.
double leadOf(const Findings& findings);

/// By how much the first candidate is at least worth more than any other place, found or not; below 0 when it may be
/// worth less.
double provenLeadOf(const Findings& findings);

/// The findings in one map after the other: `results` and the candidates in them, the one worth most first, and what
/// follows from that for margin and runner-up. `margin` is search::Demand::margin.
Findings rank(const std::vector<search::SearchResult>& results, std::vector<Candidate> candidates, double margin);

}  // namespace map_matcher::belief
