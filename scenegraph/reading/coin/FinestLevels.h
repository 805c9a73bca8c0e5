#pragma once

namespace haptiv {

/// From now on, levels of detail that are read from files show their first, which is felt, however far away the camera
/// stands; picks find it too. Once, after SoDB::init().
void showFinestLevels();

}  // namespace haptiv
