#include "tests/study/report/filter.hpp"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>

namespace study {
namespace {

/// Never returns. Requires: nothing but this thread is needed, as no other is in the copy of the process.
[[noreturn]] void become(const std::string& program, int socket, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it was ended before it could have been noticed
  ::dup2(socket, STDIN_FILENO);
  ::dup2(socket, STDOUT_FILENO);
  ::execlp(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

/// A program that leaves without reading closes its end, which is no signal here; its exit code tells.
void send(int socket, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string receive(int socket) {
  std::string text;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t count = ::recv(socket, block.data(), block.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

bool succeeds(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::optional<std::string> filtered(const std::string& program, const std::string& input) {
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) return std::nullopt;
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become(program, sockets[1], parent);
  ::close(sockets[1]);
  std::string output;
  if (child > 0) {
    send(sockets[0], input);
    ::shutdown(sockets[0], SHUT_WR);
    output = receive(sockets[0]);
  }
  ::close(sockets[0]);
  return child > 0 && succeeds(child) ? std::optional(std::move(output)) : std::nullopt;
}

}  // namespace study
