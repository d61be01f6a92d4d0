#include "walkthroughs/program/command_line.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::program {

const Walkthrough& walkthrough_named(const std::string& name) {
  if (const Walkthrough* found = find_walkthrough(name)) return *found;
  std::error_code unknown;
  if (std::filesystem::exists(name, unknown) && !std::filesystem::is_directory(name, unknown))
    throw UsageError(in_quotes(name) +
                     " is a file, not a walkthrough. Give a scene file a name that ends in .json. Draw a trace with "
                     "'gjkstep render --from-trace FILE'");
  throw UsageError("there is no walkthrough " + in_quotes(name) + "; " + did_you_mean(nearest_name(name)) +
                   "'gjkstep list' shows all");
}

std::vector<const Walkthrough*> walkthroughs_named(const std::string& name) {
  const std::vector<const Walkthrough*> found = find_walkthroughs(name);
  return found.empty() ? std::vector{&walkthrough_named(name)} : found;
}

bool is_scene_file(const std::string& name) {
  return is_standard_input(name) || boost::algorithm::iends_with(name, ".json");
}

void add_force_flag(CLI::App& command, bool& force) {
  command.add_flag("--force", force,
                   "overwrite, and remove, also files that gjkstep has not written or that were changed since");
}

void expect_output_apart_from(const std::string& file, const std::string& what) {
  if (file.empty()) return;  // which is told where it is read
  Places places;
  places.read(file, what + " " + file);
  places.write_standard_output();
  places.expect_apart();
}

// ---------------------------------------------------------------------------------------------- --gl

namespace {

constexpr const char* backend_variable = "GJKSTEP_GL";

/// Requires: `source` is where the name was found. Errors: UsageError.
render::Backend backend_named(const std::string& name, const std::string& source) {
  std::string names;
  for (const render::Backend each : render::all_backends) {
    if (render::name_of(each) == name) return each;
    names.append(names.empty() ? "" : " or ").append(render::name_of(each));
  }
  throw UsageError(source + " " + in_quotes(name) + ": expected " + names);
}

}  // namespace

void add_backend_option(CLI::App& command, std::optional<std::string>& name) {
  const std::string usual(render::name_of(render::default_backend()));
  command.add_option("--gl", name,
                     "draw with osmesa or egl, which give the same pixels; if not given, what " +
                         std::string(backend_variable) + " says, or " + usual);
}

render::Backend chosen_backend(const std::optional<std::string>& name) {
  if (name) return backend_named(*name, "--gl");
  const char* const set = std::getenv(backend_variable);
  const bool is_set = set != nullptr && *set != '\0';
  return is_set ? backend_named(set, backend_variable) : render::default_backend();
}

}  // namespace walkthroughs::program
