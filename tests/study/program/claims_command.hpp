/// `gjkstep-study claims`: what the report claims, measured, as Markdown on the standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace study {

struct ClaimsCommand {
  std::uint64_t pairs = 1'000'000, seed = 1;
  bool quick = false;
  unsigned threads = 0;  ///< 0: as many as the processor has

  void add_to(CLI::App& app);
  void run() const;
};

}  // namespace study
