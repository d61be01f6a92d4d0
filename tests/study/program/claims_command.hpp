/// `gjkstep-study claims`: what the report claims, counted.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace study {

struct ClaimsCommand {
  std::uint64_t pairs = 1'000'000, seed = 1;
  bool quick = false;
  unsigned threads = 0;  ///< 0: as many as the processor has
  std::string out = "study";

  void add_to(CLI::App& app);
  void run() const;
};

}  // namespace study
