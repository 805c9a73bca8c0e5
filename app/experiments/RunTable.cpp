#include "app/experiments/RunTable.h"

#include <algorithm>

namespace haptiv {

const RunResult* RunTable::find(Experiment experiment, const ResolutionChoice& choice, double varied) const {
  const auto found = std::ranges::find_if(runs_, [&](const RunResult& run) {
    return run.setup.experiment == experiment && run.setup.choice == choice && run.setup.varied == varied;
  });
  return found == runs_.end() ? nullptr : &*found;
}

}  // namespace haptiv
