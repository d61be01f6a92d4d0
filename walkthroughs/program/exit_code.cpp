#include "walkthroughs/program/exit_code.hpp"

#include <csignal>
#include <iostream>
#include <new>

#include "render/backend.hpp"
#include "render/file.hpp"
#include "render/font.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs {
namespace {

/// Requires: an exception is being handled.
ExitCode code_of_this_exception() {
  try {
    throw;
  } catch (const UsageError&) {
    return wrong_usage;
  } catch (const InputError&) {
    return bad_input;
  } catch (const render::FontError&) {
    return bad_input;
  } catch (const render::ReadError&) {
    return bad_input;
  } catch (const render::ContextError&) {
    return no_context;
  } catch (const render::FileError&) {
    return cannot_write;
  } catch (...) {
    return unexpected;
  }
}

}  // namespace

int exit_code_of(const std::string& program, const std::string& if_out_of_memory, const std::function<int()>& run) {
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run();
  } catch (const std::bad_alloc&) {
    std::cerr << program << ": out of memory; " << if_out_of_memory << '\n';
    return unexpected;
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << '\n';
    return code_of_this_exception();
  }
}

void flush_output() {
  if (!std::cout.flush())
    throw render::FileError(
        "cannot write to standard output; check that the disk has space left, or that who reads has not left");
}

}  // namespace walkthroughs
