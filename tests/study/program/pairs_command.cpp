#include "tests/study/program/pairs_command.hpp"

#include <iostream>

#include "tests/study/corpus/corpus.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"

namespace study {

using walkthroughs::expect_number;

void PairsCommand::add_to(CLI::App& app) {
  CLI::Option* const is_corpus =
      app.add_flag("--corpus", corpus, "the kept corpus, tests/study/corpus.jsonl: some 500 of the most telling");
  add_list(app, "--families", families, "only these, such as triangles,boxes");
  expect_number(app.add_option("--count", count, "so many of each family")->capture_default_str(), std::uint64_t{1},
                most_pairs);
  add_seed(app, seed);
  for (const char* const option : {"--families", "--count", "--seed"}) is_corpus->excludes(app.get_option(option));
  app.footer(
      "Each line is a pair as 'gjkstep query' reads it, with its name, its family, and the exact answer in the form "
      "of\n"
      "'gjkstep query --certified --fractions': where the two are apart a direction d with a·d < b·d for all points a, "
      "b;\n"
      "else the points a[i] - b[j] whose weights make 0, and the common point. Balls and cylinders have the point "
      "alone.\n"
      "\"notes\" say whether they only touch, and whether the answer is another one once the numbers are rounded to "
      "floats.");
}

void PairsCommand::run() const {
  if (corpus) {
    for (const NamedPair& each : kept_corpus()) std::cout << answered_line(answered(each)) << '\n';
    return;
  }
  ProgressLine line;
  const std::vector<const Family*> chosen = families_called(families);
  std::uint64_t done = 0, all = 0;
  for (const Family* const family : chosen) all += std::min(count, family->size.value_or(count));
  for (const Family* const family : chosen)
    for (std::uint64_t i = 0; i < std::min(count, family->size.value_or(count)); ++i) {
      std::cout << answered_line(
                       answered({family->name + "-" + std::to_string(i), family->name, family->make(seed, i)}))
                << '\n';
      line(++done, all);
    }
}

}  // namespace study
