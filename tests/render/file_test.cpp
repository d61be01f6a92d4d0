#include "render/file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"

using namespace render;
namespace fs = std::filesystem;

namespace {

/// A folder that disappears with everything in it.
struct Folder {
  std::string path_text = fs::temp_directory_path() / "gjkstep-file-test-XXXXXX";
  fs::path path = ::mkdtemp(path_text.data());  // of this process alone: other cases run beside it
  ~Folder() { fs::remove_all(path); }
};

const std::vector<std::uint8_t> bytes = {1, 0, 255, 10, 13};

std::ptrdiff_t entries(const fs::path& folder) { return std::distance(fs::directory_iterator(folder), {}); }

bool has_unnamed_files(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (descriptor >= 0) ::close(descriptor);
  return descriptor >= 0;
}

std::string error_of_reading(const fs::path& file, std::uintmax_t most = max_file_bytes) {
  try {
    read_file(file, most);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "";
}

/// Returns: how many bytes this process has read, of whatever; nothing where the system does not count them.
std::optional<std::uintmax_t> bytes_read_so_far() {
  std::ifstream counts("/proc/self/io");
  std::string key;
  std::uintmax_t bytes = 0;
  return counts >> key >> bytes && key == "rchar:" ? std::optional(bytes) : std::nullopt;
}

/// Writes 100,000 bytes in a process that the system ends after 1,000. Returns: the signal by which it ended.
int ended_while_writing(const fs::path& file) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{1000, 1000}, no_core{0, 0};
    std::signal(SIGXFSZ, SIG_DFL);
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_FSIZE, &limit);
    write_file(file, std::vector<std::uint8_t>(100000, 7));
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/// Writes a file where every file has a name: in a process without /proc, by which those without one get theirs.
/// Returns: its exit code; nothing where the system does not let a process change its root, as only root may.
std::optional<int> written_without_proc(const fs::path& folder) {
  constexpr int refused = 77;
  const pid_t child = fork();
  if (child == 0) {
    if (::chroot(folder.c_str()) != 0) _exit(refused);
    ::close(STDIN_FILENO);  // so that 0 is the number of the new file
    try {
      write_file("/file", bytes);
    } catch (const FileError&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return code == refused ? std::nullopt : std::optional(code);
}

}  // namespace

TEST_CASE("What was written is read, and replaces what was there") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, std::vector<std::uint8_t>(100, 7));
  write_file(file, bytes);
  REQUIRE(read_file(file) == bytes);
  REQUIRE(entries(folder.path) == 1);
}

TEST_CASE("A text is written byte by byte") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, std::string("\x01\0\xFF\n\r", 5));
  REQUIRE(read_file(file) == bytes);
}

TEST_CASE("A file that cannot be written names itself, and the old one stays") {
  const Folder folder;
  fs::create_directories(folder.path / "folder" / "in the way");
  REQUIRE_THROWS_AS(write_file(folder.path / "folder", bytes), FileError);
  REQUIRE_THROWS_AS(write_file(folder.path / "missing" / "file", bytes), FileError);
  REQUIRE(fs::exists(folder.path / "folder" / "in the way"));
  REQUIRE(entries(folder.path) == 1);  // nothing temporary
}

TEST_CASE("Whether a file can be written is found out without leaving anything there") {
  const Folder folder;
  expect_writable(folder.path / "file");
  expect_writable(folder.path / std::string(255 - 11, 'x'));  // .unfinished
  for (const int letters : {255 - 10, 255, 300})
    REQUIRE_THROWS_WITH(expect_writable(folder.path / std::string(static_cast<std::size_t>(letters), 'x')),
                        kit::contains("File name too long"));
  CHECK(entries(folder.path) == 0);
  write_file(folder.path / "file", bytes);
  expect_writable(folder.path / "file");
  CHECK(read_file(folder.path / "file") == bytes);
  for (const fs::path& file :
       {folder.path, folder.path / "missing" / "file", fs::path("/proc/file"), fs::path("/dev/full")})
    REQUIRE_THROWS_AS(expect_writable(file), FileError);
}

