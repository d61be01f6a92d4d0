#include "walkthroughs/trace/trace_event.hpp"

#include "walkthroughs/trace/read_fields.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

// -- Events -----------------------------------------------------------------------------------------------------------

template <class E>
gjk::Event<double> read_as(const Value& line) {
  E event;
  std::vector<std::string> known = keys_of(event).all;
  known.insert(known.end(), {"scene", "iteration", "event"});
  for (const Value& each : line.children())
    if (std::ranges::count(known, each.key()) == 0) each.fail("is not a key of " + in_quotes(FieldsOf<E>::event));
  read_fields(line, {}, event);
  event.iteration = iteration(member(line, "iteration"));
  return event;
}

}  // namespace

gjk::Event<double> read_event(const Value& line) {
  const auto read_one_of = [&]<class... Events>(std::type_identity<std::variant<Events...>>) {
    constexpr std::array readers{read_as<Events>...};
    return readers[choice(member(line, "event"), event_names)](line);
  };
  return read_one_of(std::type_identity<gjk::Event<double>>{});
}

}  // namespace walkthroughs
