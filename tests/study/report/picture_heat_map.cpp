#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "tests/study/report/gnuplot.hpp"
#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"

namespace study {
namespace {

constexpr double least_shade = 1e-6;  // rates from here to 1 have a shade; none at all is white

/// Returns: "8e-6" for 7.7e-6: one digit, and not below the value.
std::string bound_in_short(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return in_short(std::ceil(value / power) * power);
}

/// Returns: the words in a cell. Where nothing was seen they say how much that tells; where nothing was wrong, "in doubt".
std::string cell_words(const std::optional<Counts>& counts) {
  if (!counts) return "not asked";
  const Rate rate = failure_rate(*counts);
  if (rate.count == 0 && rate.has_interval()) return "<" + bound_in_short(rate.interval().high);
  if (rate.count == 0 || rate.count != counts->in_doubt) return in_short(rate.share());
  return (rate.count == rate.trials ? "all" : in_short(rate.share())) + " in doubt";
}

/// Returns: the label in a cell, and its colour, so that the shade is not all that tells the rate.
std::string cell_label(std::size_t column, std::size_t row, const std::optional<Counts>& counts) {
  const double rate = counts ? failure_rate(*counts).share() : 0;
  const char* const colour = rate > 0.005 ? "#FFFFFF" : rate > 0 || cell_words(counts) == "0" ? "#000000" : "#666666";
  return "set label " + in_quotes(cell_words(counts)) + " at " + std::to_string(column) + "," + std::to_string(row) +
         " center front textcolor rgb '" + colour + "'\n";
}

std::string tics(const std::string& axis, const std::vector<std::string>& names) {
  std::string text = "set " + axis + "tics (";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : ", ") + in_quotes(names[i]) + " " + std::to_string(i);
  return text + ") scale 0\n";
}

/// A line of small print, so many pixels above the lower edge.
std::string note(const std::string& words, int above, int height) {
  return "set label " + in_quotes(words) + " at screen 0.5," + std::to_string(static_cast<double>(above) / height) +
         " center font ',9'\n";
}

std::string last_edge(std::size_t cells) { return std::to_string(cells) + " - 0.5"; }

}  // namespace

Picture heat_map(const Settings& settings) {
  const auto columns = settings.scalars_and_certified();
  std::vector<std::string> families, titles;
  for (const auto& [title, setting] : columns) titles.push_back(title);
  std::ostringstream cells, labels;
  for (const FamilyNote& family : settings.study().families) {
    for (std::size_t s = 0; s < columns.size(); ++s) {
      const auto counts = settings.counts(family.name, columns[s].second);
      labels << cell_label(s, families.size(), counts);
      const double rate = counts ? failure_rate(*counts).share() : 0;
      if (rate > 0) cells << s << ' ' << families.size() << ' ' << std::log10(std::max(rate, least_shade)) << '\n';
    }
    families.push_back(family.name);
  }
  if (cells.str().empty()) cells << "0 0 NaN\n";
  std::ostringstream script;
  const int width = std::max(1000, 360 + 160 * static_cast<int>(columns.size()));
  const int height = 220 + 24 * static_cast<int>(families.size());
  script
      << flat_canvas(width, height) << "$cells << EOD\n"
      << cells.str() << "EOD\n"
      << labels.str() << "set title "
      << in_quotes("Wrong or undecided, share of pairs: " + all_but_scalar(settings.usual())) << "\n"
      << tics("x", titles) << tics("y", families)
      << note(
             "A number after <: none seen; if there are any they are fewer than this (upper end of the 95 % interval).",
             54, height)
      << note(
             "0: none of all the pairs that there are. Float is judged by the truth about the pair as float writes it.",
             36, height)
      << note(small_print(settings), 14, height) << "set bmargin at screen " << 100.0 / height
      << "\nset xrange [-0.5:" << last_edge(columns.size()) << "]\nset yrange [" << last_edge(families.size())
      << ":-0.5]\nset palette defined (0 '#FFF3B0', 1 '#F6C667', 2 '#E58F4B', 3 '#B8504A', 4 '#6F2C5B', 5 "
         "'#2A1145')\n"
      << "set cbrange [-6:0]\nset cbtics ('1' 0, '0.1' -1, '0.01' -2, '1e-3' -3, '1e-4' -4, '1e-5' -5, '1e-6' -6)\n"
      << "set style fill solid noborder\nunset key\n"
      << "plot $cells using 1:2:(0.5):(0.5):3 with boxxyerror palette\n";
  return {"heat-map.png", script.str()};
}

}  // namespace study
