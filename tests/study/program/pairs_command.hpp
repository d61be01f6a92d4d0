/// `gjkstep-study pairs`: pairs with their exact answers as JSON Lines on the standard output, as `gjkstep query` reads them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace study {

struct PairsCommand {
  std::vector<std::string> families;
  std::uint64_t count = 10, seed = 1;
  bool corpus = false;

  void add_to(CLI::App& app);
  void run() const;
};

}  // namespace study
