/// \file
/// How a program ends.
#pragma once

namespace map_matcher::tools {

/// From here on a signal that ends the process removes what was not completed; the exit status is then 128 and its
/// number. A file that grows beyond what the system allows is an error like a full disk.
void endCleanlyOnSignals();

/// Throws std::runtime_error, with the reason, when what was printed could not be written to standard output.
void requireWrittenOutput();

}  // namespace map_matcher::tools
