#pragma once

#include <poll.h>

namespace haptiv::test {

/// The libc's own, past the bench.
int realPoll(pollfd* descriptors, nfds_t count, int timeout);
int realClose(int descriptor);
/// A timer has run out when this returns: whoever sleeps for it has been woken.
void realRing(int timer);

}  // namespace haptiv::test
