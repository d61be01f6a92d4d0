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
#include "tests/kit/folder.hpp"

namespace file_test {

using namespace render;
using kit::Folder;
namespace fs = std::filesystem;

namespace {

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

/// Runs `call` in a process of its own. Returns: how that ended, as wait() tells it; the exit code is 0 unless `call` says otherwise
/// or finds that a file cannot be written, which is 1.
template <class Call>
int status_of(Call call) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      call();
    } catch (const FileError&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

/// Writes 100,000 bytes where the system takes 1,000. `on_more`: what its signal does.
int status_of_writing_too_much(const fs::path& file, void (*on_more)(int)) {
  return status_of([&] {
    const rlimit limit{1000, 1000}, no_core{0, 0};
    std::signal(SIGXFSZ, on_more);
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_FSIZE, &limit);
    write_file(file, std::vector<std::uint8_t>(100000, 7));
  });
}

constexpr int refused = 77;

/// Writes a file where every file has a name: in a process without /proc, by which those without one get theirs.
/// Returns: its exit code; `refused` where the system does not let a process change its root, as only root may.
int written_without_proc(const fs::path& folder) {
  return WEXITSTATUS(status_of([&] {
    if (::chroot(folder.c_str()) != 0) _exit(refused);
    ::close(STDIN_FILENO);  // so that 0 is the number of the new file
    write_file("/file", bytes);
  }));
}

}  // namespace

TEST_CASE("What was written is read, and replaces what was there") {
  const Folder folder;
  const fs::path file = folder / "file";
  write_file(file, std::vector<std::uint8_t>(100, 7));
  write_file(file, bytes);
  REQUIRE(read_file(file) == bytes);
  REQUIRE(entries(folder.path()) == 1);
}

TEST_CASE("A file that cannot be written names itself, and the old one stays") {
  const Folder folder;
  fs::create_directories(folder / "folder" / "in the way");
  REQUIRE_THROWS_AS(write_file(folder / "folder", bytes), FileError);
  REQUIRE_THROWS_AS(write_file(folder / "missing" / "file", bytes), FileError);
  REQUIRE(fs::exists(folder / "folder" / "in the way"));
  REQUIRE(entries(folder.path()) == 1);  // nothing temporary
}

TEST_CASE("Whether a file can be written is found out without leaving anything there") {
  const Folder folder;
  expect_writable(folder / "file");
  expect_writable(folder / std::string(255 - 11, 'x'));  // .unfinished
  for (const int letters : {255 - 10, 255, 300})
    REQUIRE_THROWS_WITH(expect_writable(folder / std::string(static_cast<std::size_t>(letters), 'x')),
                        kit::contains("File name too long"));
  CHECK(entries(folder.path()) == 0);
  write_file(folder / "file", bytes);
  expect_writable(folder / "file");
  CHECK(read_file(folder / "file") == bytes);
  for (const fs::path& file :
       {folder.path(), folder / "missing" / "file", fs::path("/proc/file"), fs::path("/dev/full")})
    REQUIRE_THROWS_AS(expect_writable(file), FileError);
}

TEST_CASE("A folder is made where it is missing, unless it cannot be made or written to") {
  const Folder folder;
  for (int i = 0; i < 2; ++i) make_folder(folder / "one" / "two", "");
  CHECK(entries(folder / "one" / "two") == 0);
  write_file(folder / "file", bytes);
  for (const fs::path& other : {folder / "file", folder / "file" / "below", fs::path("/proc")})
    REQUIRE_THROWS_AS(make_folder(other, ""), FileError);
}

TEST_CASE("However many files are written and read, all are closed") {
  const Folder folder;
  const std::ptrdiff_t open = entries("/proc/self/fd");
  for (int i = 0; i < 20; ++i) {
    write_file(folder / "file", bytes);
    expect_writable(folder / "file");
    read_file(folder / "file");
  }
  CHECK(entries("/proc/self/fd") == open);
}

TEST_CASE("Where standard input is closed its number is used, and given back") {
  const Folder folder;
  CHECK(status_of([&] {
          ::close(STDIN_FILENO);
          write_file(folder / "file", bytes);
          const bool is_read = read_file(folder / "file") == bytes;
          _exit(is_read && ::fcntl(STDIN_FILENO, F_GETFD) == -1 ? 0 : 1);
        }) == 0);
}

TEST_CASE("What the system says of a file that cannot be read is told") {
  // A regular file whose first bytes nobody may read.
  CHECK(error_of_reading("/proc/self/mem") == "cannot read /proc/self/mem: Input/output error; check the disk");
}

TEST_CASE("What may never end is not read, and nobody is waited for: pipes, devices, folders") {
  const Folder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const fs::path& path : {folder / "pipe", fs::path("/dev/zero"), folder.path()}) {
    INFO(path);
    CHECK(error_of_reading(path).starts_with("cannot read " + path.string() + ": it is "));
  }
}

TEST_CASE("A file of so many bytes is read, and one of one more is not") {
  const Folder folder;
  write_file(folder / "file", bytes);
  CHECK(read_file(folder / "file", bytes.size()) == bytes);
  CHECK(error_of_reading(folder / "file", bytes.size() - 1).find("it is larger than") != std::string::npos);
  write_file(folder / "empty", "");
  CHECK(read_file(folder / "empty", 0).empty());
}

