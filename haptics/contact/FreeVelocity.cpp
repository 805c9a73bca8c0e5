#include "haptics/contact/FreeVelocity.h"

namespace haptiv {

Vector3 freeVelocity(const Vector3& velocity, const ContactSet& contacts) noexcept {
  constexpr double kSameDirection = 1e-3;  // sine of the angle below which two normals count as one
  Matrix3 basis;                           // Gram-Schmidt over the normals; three columns are all there can be
  int found = 0;
  Vector3 free = velocity;
  for (int i = 0; i < contacts.count && found < 3; ++i) {
    Vector3 direction = contacts.contact[static_cast<std::size_t>(i)].normal;
    for (int j = 0; j < found; ++j) direction -= basis.col(j).dot(direction) * basis.col(j);
    const double length = direction.norm();
    if (!(length > kSameDirection)) continue;
    basis.col(found) = direction / length;
    free -= basis.col(found).dot(free) * basis.col(found);
    ++found;
  }
  return found == 3 ? Vector3(Vector3::Zero()) : free;
}

}  // namespace haptiv
