#include "haptics/SceneBytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

namespace haptiv {
namespace {

constexpr std::string_view kMagic = "HAPTSCN1";
constexpr std::uint32_t kFormat = 2;  // 2 adds the choice of a resolution; 1 is still read
constexpr std::uint8_t kAsDescribed = 255;
constexpr std::size_t kShapeSize = 1 + 12 * 8;
constexpr std::size_t kWallSize = 4 + kShapeSize + 5 * 8;
constexpr std::size_t kZoneSize = 4 + 1 + kShapeSize + 6 * 8;

class Writer {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(std::byte{value}); }
  void u32(std::uint32_t value) { little(value, 4); }
  void f64(double value) { little(std::bit_cast<std::uint64_t>(value), 8); }
  template <typename Derived>
  void matrix(const Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      for (Eigen::Index row = 0; row < values.rows(); ++row) f64(values(row, column));
    }
  }
  void text(std::string_view value) {
    for (const char c : value) u8(static_cast<std::uint8_t>(c));
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void little(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) u8(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("scene bytes, at byte " + std::to_string(at_) + ": " + what);
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(little(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little(4)); }
  double f64() {
    const double value = std::bit_cast<double>(little(8));
    if (!std::isfinite(value)) fail("a number that is not finite");
    return value;
  }
  double positive(const char* name) {
    const double value = f64();
    if (!(value > 0)) fail(std::string(name) + " must be greater than zero");
    return value;
  }
  template <typename Derived>
  void matrix(Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      for (Eigen::Index row = 0; row < values.rows(); ++row) values(row, column) = f64();
    }
  }
  /// A number of things of `size` bytes each, all of which must still be there.
  std::size_t count(std::size_t size) {
    const std::size_t wanted = u32();
    if (wanted > left() / size) fail("cut off: " + std::to_string(wanted) + " entries announced, too few bytes left");
    return wanted;
  }
  std::string text(std::size_t size) {
    require(size);
    std::string value(size, '\0');
    for (char& c : value) c = static_cast<char>(u8());
    return value;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  void require(std::size_t size) const {
    if (size > left()) fail("cut off");
  }
  std::uint64_t little(int size) {
    require(static_cast<std::size_t>(size));
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) value |= std::to_integer<std::uint64_t>(bytes_[at_++]) << (8 * i);
    return value;
  }
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

void write(Writer& out, const Shape& shape) {
  out.u8(static_cast<std::uint8_t>(shape.kind));
  out.matrix(shape.centre);
  out.matrix(shape.axes);
}

Shape readShape(Reader& in) {
  Shape shape;
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(Shape::Kind::cone)) in.fail("unknown kind of shape");
  shape.kind = static_cast<Shape::Kind>(kind);
  in.matrix(shape.centre);
  in.matrix(shape.axes);
  return shape;
}

void write(Writer& out, const Wall& wall) {
  out.u32(wall.id);
  write(out, wall.shape);
  const SurfaceProperties& s = wall.surface;
  for (const double value : {s.stiffness, s.damping, s.hysteresis, s.staticFriction, s.dynamicFriction}) out.f64(value);
}

Wall readWall(Reader& in) {
  Wall wall;
  wall.id = in.u32();
  wall.shape = readShape(in);
  SurfaceProperties& s = wall.surface;
  for (double* value : {&s.stiffness, &s.damping, &s.hysteresis, &s.staticFriction, &s.dynamicFriction}) {
    *value = in.f64();
  }
  return wall;
}

void write(Writer& out, const Zone& zone) {
  out.u32(zone.id);
  out.u8(static_cast<std::uint8_t>(zone.kind));
  write(out, zone.shape);
  for (const double value : {zone.damping, zone.stiffness, zone.restLength}) out.f64(value);
  out.matrix(zone.anchor);
}

Zone readZone(Reader& in) {
  Zone zone;
  zone.id = in.u32();
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(Zone::Kind::spring)) in.fail("unknown kind of zone");
  zone.kind = static_cast<Zone::Kind>(kind);
  zone.shape = readShape(in);
  for (double* value : {&zone.damping, &zone.stiffness, &zone.restLength}) *value = in.f64();
  in.matrix(zone.anchor);
  return zone;
}

void write(Writer& out, const std::optional<ResolutionChoice>& choice) {
  out.u8(choice ? static_cast<std::uint8_t>(choice->strategy) : kAsDescribed);
  out.u8(choice ? static_cast<std::uint8_t>(choice->solution) : kAsDescribed);
}

std::optional<ResolutionChoice> readResolution(Reader& in) {
  const std::uint8_t strategy = in.u8();
  const std::uint8_t solution = in.u8();
  if (strategy == kAsDescribed && solution == kAsDescribed) return {};
  if (strategy > static_cast<std::uint8_t>(Strategy::cond)) in.fail("unknown strategy of the redundancy");
  if (solution > static_cast<std::uint8_t>(Solution::partitioned)) in.fail("unknown solution of the redundancy");
  return ResolutionChoice{static_cast<Strategy>(strategy), static_cast<Solution>(solution)};
}

void readHead(Reader& in, HapticScene& scene) {
  if (in.left() < kMagic.size() || in.text(kMagic.size()) != kMagic) in.fail("this is no compiled scene");
  const std::uint32_t format = in.u32();
  if (format < 1 || format > kFormat) {
    in.fail("format " + std::to_string(format) + ", while this program reads up to format " + std::to_string(kFormat));
  }
  scene.version = in.u32();
  scene.tool.mass = in.positive("the tool's mass");
  scene.tool.damping = in.f64();
  scene.tool.radius = in.positive("the tool's radius");
  in.matrix(scene.tool.home);
  scene.device.description = in.text(in.count(1));
  in.matrix(scene.device.position);
  in.matrix(scene.device.rotation);
  scene.device.scale = in.positive("the device's scale");
  // Programs of format 1 knew the least-norm solution alone.
  scene.resolution = format == 1 ? ResolutionChoice{} : readResolution(in);
}

}  // namespace

std::vector<std::byte> toBytes(const HapticScene& scene) {
  Writer out;
  out.text(kMagic);
  out.u32(kFormat);
  out.u32(scene.version);
  for (const double value : {scene.tool.mass, scene.tool.damping, scene.tool.radius}) out.f64(value);
  out.matrix(scene.tool.home);
  out.u32(static_cast<std::uint32_t>(scene.device.description.size()));
  out.text(scene.device.description);
  out.matrix(scene.device.position);
  out.matrix(scene.device.rotation);
  out.f64(scene.device.scale);
  write(out, scene.resolution);
  out.u32(static_cast<std::uint32_t>(scene.walls.size()));
  for (const Wall& wall : scene.walls) write(out, wall);
  out.u32(static_cast<std::uint32_t>(scene.zones.size()));
  for (const Zone& zone : scene.zones) write(out, zone);
  return out.take();
}

HapticScene sceneFromBytes(std::span<const std::byte> bytes) {
  Reader in(bytes);
  HapticScene scene;
  readHead(in, scene);
  const std::size_t walls = in.count(kWallSize);
  scene.walls.reserve(walls);
  for (std::size_t i = 0; i < walls; ++i) scene.walls.push_back(readWall(in));
  const std::size_t zones = in.count(kZoneSize);
  scene.zones.reserve(zones);
  for (std::size_t i = 0; i < zones; ++i) scene.zones.push_back(readZone(in));
  if (in.left() != 0) in.fail(std::to_string(in.left()) + " bytes too many");
  computeBounds(scene);
  return scene;
}

}  // namespace haptiv
