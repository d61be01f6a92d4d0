#include <algorithm>
#include <sstream>

#include "tests/study/report/gnuplot.hpp"
#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"

namespace study {
namespace {

/// Returns: the share of queries that took k iterations, the mean of the families that have any; [0] is never taken.
std::vector<double> shares(const std::vector<Counts>& families, Histogram Counts::*iterations) {
  std::vector<double> mean;
  std::size_t asked = 0;
  for (const Counts& counts : families) asked += total(counts.*iterations) > 0;
  for (const Counts& counts : families) {
    const Histogram& histogram = counts.*iterations;
    const std::uint64_t all = total(histogram);
    mean.resize(std::max(mean.size(), histogram.size()));
    for (std::size_t k = 0; all > 0 && k < histogram.size(); ++k)
      mean[k] += static_cast<double>(histogram[k]) / static_cast<double>(all * asked);
  }
  return mean;
}

int most_iterations(const std::vector<Counts>& families) {
  std::size_t most = 1;
  for (const Counts& counts : families)
    most = std::max({most, counts.hit_iterations.size(), counts.miss_iterations.size()});
  return static_cast<int>(most);
}

std::string histogram_data(const std::string& block, const std::vector<Counts>& families) {
  const std::vector<double> hits = shares(families, &Counts::hit_iterations),
                            misses = shares(families, &Counts::miss_iterations);
  std::ostringstream text;
  text << block << " << EOD\n";
  for (std::size_t k = 1; k < std::max(hits.size(), misses.size()); ++k)
    text << k << ' ' << (k < hits.size() ? hits[k] : 0) << ' ' << (k < misses.size() ? misses[k] : 0) << '\n';
  text << "EOD\n";
  return text.str();
}

std::string histogram_plot(const std::string& block, const std::string& title) {
  return "set title " + in_quotes(title) + "\nplot " + block +
         " using ($1-0.2):($2>0?$2:NaN) with boxes fs solid 1 lc rgb " + blue + " title 'hits', " + block +
         " using ($1+0.2):($3>0?$3:NaN) with boxes fs pattern 2 lc rgb " + vermilion + " title 'misses'\n";
}

}  // namespace

Picture iterations(const Settings& settings) {
  const Setting usual = settings.usual();
  std::vector<Counts> all;
  for (const FamilyNote& family : settings.study().families)
    if (auto counts = settings.counts(family.name, usual)) all.push_back(std::move(*counts));
  if (all.empty()) all.emplace_back();
  const std::string first = settings.study().families.empty() ? "" : settings.study().families.front().name;
  std::ostringstream script;
  script << canvas(1200, 820) << histogram_data("$first", {all.front()}) << histogram_data("$all", all)
         << "set multiplot layout 2,1 title " << in_quotes("Iterations: " + usual.scalar + ", " + all_but_scalar(usual))
         << "\nset logscale y\nset yrange [1e-6:1]\nset ytics ('1' 1, '0.1' 0.1, '0.01' 0.01, '1e-3' 1e-3, '1e-4' "
            "1e-4, '1e-5' 1e-5, '1e-6' 1e-6)\nset ylabel 'share of hits, of misses'\n"
         << "set xrange [0:" << (is_certified(usual.rules) ? most_iterations(all) : usual.limit) + 1
         << "]\nset xtics 1\nset boxwidth 0.4\nset grid y\nset key top right\n"
         << histogram_plot("$first", "family " + first)
         << "set xlabel 'iterations; undecided queries count with those that they took'\n"
         << histogram_plot("$all", "all families, each counting alike") << "unset multiplot\n";
  return {"iterations.png", script.str()};
}

}  // namespace study
