#include "walkthroughs/program/exit_code.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>

#include "render/file.hpp"
#include "render/font.hpp"
#include "render/offscreen_context.hpp"
#include "walkthroughs/program/standard_output.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::program {
namespace {

template <class... Errors>
bool is_one_of(const std::exception& error) {
  return ((dynamic_cast<const Errors*>(&error) != nullptr) || ...);
}

ExitCode code_of(const std::exception& error) {
  if (is_one_of<UsageError>(error)) return wrong_usage;
  if (is_one_of<InputError, render::FontError>(error)) return bad_input;
  if (is_one_of<render::ContextError>(error)) return no_context;
  return is_one_of<render::FileError>(error) ? cannot_write : unexpected;
}

/// Returns: what it says. A thread that cannot be started says no more than "Resource temporarily unavailable".
std::string what_failed(const std::exception& error) {
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  if (of_system == nullptr || of_system->code() != std::errc::resource_unavailable_try_again) return error.what();
  return "a thread cannot be started; allow more processes (ulimit -u), or more memory (ulimit -v)";
}

// ---------------------------------------------------------------------------------------------- crashes

/// Made beforehand: a handler of signals must not ask for memory, nor find it gone when the program ends.
std::array<char, 200> program_that_crashes, advice_on_crashes;
std::array<char, 1 << 16> stack_for_crashes;  // the usual one may not grow where memory is short

void copy(const std::string& text, std::array<char, 200>& to) { to[text.copy(to.data(), to.size() - 1)] = '\0'; }

/// Tells of a crash, and ends the program: whether files are whole does not depend on how it ends.
[[noreturn]] void tell_crash(int signal) {
  const std::array<const char*, 6> parts = {
      program_that_crashes.data(), ": crashed (",
      ::sigdescr_np(signal),       "), as libraries such as Mesa do where memory or threads are lacking",
      advice_on_crashes.data(),    "\n"};
  for (const char* part : parts)
    if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
  ::_exit(unexpected);
}

/// Mesa and LLVM do not look whether they have got the memory or the thread that they asked for. Nothing that is tried first
/// proves that a later picture will not crash them. What somebody else handles, such as a sanitizer, stays with him.
void tell_crashes_of(const std::string& program) {
  const std::string limit = render::memory_limit();
  copy(program, program_that_crashes);
  copy(limit.empty() ? "; if there is enough of both, please report the command" : limit, advice_on_crashes);
  const stack_t stack{.ss_sp = stack_for_crashes.data(), .ss_flags = 0, .ss_size = stack_for_crashes.size()};
  stack_t stack_before{};
  if (::sigaltstack(nullptr, &stack_before) == 0 && (stack_before.ss_flags & SS_DISABLE) != 0)
    ::sigaltstack(&stack, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE}) {
    struct sigaction before {};
    struct sigaction telling {};
    telling.sa_handler = tell_crash;
    telling.sa_flags = SA_ONSTACK;
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
      ::sigaction(signal, &telling, nullptr);
  }
}

// ---------------------------------------------------------------------------------------------- what is printed

/// What std::cout writes to as long as this lives. Where it cannot, the next insertion or flush that needs it throws a
/// render::FileError, so that a command ends when nobody reads what it says; what is left then is thrown away.
class StandardOutput final : public std::streambuf {
 public:
  StandardOutput() { std::cout.exceptions(std::ios::badbit); }
  /// Writes what is left if it can.
  ~StandardOutput() override {
    finish();
    std::cout.rdbuf(before_);
  }
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  /// Writes what is left if it can; what cannot be written, now and later, is thrown away without a word.
  void finish() noexcept {
    std::cout.exceptions(std::ios::goodbit);
    try {
      sync();
    } catch (const std::exception&) {
    }
  }

 protected:
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
  }
  std::streamsize xsputn(const char* letters, std::streamsize count) override {
    constexpr std::size_t enough = 1 << 16;
    const std::string_view added(letters, static_cast<std::size_t>(count));
    text_ += added;
    const bool ends_line = is_terminal_ && added.find('\n') != std::string_view::npos;
    if (ends_line || text_.size() >= enough) sync();
    return count;
  }
  int sync() override {
    write_to_standard_output(std::exchange(text_, {}));
    return 0;
  }

 private:
  std::string text_;
  std::streambuf* const before_ = std::cout.rdbuf(this);
  const bool is_terminal_ = ::isatty(STDOUT_FILENO) != 0;  ///< which shows each line at once
};

}  // namespace

int exit_code_of(const std::string& program, const std::string& if_out_of_memory, const std::function<int()>& run) {
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
  tell_crashes_of(program);
  StandardOutput output;
  try {
    const int code = run();
    std::cout.flush();
    return code;
  } catch (const std::bad_alloc&) {
    output.finish();  // what was said before the error
    std::cerr << program << ": out of memory; " << if_out_of_memory << render::memory_limit() << '\n';
    return unexpected;
  } catch (const ReaderLeft& error) {
    return code_of(error);
  } catch (const std::exception& error) {
    output.finish();
    std::cerr << program << ": " << message_line(what_failed(error)) << '\n';
    return code_of(error);
  }
}

}  // namespace walkthroughs::program
