#pragma once

#include <cstddef>
#include <future>
#include <vector>

namespace haptiv::usb {

/// Does `work` with each of them, all at the same time, and waits until all is done: what does not answer keeps no
/// other waiting. Throws what one of them throws.
template <typename Each, typename Work>
void sideBySide(std::vector<Each>& all, const Work& work) {
  std::vector<std::future<void>> done;
  for (std::size_t i = 1; i < all.size(); ++i)
    done.push_back(std::async(std::launch::async, [&each = all[i], &work] { work(each); }));
  if (!all.empty()) work(all.front());
  for (std::future<void>& each : done) each.get();
}

}  // namespace haptiv::usb
