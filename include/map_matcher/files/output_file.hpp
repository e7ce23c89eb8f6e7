/// \file
/// Files that are there whole or not at all.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace map_matcher::files {

/// A file that cannot be written; the message names the file and the reason.
class OutputFileError : public std::runtime_error {
 public:
  OutputFileError(const std::string& path, const std::string& reason)
      : std::runtime_error("file '" + path + "' cannot be written: " + reason), reason_(reason) {}

  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// A file that is written beside its final name, as "NAME.partial", and takes the name only when it is complete, so
/// that whoever reads the name finds either all of the new file or all of the old one. Of a symbolic link it is the
/// file that the link points at which is replaced; a device or a pipe is written to as it is.
class OutputFile {
 public:
  /// Begins the pending file. Throws OutputFileError when there can be none, or when `path` is a directory or a file
  /// that may not be written.
  explicit OutputFile(const std::string& path);

  /// Removes the pending file unless it was committed.
  ~OutputFile();

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends to the pending file, which has it when this returns. Throws OutputFileError.
  void write(std::string_view content);

  /// Where the content stands until it is committed, for writers that want a name.
  const std::string& pendingPath() const { return pending_path_; }

  /// Gives the file its name. Throws OutputFileError when that, or bringing the content to the disk, fails.
  void commit();

 private:
  void removePending() noexcept;

  std::string path_;          // as asked for
  std::string final_path_;    // behind symbolic links
  std::string pending_path_;  // final_path_ itself for devices and pipes
  int descriptor_ = -1;       // -1 when the file is committed or moved elsewhere
  int registration_ = -1;     // among the pending files that end with the process
};

/// Writes a whole file, as OutputFile does. Throws OutputFileError.
void writeFile(const std::string& path, std::string_view content);

/// Removes the pending files of all living OutputFiles, for a process that a signal ends: it may be called in a signal
/// handler.
void removePendingFiles() noexcept;

/// Whether two paths are one file, by whatever names: through links, or for files that are not there yet by the same
/// place in the same directory. Devices and pipes are never one file.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace map_matcher::files
