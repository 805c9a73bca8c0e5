#pragma once

namespace haptiv {

/// The arm's links [m], as in Table I of the paper.
struct LinkLengths {
  double scara = 0.25;         ///< l1 = l2 = l3 = l4
  double forearm = 0.47;       ///< l5h, and back again l8
  double lift = 0.212;         ///< l6 = l7
  double scaraHeight = 0.71;   ///< l5v: the SCARA plane's height above joint 6; for drawing only
  double wristBracket = 0.15;  ///< l9 = l10; for drawing only
};

}  // namespace haptiv
