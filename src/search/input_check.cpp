#include "input_check.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include "map_matcher/search/counting/session_cells.hpp"

namespace map_matcher::search {
namespace {

SearchResult ended(SearchEnding ending, const std::string& reason) {
  SearchResult result;
  result.ending = ending;
  result.reason = reason;
  return result;
}

}  // namespace

std::optional<SearchResult> checkInput(const SearchReference& reference, const SearchSession& session,
                                       const SearchOptions& options) {
  std::ostringstream reason;
  if (!reference.hasWalls()) {
    return ended(SearchEnding::kEmptyReference, "the reference map has no occupied cell");
  }
  if (session.cells.empty() || static_cast<int>(session.cells.size()) < options.min_session_cells) {
    reason << "the session map has " << session.cells.size()
           << " occupied cells, expected at least min_session_cells = " << std::max(1, options.min_session_cells);
    return ended(SearchEnding::kTooFewSessionCells, reason.str());
  }
  if (session.fine.diagonal > kMaxSessionDiagonal) {
    reason << "the occupied cells of the session map span " << session.fine.diagonal << " cells, expected at most "
           << kMaxSessionDiagonal;
    return ended(SearchEnding::kSessionTooLarge, reason.str());
  }
  return std::nullopt;
}

}  // namespace map_matcher::search
