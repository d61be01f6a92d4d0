#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

std::vector<Remark> remarks_of(const Walkthrough& walkthrough, const std::vector<Trace>& traces) {
  std::vector<Remark> remarks = walkthrough.remarks;
  if (walkthrough.findings)
    for (const Remark& each : walkthrough.findings(traces.front())) remarks.push_back(each);
  return remarks;
}

}  // namespace walkthroughs
