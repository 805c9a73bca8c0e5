#pragma once

#include "tests/support/usb/PollWatch.h"

namespace haptiv::test {

/// The polls of the whole program.
PollWatch& pollWatch();

/// The libc's own, past the bench.
int realPoll(pollfd* descriptors, nfds_t count, int timeout);
int realClose(int descriptor);
/// A timer has run out when this returns: whoever sleeps for it has been woken.
void realRing(int timer);

}  // namespace haptiv::test
