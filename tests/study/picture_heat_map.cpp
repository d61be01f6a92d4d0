#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "tests/study/gnuplot.hpp"
#include "tests/study/pictures.hpp"
#include "tests/study/tables.hpp"

namespace study {
namespace {

constexpr double least_shade = 1e-6;  // rates from here to 1 have a shade; none at all is white

/// Returns: the label in a cell, and its colour, so that the shade is not all that tells the rate.
std::string cell_label(std::size_t column, std::size_t row, const std::optional<Counts>& counts) {
  const double rate = counts ? failure_rate(*counts).share() : 0;
  const std::string text = counts ? in_short(rate) : "not asked";
  const char* const colour = !counts ? "#777777" : rate > 0.005 ? "#FFFFFF" : "#000000";
  return "set label " + in_quotes(text) + " at " + std::to_string(column) + "," + std::to_string(row) +
         " center front textcolor rgb '" + colour + "'\n";
}

std::string tics(const std::string& axis, const std::vector<std::string>& names) {
  std::string text = "set " + axis + "tics (";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : ", ") + in_quotes(names[i]) + " " + std::to_string(i);
  return text + ") scale 0\n";
}

std::string last_edge(std::size_t cells) { return std::to_string(cells) + " - 0.5"; }

}  // namespace

Picture heat_map(const Settings& settings) {
  std::vector<std::string> families;
  std::ostringstream cells, labels;
  for (const FamilyNote& family : settings.study().families) {
    for (std::size_t s = 0; s < settings.scalars().size(); ++s) {
      Setting setting = settings.usual();
      setting.scalar = settings.scalars()[s];
      const auto counts = settings.counts(family.name, setting);
      labels << cell_label(s, families.size(), counts);
      const double rate = counts ? failure_rate(*counts).share() : 0;
      if (rate > 0) cells << s << ' ' << families.size() << ' ' << std::log10(std::max(rate, least_shade)) << '\n';
    }
    families.push_back(family.name);
  }
  if (cells.str().empty()) cells << "0 0 NaN\n";
  std::ostringstream script;
  script << canvas(1000, 190 + 24 * static_cast<int>(families.size())) << "$cells << EOD\n"
         << cells.str() << "EOD\n"
         << labels.str() << "set title "
         << in_quotes("Wrong or undecided, share of pairs: " + all_but_scalar(settings.usual())) << "\n"
         << tics("x", settings.scalars()) << tics("y", families)
         << "set xrange [-0.5:" << last_edge(settings.scalars().size()) << "]\nset yrange ["
         << last_edge(families.size())
         << ":-0.5]\nset palette defined (0 '#FFF3B0', 1 '#F6C667', 2 '#E58F4B', 3 '#B8504A', 4 '#6F2C5B', 5 "
            "'#2A1145')\n"
         << "set cbrange [-6:0]\nset cbtics ('1' 0, '0.1' -1, '0.01' -2, '1e-3' -3, '1e-4' -4, '1e-5' -5, '1e-6' -6)\n"
         << "set xlabel " << in_quotes(small_print(settings))
         << " font ',9'\nset style fill solid noborder\nunset key\n"
         << "plot $cells using 1:2:(0.5):(0.5):3 with boxxyerror palette\n";
  return {"heat-map.png", script.str()};
}

}  // namespace study