TEST_CASE("A folder is made where it is missing, unless it cannot be made or written to") {
  const Folder folder;
  for (int i = 0; i < 2; ++i) make_folder(folder.path / "one" / "two", "");
  CHECK(entries(folder.path / "one" / "two") == 0);
  write_file(folder.path / "file", bytes);
  for (const fs::path& other : {folder.path / "file", folder.path / "file" / "below", fs::path("/proc")})
    REQUIRE_THROWS_AS(make_folder(other, ""), FileError);
}

TEST_CASE("However many files are written and read, all are closed") {
  const Folder folder;
  const std::ptrdiff_t open = entries("/proc/self/fd");
  for (int i = 0; i < 20; ++i) {
    write_file(folder.path / "file", bytes);
    expect_writable(folder.path / "file");
    read_file(folder.path / "file");
  }
  CHECK(entries("/proc/self/fd") == open);
}

TEST_CASE("Where standard input is closed its number is used, and given back") {
  const Folder folder;
  const pid_t child = fork();
  if (child == 0) {
    ::close(STDIN_FILENO);
    write_file(folder.path / "file", bytes);
    const bool is_read = read_file(folder.path / "file") == bytes;
    _exit(is_read && ::fcntl(STDIN_FILENO, F_GETFD) == -1 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(status == 0);
}

TEST_CASE("What the system says of a file that cannot be read is told") {
  try {
    read_file("/proc/self/mem");  // a regular file whose first bytes nobody may read
    FAIL("read");
  } catch (const ReadError& error) {
    CHECK(std::string(error.what()) == "cannot read /proc/self/mem: Input/output error; check the disk");
  }
}

TEST_CASE("A file that is not there cannot be read") {
  const Folder folder;
  REQUIRE_THROWS_AS(read_file(folder.path / "missing"), FileError);
}

TEST_CASE("An interruption long ago does not matter") {
  const Folder folder;
  write_file(folder.path / "file", bytes);
  errno = EINTR;
  CHECK(read_file(folder.path / "file") == bytes);
}

TEST_CASE("What may never end is not read, and nobody is waited for: pipes, devices, folders") {
  const Folder folder;
  REQUIRE(mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  for (const fs::path& path : {folder.path / "pipe", fs::path("/dev/zero"), folder.path}) {
    INFO(path);
    CHECK(error_of_reading(path).starts_with("cannot read " + path.string() + ": it is "));
  }
}

TEST_CASE("A file of so many bytes is read, and one of one more is not") {
  const Folder folder;
  write_file(folder.path / "file", bytes);
  CHECK(read_file(folder.path / "file", bytes.size()) == bytes);
  CHECK(error_of_reading(folder.path / "file", bytes.size() - 1).find("it is larger than") != std::string::npos);
  write_file(folder.path / "empty", "");
  CHECK(read_file(folder.path / "empty", 0).empty());
}

TEST_CASE("Of a file its first bytes are read, and of a pipe none") {
  const Folder folder;
  write_file(folder.path / "file", bytes);
  const auto begin = bytes.begin();
  CHECK(read_beginning(folder.path / "file", 3) == std::vector<std::uint8_t>(begin, begin + 3));
  CHECK(read_beginning(folder.path / "file", bytes.size()) == bytes);
  CHECK(read_beginning(folder.path / "file", bytes.size() + 9) == bytes);
  REQUIRE(mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(read_beginning(folder.path / "pipe", 3), ReadError);
}

TEST_CASE("A file that does not tell its size is read whole, and no more of it than allowed") {
  if (!fs::exists("/proc/self/status")) {
    WARN("skipped: no /proc");
    return;
  }
  CHECK(read_file("/proc/self/status").size() > 100);
  CHECK(error_of_reading("/proc/self/status", 100).find("it is larger than") != std::string::npos);
}

TEST_CASE("A file of 3 GiB is refused for its size before it is read") {
  if (!bytes_read_so_far()) {
    WARN("skipped: nobody counts what is read");
    return;
  }
  const Folder folder;
  write_file(folder.path / "large", "");
  fs::resize_file(folder.path / "large", std::uintmax_t{3} << 30);  // no disk holds its zeros
  const std::uintmax_t before = *bytes_read_so_far();
  CHECK(error_of_reading(folder.path / "large").find("it is larger than 1024 MiB") != std::string::npos);
  CHECK(*bytes_read_so_far() - before < 100'000);
}

TEST_CASE("What could not be read afterwards is not written") {
  const Folder folder;
  const std::size_t size = max_file_bytes + 1;  // of address space, not of memory
  void* const nothing = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  REQUIRE(nothing != MAP_FAILED);
  const fs::path file = folder.path / "file";
  CHECK_THROWS_WITH(
      write_file(file, std::span(static_cast<const std::uint8_t*>(nothing), size)),
      "cannot write " + file.string() + ": it would be larger than 1024 MiB; ask for smaller or fewer pictures");
  ::munmap(nothing, size);
  CHECK(entries(folder.path) == 0);
}

TEST_CASE("A program that is ended while it writes leaves nothing behind, and the old file as it was") {
  const Folder folder;
  if (!has_unnamed_files(folder.path)) {
    WARN("skipped: here every file has a name");
    return;
  }
  CHECK(ended_while_writing(folder.path / "new") == SIGXFSZ);
  CHECK(entries(folder.path) == 0);
  write_file(folder.path / "old", bytes);
  CHECK(ended_while_writing(folder.path / "old") == SIGXFSZ);
  CHECK(read_file(folder.path / "old") == bytes);
  CHECK(entries(folder.path) == 1);
}

TEST_CASE("What a killed program has left beside a file is gone when the file is written again, be it there or not") {
  const Folder folder;
  if (!has_unnamed_files(folder.path)) {
    WARN("skipped: here every file has a name");
    return;
  }
  const fs::path file = folder.path / "file", left = folder.path / "file.unfinished";
  for (int round = 0; round < 2; ++round) {
    std::ofstream(left) << "half";
    write_file(file, bytes);
    CHECK(read_file(file) == bytes);
    CHECK(entries(folder.path) == 1);
  }
}

TEST_CASE("Where every file has a name, nothing else is left, whatever number the system gives it") {
  const Folder folder;
  write_file(folder.path / "file", "old");
  const std::optional<int> code = written_without_proc(folder.path);
  if (!code) {
    WARN("skipped: this process may not change its root");
    return;
  }
  CHECK(code == 0);
  CHECK(read_file(folder.path / "file") == bytes);
  CHECK(entries(folder.path) == 1);
}

TEST_CASE("What is in the way of replacing a file, and is none, is told and stays, and so does the file") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, bytes);
  fs::create_directory(folder.path / "file.unfinished");
  if (has_unnamed_files(folder.path)) CHECK_THROWS_AS(write_file(file, "new"), FileError);
  CHECK(fs::is_directory(folder.path / "file.unfinished"));
  CHECK(entries(folder.path) == 2);
}

TEST_CASE("Programs that write the same file at once do not disturb each other, and who reads it finds it whole") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, std::vector<std::uint8_t>(10000, 0));
  std::vector<pid_t> writers;
  for (std::uint8_t k = 1; k <= 3; ++k) {
    writers.push_back(fork());
    if (writers.back() == 0) {
      for (int i = 0; i < 300; ++i) write_file(file, std::vector<std::uint8_t>(10000, k));  // what it throws ends it
      _exit(0);
    }
  }
  int torn = 0, failed = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<std::uint8_t> found = read_file(file);
    if (found != std::vector<std::uint8_t>(10000, found.at(0))) ++torn;
  }
  for (const pid_t writer : writers) {
    int status = 0;
    waitpid(writer, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) ++failed;
  }
  CHECK(torn == 0);
  CHECK(failed == 0);
  CHECK(entries(folder.path) == 1);
}

TEST_CASE("A written file has the permissions of any new file") {
  const Folder folder;
  const mode_t before = umask(027);
  write_file(folder.path / "file", bytes);
  umask(before);
  CHECK(fs::status(folder.path / "file").permissions() == static_cast<fs::perms>(0640));
}

TEST_CASE("A device is not replaced by a file") {
  const Folder folder;
  fs::create_symlink("/dev/null", folder.path / "device");
  REQUIRE_THROWS_AS(write_file(folder.path / "device", bytes), FileError);
  CHECK(fs::is_symlink(folder.path / "device"));  // which is all that would be lost
}