TEST_CASE("Of a file its first bytes are read, and of a pipe none") {
  const Folder folder;
  write_file(folder / "file", bytes);
  const auto begin = bytes.begin();
  CHECK(read_beginning(folder / "file", 3) == std::vector<std::uint8_t>(begin, begin + 3));
  CHECK(read_beginning(folder / "file", bytes.size()) == bytes);
  CHECK(read_beginning(folder / "file", bytes.size() + 9) == bytes);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(read_beginning(folder / "pipe", 3), ReadError);
}

TEST_CASE("A file that does not tell its size is read whole, and no more of it than allowed") {
  CHECK(read_file("/proc/self/status").size() > 100);
  CHECK_THAT(error_of_reading("/proc/self/status", 100), kit::contains("it is larger than"));
}

TEST_CASE("A file of 3 GiB is refused for its size before it is read") {
  if (!bytes_read_so_far()) return kit::skip("nobody counts what is read");
  const Folder folder;
  write_file(folder / "large", "");
  fs::resize_file(folder / "large", std::uintmax_t{3} << 30);  // no disk holds its zeros
  const std::uintmax_t before = *bytes_read_so_far();
  CHECK(error_of_reading(folder / "large").find("it is larger than 1024 MiB") != std::string::npos);
  CHECK(*bytes_read_so_far() - before < 100'000);
}

TEST_CASE("What could not be read afterwards is not written") {
  const Folder folder;
  const std::size_t size = max_file_bytes + 1;  // of address space, not of memory
  void* const nothing = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  REQUIRE(nothing != MAP_FAILED);
  const fs::path file = folder / "file";
  CHECK_THROWS_WITH(
      write_file(file, std::span(static_cast<const std::uint8_t*>(nothing), size)),
      "cannot write " + file.string() + ": it would be larger than 1024 MiB; ask for smaller or fewer pictures");
  ::munmap(nothing, size);
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE(
    "A program that is ended while it writes, or finds no room, leaves nothing behind, and the old file as it was") {
  const Folder folder;
  if (!has_unnamed_files(folder.path())) return kit::skip("here every file has a name");
  write_file(folder / "old", bytes);
  for (const char* name : {"new", "old"}) {
    CHECK(WTERMSIG(status_of_writing_too_much(folder / name, SIG_DFL)) == SIGXFSZ);
    CHECK(WEXITSTATUS(status_of_writing_too_much(folder / name, SIG_IGN)) == 1);
  }
  CHECK(read_file(folder / "old") == bytes);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("What a killed program has left beside a file is gone when the file is written again, be it there or not") {
  const Folder folder;
  if (!has_unnamed_files(folder.path())) return kit::skip("here every file has a name");
  const fs::path file = folder / "file", left = folder / "file.unfinished";
  for (int round = 0; round < 2; ++round) {
    std::ofstream(left) << "half";
    write_file(file, bytes);
    CHECK(read_file(file) == bytes);
    CHECK(entries(folder.path()) == 1);
  }
}

TEST_CASE("Where every file has a name, nothing else is left, whatever number the system gives it") {
  const Folder folder;
  write_file(folder / "file", "old");
  const int code = written_without_proc(folder.path());
  if (code == refused) return kit::skip("this process may not change its root");
  CHECK(code == 0);
  CHECK(read_file(folder / "file") == bytes);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("What is in the way of replacing a file, and is none, is told and stays, and so does the file") {
  const Folder folder;
  const fs::path file = folder / "file";
  write_file(file, bytes);
  fs::create_directory(folder / "file.unfinished");
  if (has_unnamed_files(folder.path())) CHECK_THROWS_AS(write_file(file, "new"), FileError);
  CHECK(fs::is_directory(folder / "file.unfinished"));
  CHECK(entries(folder.path()) == 2);
}

TEST_CASE("Programs that write the same file at once do not disturb each other, and who reads it finds it whole") {
  const Folder folder;
  const fs::path file = folder / "file";
  write_file(file, std::vector<std::uint8_t>(10000, 0));
  std::vector<pid_t> writers;
  for (std::uint8_t k = 1; k <= 3; ++k) {
    writers.push_back(fork());
    if (writers.back() == 0) {
      for (int i = 0; i < 100; ++i) write_file(file, std::vector<std::uint8_t>(10000, k));  // what it throws ends it
      _exit(0);
    }
  }
  int torn = 0, failed = 0;
  for (int i = 0; i < 100; ++i) {
    const std::vector<std::uint8_t> found = read_file(file);
    if (found != std::vector<std::uint8_t>(10000, found.at(0))) ++torn;
  }
  for (const pid_t writer : writers) {
    int status = 0;
    waitpid(writer, &status, 0);
    failed += status != 0;
  }
  CHECK(torn == 0);
  CHECK(failed == 0);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("A written file has the permissions of any new file") {
  const Folder folder;
  const mode_t before = umask(027);
  write_file(folder / "file", bytes);
  umask(before);
  CHECK(fs::status(folder / "file").permissions() == static_cast<fs::perms>(0640));
}

TEST_CASE("A device is not replaced by a file") {
  const Folder folder;
  fs::create_symlink("/dev/null", folder / "device");
  REQUIRE_THROWS_AS(write_file(folder / "device", bytes), FileError);
  CHECK(fs::is_symlink(folder / "device"));  // which is all that would be lost
}

}  // namespace file_test
