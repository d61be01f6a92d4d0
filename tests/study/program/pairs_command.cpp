#include <iostream>
#include <memory>

#include "tests/study/corpus/corpus.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/program/commands.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"

namespace study {
namespace {

constexpr const char* form_of_lines =
    R"(Each line is a pair as 'gjkstep query' reads it, with its name, its family, and the exact answer in the form of
'gjkstep query --certified --fractions': where the two are apart a direction d with a·d < b·d for all points a, b;
else the points a[i] - b[j] whose weights make 0, and the common point. Balls and cylinders have the point alone.
"notes" say whether they only touch, and whether the answer is another one once the numbers are rounded to floats.)";

struct PairsCommand {
  std::vector<std::string> families;
  std::uint64_t count = 10, seed = 1;
  bool corpus = false;
};

void write(NamedPair pair) { std::cout << answered_line(answered(std::move(pair))) << '\n'; }

void run(const PairsCommand& asked) {
  if (asked.corpus) {
    for (const NamedPair& each : kept_corpus()) write(each);
    return;
  }
  ProgressLine line;
  const std::vector<const Family*> chosen = families_called(asked.families);
  const auto count_of = [&](const Family& family) { return std::min(asked.count, family.size.value_or(asked.count)); };
  std::uint64_t done = 0, all = 0;
  for (const Family* const family : chosen) all += count_of(*family);
  for (const Family* const family : chosen)
    for (std::uint64_t i = 0; i < count_of(*family); ++i) {
      write({family->name + "-" + std::to_string(i), family->name, family->make(asked.seed, i)});
      line(++done, all);
    }
}

}  // namespace

void add_pairs(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("pairs", "write pairs with their exact answers, a JSON line each");
  const auto asked = std::make_shared<PairsCommand>();
  CLI::Option* const is_corpus = app.add_flag(
      "--corpus", asked->corpus, "the kept corpus, walkthroughs/pairs/corpus.jsonl: some 500 of the most telling");
  add_list(app, "--families", asked->families, "only these, such as triangles,boxes");
  add_pair_count(app, "--count", asked->count, "so many of each family");
  add_seed(app, asked->seed);
  for (const char* const option : {"--families", "--count", "--seed"}) is_corpus->excludes(app.get_option(option));
  app.footer(form_of_lines);
  app.callback([asked] { run(*asked); });
}

}  // namespace study
