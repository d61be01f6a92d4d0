/// `gjkstep-study symmetries`: do certified answers stay what they are, whatever is done to a pair? Markdown on the standard
/// output.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace study {

struct SymmetriesCommand {
  std::uint64_t pairs = 1000, seed = 1;
  unsigned threads = 0;  ///< 0: as many as the processor has

  void add_to(CLI::App& app);
  /// Errors: std::logic_error where an answer does not stay the same, or is not proven; after everything is written.
  void run() const;
};

}  // namespace study
