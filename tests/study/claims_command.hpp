/// `gjkstep-study claims`: the report's claims, measured, as Markdown on the standard output.
#pragma once

#include <CLI/CLI.hpp>

namespace study {

void add_claims_command(CLI::App& program);

}  // namespace study
