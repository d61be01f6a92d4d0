/// The commands of gjkstep-study. Each adds itself to the program, which runs what its command line names. Errors: UsageError, and
/// what each says.
#pragma once

#include <CLI/CLI.hpp>

namespace study {

/// `run`: sweeps, and writes what was counted and timed. Errors: std::logic_error where that contradicts what is proven.
void add_run(CLI::App& program);

/// `claims`: what the report claims, counted.
void add_claims(CLI::App& program);

/// `pairs`: pairs with their exact answers as JSON Lines on the standard output, as `gjkstep query` reads them.
void add_pairs(CLI::App& program);

/// `list`: families and settings.
void add_listing(CLI::App& program);

}  // namespace study
