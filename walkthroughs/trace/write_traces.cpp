#include <ostream>
#include <vector>

#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::trace {

void write_traces(std::ostream& out, const Walkthrough& walkthrough) {
  std::vector<Trace> traces;
  std::vector<Truth> truths;
  for (const Scene& scene : walkthrough.scenes) {
    traces.push_back(run(scene));
    truths.push_back(truth_of(scene, answer_of(traces.back())));
  }
  out << traces_json(walkthrough, traces, truths);
}

}  // namespace walkthroughs::trace
