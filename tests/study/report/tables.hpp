/// What a study found, for readers and for programs. Counts and timings are kept in files of their own: of the same study
/// the first are the same, byte for byte, wherever and in however many shards it runs.
#pragma once

#include <string>

#include "tests/study/sweep/settings.hpp"

namespace study {

/// Returns: one line for each family, method and limit; lines that begin with '#' tell how it was made.
std::string counts_csv(const Settings& settings);
std::string timings_csv(const Settings& settings);

/// Returns: Markdown; each table varies one thing.
std::string counts_markdown(const Settings& settings);    ///< families and scalars
std::string errors_markdown(const Settings& settings);    ///< false positives, false negatives and undecided apart
std::string settings_markdown(const Settings& settings);  ///< rules, zero tests, iteration limits
std::string timings_markdown(const Settings& settings);
std::string certified_markdown(const Settings& settings);  ///< counts and times of what is proven; "" where nothing is

/// Returns: what the timings were taken on: processors and threads.
std::string processors_of(const Study& study);

/// Returns: "0.0031", "3.1e-5", "0".
std::string in_short(double value);

/// Returns: "0 (< 3.7e-6)", "0.0031 (0.0029 – 0.0033)", with the ends of the 95 % interval; "0.0031 of all"
/// where it is a census; "no pairs" of no trials.
std::string in_words(const Rate& rate);

}  // namespace study
