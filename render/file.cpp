#include "render/file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace render {
namespace {

namespace fs = std::filesystem;

std::string reason(int error_number) { return std::generic_category().message(error_number); }

/// Returns: the descriptor of a file without a name in that folder; -1 where the file system has none (NFS, FAT).
int open_unnamed(const fs::path& folder) {
  if (::access("/proc/self/fd", X_OK) != 0) return -1;  // it could not be named later
  return ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

/// A file that disappears unless it is put in place when it is whole. Without a name until then, it also does where the
/// program is interrupted or killed, but for the moment in which it replaces another: then it has a temporary name, always
/// the same, so that the next one removes what was left. Where every file has a name, it has one with the number of the
/// process, so that nobody else puts it in place too early, and an end by force leaves it.
class NewFile {
 public:
  explicit NewFile(const fs::path& target)
      : target_(target),
        temporary_(target),
        descriptor_(open_unnamed(target.parent_path())),
        shares_name_(descriptor_ >= 0) {
    temporary_ += shares_name_ ? ".unfinished" : "." + std::to_string(getpid()) + ".unfinished";
    if (shares_name_) return;
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail("create " + temporary_.string(), errno);
    is_named_ = true;
  }
  ~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (is_named_) ::unlink(temporary_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail("write all of it", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  /// Returns: false where another process, which writes the same file at this moment, has taken the temporary name away.
  bool put_in_place() {
    // As closing does, this tells what some file systems notice late; the descriptor itself is needed to give a name.
    if (::close(::dup(descriptor_)) != 0) fail("write all of it", errno);
    if (!is_named_) ::unlink(temporary_.c_str());  // of a process that has been killed
    if (!is_named_ && name(target_)) return true;
    if (!is_named_ && errno != EEXIST) fail("give it its name", errno);
    if (!is_named_) name_temporarily();  // as only what has a name can replace a file
    return replaces_target();
  }

 private:
  /// Returns: whether it has got that name; otherwise errno says why not.
  bool name(const fs::path& path) const {
    const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
    return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }
  void name_temporarily() {
    while (!name(temporary_))
      if (errno != EEXIST || (::unlink(temporary_.c_str()) != 0 && errno != ENOENT))
        fail("create " + temporary_.string(), errno);
    is_named_ = true;
  }
  bool replaces_target() {
    const bool replaced = ::rename(temporary_.c_str(), target_.c_str()) == 0;
    if (!replaced && !(shares_name_ && errno == ENOENT)) fail("rename " + temporary_.string() + " to it", errno);
    is_named_ = false;
    return replaced;
  }

  [[noreturn]] void fail(const std::string& step, int error_number) const {
    throw FileError("cannot write " + target_.string() + ": could not " + step + ": " + reason(error_number) +
                    "; check that the folder exists, may be written to and has space left");
  }

  const fs::path target_;
  fs::path temporary_;
  int descriptor_;
  const bool shares_name_;  // the temporary one, with other processes
  bool is_named_ = false;   // by it
};

/// To be renamed to a device would replace it, where one may.
void refuse_other_than_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw FileError("cannot write " + path.string() + ": it is " +
                    (fs::is_directory(status) ? "a folder" : "not a regular file") +
                    "; check that you mean it, and name a file");
}

/// So that it is told before all has been written; of the longer name, which the next file that replaces this one will need.
void refuse_long_name(const fs::path& path) {
  struct stat there;
  if (::lstat((path.string() + ".unfinished").c_str(), &there) != 0 && errno == ENAMETOOLONG)
    throw FileError("cannot write " + path.string() + ": " + reason(ENAMETOOLONG) + "; choose a shorter name");
}

std::string in_words(std::uintmax_t bytes) {
  constexpr std::uintmax_t mebi = 1 << 20, kibi = 1 << 10;
  return bytes >= mebi ? std::to_string(bytes / mebi) + " MiB" : std::to_string(bytes / kibi) + " KiB";
}

/// A file that is open for reading.
class OldFile {
 public:
  explicit OldFile(const fs::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(reason(errno), "check that the file exists and may be read");
  }
  ~OldFile() { ::close(descriptor_); }
  OldFile(const OldFile&) = delete;
  OldFile& operator=(const OldFile&) = delete;

  std::vector<std::uint8_t> read(std::uintmax_t most) const {
    if (size() > most) fail_too_large(most);
    std::vector<std::uint8_t> bytes = read_beginning(most + 1);
    if (bytes.size() > most) fail_too_large(most);
    return bytes;
  }

  /// Returns: the first bytes, `most` of them at most. It may have grown since its size was asked for, and files of /proc do
  /// not tell theirs.
  std::vector<std::uint8_t> read_beginning(std::uintmax_t most) const {
    std::vector<std::uint8_t> bytes(std::min(most, size() + 1));  // one more, to see the end
    std::size_t count = 0;
    while (const std::size_t more = read_into(std::span(bytes).subspan(count))) {
      count += more;
      if (count == bytes.size()) bytes.resize(std::min<std::uintmax_t>(most, count + (1 << 16)));
    }
    bytes.resize(count);
    return bytes;
  }

 private:
  /// Returns: how many bytes there were; 0 at the end.
  std::size_t read_into(std::span<std::uint8_t> bytes) const {
    while (true) {
      const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) fail_of_disk();
    }
  }
  std::uintmax_t size() const {
    struct stat status;
    if (::fstat(descriptor_, &status) != 0) fail_of_disk();
    if (!S_ISREG(status.st_mode))
      fail(S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file", "name a file");
    return static_cast<std::uintmax_t>(status.st_size);
  }
  [[noreturn]] void fail_of_disk() const { fail(reason(errno), "check the disk"); }
  [[noreturn]] void fail_too_large(std::uintmax_t most) const {
    fail("it is larger than " + in_words(most), "give a smaller one");
  }
  [[noreturn]] void fail(const std::string& why, const std::string& what_to_do) const {
    throw ReadError("cannot read " + path_.string() + ": " + why + "; " + what_to_do);
  }

  const fs::path path_;
  const int descriptor_;
};

}  // namespace

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  refuse_other_than_file(path);
  if (bytes.size() > max_file_bytes)
    throw FileError("cannot write " + path.string() + ": it would be larger than " + in_words(max_file_bytes) +
                    "; ask for smaller or fewer pictures");
  for (bool done = false; !done;) {
    NewFile file(path);
    file.write(bytes);
    done = file.put_in_place();
  }
}

void write_file(const fs::path& path, std::string_view text) {
  write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void expect_writable(const fs::path& path) {
  refuse_other_than_file(path);
  refuse_long_name(path);
  const NewFile file(path);
}

void make_folder(const fs::path& folder, const std::string& what_to_do) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError("cannot create the folder " + folder.string() + ": " + error.message() + "; " + what_to_do);
  expect_writable(folder / "file");
}

std::vector<std::uint8_t> read_file(const fs::path& path, std::uintmax_t most) { return OldFile(path).read(most); }

std::vector<std::uint8_t> read_beginning(const fs::path& path, std::size_t most) {
  return OldFile(path).read_beginning(most);
}

std::string memory_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  return "; only " + std::to_string(limit.rlim_cur >> 20) + " MiB of memory are allowed (ulimit -v), try with more";
}

}  // namespace render
