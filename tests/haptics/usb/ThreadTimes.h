#pragma once

#include <map>
#include <string>

namespace haptiv::test {

/// Processor time that the threads of this process have taken so far [s], by their names; threads of one name
/// together. Linux counts it in nanoseconds (/proc/self/task/TID/schedstat). Throws std::runtime_error where it does
/// not.
std::map<std::string, double> threadTimes();

}  // namespace haptiv::test
