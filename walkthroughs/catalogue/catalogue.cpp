#include "walkthroughs/catalogue/catalogue.hpp"

#include <algorithm>

#include "walkthroughs/text/names.hpp"

namespace walkthroughs::catalogue {
namespace {

std::vector<Walkthrough> all_walkthroughs() {
  std::vector<Walkthrough> all{figure_1(), figure_2(), figure_3()};
  const auto append = [&](const std::vector<Walkthrough>& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(figures_4_and_5());
  append(figures_6_and_7());
  append({figure_8()});
  for (const auto family :
       {region_cases, vehicle_and_threat, endless_searches, other_rules, failures, certified_answers})
    append(family());
  append({mistakes_survival()});
  append(mistakes());
  return all;
}

std::string small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

}  // namespace

const std::vector<Walkthrough>& whole_catalogue() {
  static const std::vector<Walkthrough> all = all_walkthroughs();
  return all;
}

std::vector<const Walkthrough*> find_walkthroughs(std::string_view name) {
  std::vector<const Walkthrough*> found;
  const std::string folder = std::string(name) + (name.ends_with('/') ? "" : "/");
  for (const Walkthrough& each : whole_catalogue())
    if (each.name == name || each.name.starts_with(folder)) found.push_back(&each);
  return found;
}

const Walkthrough* find_walkthrough(std::string_view name) {
  const auto& all = whole_catalogue();
  const auto found = std::ranges::find(all, name, &Walkthrough::name);
  return found == all.end() ? nullptr : &*found;
}

std::vector<const Walkthrough*> walkthroughs_that_say(std::string_view word) {
  std::vector<const Walkthrough*> found;
  for (const Walkthrough& w : whole_catalogue()) {
    const std::string said =
        w.name + "\n" + w.title + "\n" + w.summary + "\n" + (w.region_case ? w.region_case->text : "");
    if (small_letters(said).find(small_letters(word)) != std::string::npos) found.push_back(&w);
  }
  return found;
}

std::string nearest_name(std::string_view name) {
  std::vector<std::string> spellings;  // all names, then all without their folders
  for (const Walkthrough& w : whole_catalogue()) spellings.push_back(w.name);
  for (const Walkthrough& w : whole_catalogue()) spellings.push_back(w.name.substr(w.name.rfind('/') + 1));
  // A word such as R7 is no name that somebody spelled wrongly.
  const bool begins_one =
      std::ranges::any_of(spellings, [&](const std::string& each) { return each.starts_with(name); });
  const std::vector<const Walkthrough*> saying = walkthroughs_that_say(name);
  if (!begins_one && !saying.empty()) return saying.front()->name;
  const auto found = std::ranges::find(spellings, nearest(name, spellings)) - spellings.begin();
  return spellings[static_cast<std::size_t>(found) % whole_catalogue().size()];
}

}  // namespace walkthroughs::catalogue
