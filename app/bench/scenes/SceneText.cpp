#include "app/bench/scenes/SceneText.h"

#include <array>
#include <cstdio>

namespace haptiv {

std::string sceneText(const HapticScene& scene) {
  std::string text = "#Inventor V2.1 ascii\n";
  std::array<char, 320> line{};
  const auto append = [&](int length) { text.append(line.data(), static_cast<std::size_t>(length)); };
  const Vector3& base = scene.device.position;
  const Vector3& home = scene.tool.home;
  append(std::snprintf(line.data(), line.size(), "HapticDevice { position %.8g %.8g %.8g }\n", base.x(), base.y(),
                       base.z()));
  append(std::snprintf(line.data(), line.size(), "HapticTool { mass %.6g radius %.6g home %.8g %.8g %.8g }\n",
                       scene.tool.mass, scene.tool.radius, home.x(), home.y(), home.z()));
  for (const Wall& wall : scene.walls) {
    const Vector3& p = wall.shape.centre;
    const Vector3 size = 2 * wall.shape.axes.diagonal();
    append(
        std::snprintf(line.data(), line.size(),
                      "Separator { HapticSurface { stiffness %.6g damping %.6g } Translation { translation %.8g %.8g "
                      "%.8g } Cube { width %.8g height %.8g depth %.8g } }\n",
                      wall.surface.stiffness, wall.surface.damping, p.x(), p.y(), p.z(), size.x(), size.y(), size.z()));
  }
  return text;
}

}  // namespace haptiv
