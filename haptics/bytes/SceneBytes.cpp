#include "haptics/bytes/SceneBytes.h"

#include <string>

#include "haptics/bytes/ChoiceBytes.h"
#include "haptics/bytes/MeshBytes.h"
#include "haptics/bytes/ShapeReader.h"

namespace haptiv {
namespace {

constexpr std::string_view kMagic = "HAPTSCN1";
constexpr std::uint32_t kFormat =
    4;  // 2 added the choice of a resolution; 3 meshes and rubber bands; 4 how the arm is driven
constexpr std::size_t kShapeSize = 1 + 12 * 8;
constexpr std::size_t kWallSize = 4 + kShapeSize + 5 * 8;
constexpr std::size_t kZoneSize = 4 + 1 + kShapeSize + 6 * 8;
constexpr std::uint32_t kFirstWithMeshes = 3;
constexpr std::uint32_t kFirstWithControl = 4;

void write(ByteWriter& out, const Wall& wall) {
  const SurfaceProperties& s = wall.surface;
  for (const double value : {s.stiffness, s.damping, s.hysteresis, s.staticFriction, s.dynamicFriction}) out.f64(value);
}

void read(ByteReader& in, Wall& wall) {
  SurfaceProperties& s = wall.surface;
  for (double* value : {&s.stiffness, &s.damping, &s.hysteresis, &s.staticFriction, &s.dynamicFriction}) {
    *value = in.f64();
  }
}

void write(ByteWriter& out, const Zone& zone) {
  for (const double value : {zone.damping, zone.stiffness, zone.restLength}) out.f64(value);
  out.matrix(zone.anchor);
}

void read(ByteReader& in, Zone& zone) {
  for (double* value : {&zone.damping, &zone.stiffness, &zone.restLength}) *value = in.f64();
  in.matrix(zone.anchor);
}

Zone::Kind readZoneKind(ByteReader& in) {
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(Zone::Kind::rubberBand)) in.fail("unknown kind of zone");
  return static_cast<Zone::Kind>(kind);
}

std::uint32_t readHead(ByteReader& in, HapticScene& scene) {
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
  if (format >= kFirstWithControl) scene.control = readControl(in);
  return format;
}

void readMeshes(ByteReader& in, std::vector<std::shared_ptr<const TriangleMesh>>& meshes) {
  if (in.u32() != meshes.size()) in.fail("a scene that follows others, which are not there");
  const std::size_t fresh = in.count(kMeshSize);
  for (std::size_t i = 0; i < fresh; ++i) meshes.push_back(readMesh(in));
}

template <typename Visit>
void forEachMesh(const HapticScene& scene, Visit&& visit) {
  for (const Wall& wall : scene.walls) {
    if (wall.shape.kind == Shape::Kind::mesh && wall.shape.mesh) visit(wall.shape.mesh);
  }
  for (const Zone& zone : scene.zones) {
    if (zone.shape.kind == Shape::Kind::mesh && zone.shape.mesh) visit(zone.shape.mesh);
  }
}

void writeHead(ByteWriter& out, const HapticScene& scene) {
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
  write(out, scene.control);
}

}  // namespace

std::vector<std::byte> SceneEncoder::encode(const HapticScene& scene) {
  std::erase_if(written_, [](const auto& entry) { return entry.second.mesh.expired(); });
  ByteWriter out;
  writeHead(out, scene);
  out.u32(next_);
  std::vector<const TriangleMesh*> fresh;
  forEachMesh(scene, [&](const std::shared_ptr<const TriangleMesh>& mesh) {
    if (!written_.try_emplace(mesh.get(), Written{mesh, next_}).second) return;
    ++next_;
    fresh.push_back(mesh.get());
  });
  out.u32(static_cast<std::uint32_t>(fresh.size()));
  for (const TriangleMesh* mesh : fresh) write(out, *mesh);
  const auto writeShape = [&](const Shape& shape) {
    out.u8(static_cast<std::uint8_t>(shape.kind));
    out.matrix(shape.centre);
    out.matrix(shape.axes);
    if (shape.kind == Shape::Kind::mesh) out.u32(shape.mesh ? written_.at(shape.mesh.get()).number : kNoMesh);
  };
  out.u32(static_cast<std::uint32_t>(scene.walls.size()));
  for (const Wall& wall : scene.walls) {
    out.u32(wall.id);
    writeShape(wall.shape);
    write(out, wall);
  }
  out.u32(static_cast<std::uint32_t>(scene.zones.size()));
  for (const Zone& zone : scene.zones) {
    out.u32(zone.id);
    out.u8(static_cast<std::uint8_t>(zone.kind));
    writeShape(zone.shape);
    write(out, zone);
  }
  return out.take();
}

HapticScene SceneDecoder::decode(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  HapticScene scene;
  const std::uint32_t format = readHead(in, scene);
  const std::size_t known = meshes_.size();
  if (format >= kFirstWithMeshes) readMeshes(in, meshes_);
  ShapeReader shapes(in, meshes_, known);
  scene.walls.resize(in.count(kWallSize));
  for (Wall& wall : scene.walls) {
    wall.id = in.u32();
    wall.shape = shapes.read();
    read(in, wall);
  }
  scene.zones.resize(in.count(kZoneSize));
  for (Zone& zone : scene.zones) {
    zone.id = in.u32();
    zone.kind = readZoneKind(in);
    zone.shape = shapes.read();
    read(in, zone);
  }
  if (!shapes.allNamed()) in.fail("a mesh that no shape has");
  if (in.left() != 0) in.fail(std::to_string(in.left()) + " bytes too many");
  computeBounds(scene);
  return scene;
}

std::vector<std::byte> toBytes(const HapticScene& scene) {
  return SceneEncoder().encode(scene);
}

HapticScene sceneFromBytes(std::span<const std::byte> bytes) {
  return SceneDecoder().decode(bytes);
}

}  // namespace haptiv
