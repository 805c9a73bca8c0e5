#pragma once

namespace haptiv {

/// From now on, cameras that are read from files change no view: they are kept, written and found, and who shows a
/// scene looks from where he wants to. Cameras made in code are as ever. Once, after SoDB::init().
void quietSceneCameras();

}  // namespace haptiv
