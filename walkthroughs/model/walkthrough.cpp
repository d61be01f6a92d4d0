#include "walkthroughs/model/walkthrough.hpp"

#include <utility>

namespace walkthroughs::model {

Walkthrough until_they_part(Scene first, Walkthrough second) {
  second.layout = Layout::until_they_part;
  second.scenes.insert(second.scenes.begin(), std::move(first));
  return second;
}

Walkthrough beside_mistake(Mistake mistake, Walkthrough right) {
  Scene wrong = mistaken(right.scenes.front(), mistake);
  wrong.name = wrong_on_purpose::number_of(mistake);
  right.scenes.front().name = "the report";
  return until_they_part(std::move(wrong), std::move(right));
}

}  // namespace walkthroughs::model
