#include "map_matcher/files/output_file.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> has no masks
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <tuple>
#include <utility>

namespace map_matcher::files {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNames = 1000;  // of pending files of one file that earlier processes may have left behind

[[noreturn]] void fail(const std::string& path, int error) {
  throw OutputFileError(path, std::generic_category().message(error));
}

/// A pending file that a signal handler finds without allocating or locking.
struct Pending {
  std::atomic<bool> taken{false};
  std::atomic<bool> is_there{false};
  std::array<char, PATH_MAX> path{};
};

std::array<Pending, 32> pending_files;

/// Makes the file known to removePendingFiles(); -1 when too many are, which then leaves this one behind.
int registerPending(const std::string& path) {
  for (std::size_t i = 0; i < pending_files.size(); ++i) {
    Pending& pending = pending_files[i];
    if (path.size() < pending.path.size() && !pending.taken.exchange(true)) {
      std::memcpy(pending.path.data(), path.c_str(), path.size() + 1);
      pending.is_there = true;
      return static_cast<int>(i);
    }
  }
  return -1;
}

void forgetPending(int registration) {
  if (registration >= 0) {
    Pending& pending = pending_files[static_cast<std::size_t>(registration)];
    pending.is_there = false;
    pending.taken = false;
  }
}

/// Keeps signals from this thread: one that came between the making of a file and its registration would leave it
/// behind.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

/// Whether the path is written to in place: there is nothing to replace in a device or a pipe.
bool isInPlace(const fs::path& path) {
  std::error_code unreadable;
  const fs::file_status status = fs::status(path, unreadable);
  const bool is_other = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  const std::string first = path.is_absolute() && path.begin() != path.end() ? std::next(path.begin())->string() : "";
  return is_other || first == "dev" || first == "proc";
}

/// The file behind symbolic links, also where the last of them points at nothing.
fs::path behindLinks(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code unreadable;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, unreadable)); ++i) {
    path = path.parent_path() / fs::read_symlink(path, unreadable);
  }
  return path;
}

/// Opens a pending file that nobody else has; its name comes with it.
std::pair<int, std::string> openPending(const std::string& path, const std::string& final_path) {
  std::string name = final_path + ".partial";
  for (int i = 1; i <= kMostNames; ++i) {
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      return {descriptor, name};
    }
    if (errno != EEXIST) {
      fail(path, errno);
    }
    name = final_path + "." + std::to_string(i) + ".partial";
  }
  fail(path, EEXIST);
}

fs::path absolutePath(const std::string& path) {
  std::error_code unreadable;
  const fs::path target = fs::absolute(behindLinks(path), unreadable);
  const fs::path directory = fs::canonical(target.parent_path(), unreadable);
  return unreadable ? target : directory / target.filename();
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  std::error_code unreadable;
  if (fs::is_directory(path, unreadable)) {
    fail(path_, EISDIR);
  }
  if (isInPlace(path)) {
    final_path_ = path;
    pending_path_ = path;
    descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      fail(path_, errno);
    }
    return;
  }
  final_path_ = behindLinks(path).string();
  if (fs::exists(final_path_, unreadable) && access(final_path_.c_str(), W_OK) != 0) {
    fail(path_, errno);
  }
  const SignalsHeld held;
  std::tie(descriptor_, pending_path_) = openPending(path_, final_path_);
  registration_ = registerPending(pending_path_);
}

OutputFile::~OutputFile() { removePending(); }

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      final_path_(std::move(other.final_path_)),
      pending_path_(std::move(other.pending_path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      registration_(std::exchange(other.registration_, -1)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this != &other) {
    removePending();
    path_ = std::move(other.path_);
    final_path_ = std::move(other.final_path_);
    pending_path_ = std::move(other.pending_path_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    registration_ = std::exchange(other.registration_, -1);
  }
  return *this;
}

void OutputFile::write(std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor_, content.data(), content.size());
    if (written < 0 && errno != EINTR) {
      fail(path_, errno);
    }
    content.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  const bool in_place = pending_path_ == final_path_;
  if (!in_place && fsync(descriptor_) != 0 && errno != EINVAL) {  // which tells of disks that fill up late
    fail(path_, errno);
  }
  if (!in_place) {
    std::error_code no_old_file;
    const fs::perms permissions = fs::status(final_path_, no_old_file).permissions();
    if (!no_old_file && permissions != fs::perms::unknown) {
      fs::permissions(pending_path_, permissions, no_old_file);
    }
    if (std::rename(pending_path_.c_str(), final_path_.c_str()) != 0) {
      fail(path_, errno);
    }
  }
  forgetPending(std::exchange(registration_, -1));
  if (close(std::exchange(descriptor_, -1)) != 0) {
    fail(path_, errno);
  }
}

void OutputFile::removePending() noexcept {
  if (descriptor_ < 0) {
    return;
  }
  close(std::exchange(descriptor_, -1));
  if (pending_path_ != final_path_) {
    unlink(pending_path_.c_str());
  }
  forgetPending(std::exchange(registration_, -1));
}

void writeFile(const std::string& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

void removePendingFiles() noexcept {
  for (const Pending& pending : pending_files) {
    if (pending.is_there) {
      unlink(pending.path.data());
    }
  }
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code unreadable;
  if (isInPlace(a) || isInPlace(b)) {
    return false;
  }
  if (fs::exists(a, unreadable) && fs::exists(b, unreadable)) {
    return fs::equivalent(a, b, unreadable);
  }
  return absolutePath(a) == absolutePath(b);
}

}  // namespace map_matcher::files
