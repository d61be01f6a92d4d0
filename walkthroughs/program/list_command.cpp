#include "walkthroughs/program/list_command.hpp"

#include <iostream>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/listing.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs {

void ListCommand::run() const {
  if (!name) return write_list(std::cout, catalogue());
  if (name->find_first_not_of(' ') == std::string::npos)
    throw UsageError(in_quotes(*name) + " is no word to look for; leave it out: 'gjkstep list' shows all");
  std::vector<const Walkthrough*> found = find_walkthroughs(*name);
  if (found.empty()) found = walkthroughs_that_say(*name);
  if (found.empty())
    throw UsageError("no walkthrough has or says " + in_quotes(*name) + "; did you mean '" + nearest_name(*name) +
                     "'? 'gjkstep list' shows all");
  write_table(std::cout, found);
}

CLI::App* add_list_command(CLI::App& app, ListCommand& list) {
  CLI::App* const command =
      app.add_subcommand("list", "the walkthroughs, one line each, or those of a folder or with a word");
  command->add_option(
      "NAME", list.name,
      "a folder, a walkthrough, or a word of names, titles and cases such as R7: the cases and how they "
      "end, as a table");
  return command;
}

}  // namespace walkthroughs
