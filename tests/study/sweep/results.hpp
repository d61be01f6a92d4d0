/// What a run leaves: CSV files, of which report/report.py makes tables and pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/study/sweep/csv.hpp"
#include "tests/study/sweep/plan.hpp"

namespace study {

/// Returns: families.csv, iterations.csv, timings.csv, alone.csv and, last, counts.csv. All but the times are the same, byte for
/// byte, wherever and in however many threads the plan runs; those of shards add up, row by row. Lines that begin with '#' say
/// how they were made.
std::vector<Csv> csv_of(const Request& request, const Plan& plan, const std::vector<Row>& rows);

/// Returns: where they belong: in `folder`, or of a shard in a folder of its own below, "shard-7-of-64".
std::filesystem::path folder_of(const std::filesystem::path& folder, const Shard& shard);

/// Writes files in their order, and lists them on standard output: a folder with counts.csv is whole. Errors: render::FileError.
void write_csv(const std::filesystem::path& folder, const std::vector<Csv>& files);

/// Returns: the processor's name, as Linux has it.
std::string processor();

/// Exact numbers, asked by the rules as intended, are never wrong where they decide, and certified answers are never wrong,
/// undecided or without a proof: else GJK or the oracle has an error.
///
/// Returns: a sentence on the first family in which they were; "" where they were in none.
std::string contradiction(const Plan& plan, const std::vector<Row>& rows);

}  // namespace study
