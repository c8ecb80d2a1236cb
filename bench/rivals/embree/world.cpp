// SPDX-License-Identifier: Apache-2.0
#include "world.hpp"

#include <cmath>

#include "callbacks.hpp"

namespace zraka::embree {
namespace {

Vec narrow(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vec narrow(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

template <class T>
T* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride,
              std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count));
}

void attach(RTCScene scene, RTCGeometry geometry, Geometry id) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

void add_material(const Material& m, const Color& light, std::vector<float>& rows) {
  const auto index = static_cast<float>(m.ior);
  const Vec ambient = narrow(light) * narrow(m.ambient), diffuse = narrow(m.diffuse),
            specular = narrow(m.specular);
  const float row[kMaterialColumns] = {ambient.x,
                                       ambient.y,
                                       ambient.z,
                                       diffuse.x,
                                       diffuse.y,
                                       diffuse.z,
                                       specular.x,
                                       specular.y,
                                       specular.z,
                                       static_cast<float>(m.shininess),
                                       static_cast<float>(m.reflection.r),
                                       static_cast<float>(m.refraction.r),
                                       1 / index,
                                       index};
  rows.insert(rows.end(), row, row + kMaterialColumns);
}

template <class Shape>
void add_materials(const std::vector<Object<Shape>>& objects, Geometry geometry, World& world) {
  world.first_of[geometry] = static_cast<int>(world.material_of.size());
  for (const Object<Shape>& object : objects)
    world.material_of.push_back(static_cast<int>(object.material));
}

void add_spheres(const Scene& scene, Spheres how, World& world) {
  world.spheres.reserve(scene.spheres.size());
  for (const auto& [s, material, transform] : scene.spheres)
    world.spheres.push_back({narrow(s.center), static_cast<float>(s.radius)});
  if (world.spheres.empty()) return;
  if (how == Spheres::callbacks)
    return attach(world.embree, Callbacks<Sphere4>::geometry_of(world.device, world.spheres),
                  kSpheres);
  const RTCGeometry points = rtcNewGeometry(world.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetSharedGeometryBuffer(points, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                             world.spheres.data(), 0, sizeof(Sphere4), world.spheres.size());
  attach(world.embree, points, kSpheres);
}

/// Triangles of either kind; corners that follow each other are not shared.
template <class Shape>
void add_triangles(const std::vector<Object<Shape>>& objects, Geometry id, World& world) {
  if (objects.empty()) return;
  const RTCGeometry geometry = rtcNewGeometry(world.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corner = new_buffer<Vec>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(Vec),
                                 3 * objects.size());
  auto* index =
      new_buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, objects.size());
  unsigned next = 0;
  for (const auto& [s, material, transform] : objects) {
    for (const Vec3& v : {s.a, s.b, s.c}) {
      *corner++ = narrow(v);
      *index++ = next++;
    }
  }
  attach(world.embree, geometry, id);
}

void add_corner_normals(const Scene& scene, std::vector<float>& normals) {
  for (const auto& [s, material, transform] : scene.smooth_triangles)
    for (const Vec3& v : {s.normal_a, s.normal_b, s.normal_c}) {
      const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      for (const double part : {v.x, v.y, v.z})
        normals.push_back(length > 0 ? static_cast<float>(part / length) : 0.0f);
    }
}

void add_cones(const Scene& scene, World& world) {
  world.cones.reserve(scene.cones.size());
  for (const auto& [s, material, transform] : scene.cones) {
    const double x = s.apex.x - s.base.x, y = s.apex.y - s.base.y, z = s.apex.z - s.base.z;
    const double length = std::sqrt(x * x + y * y + z * z);
    world.cones.push_back({narrow(s.base), narrow(Vec3{x / length, y / length, z / length}),
                           static_cast<float>(s.base_radius),
                           static_cast<float>((s.apex_radius - s.base_radius) / length),
                           static_cast<float>(length)});
  }
  if (!world.cones.empty())
    attach(world.embree, Callbacks<OpenCone>::geometry_of(world.device, world.cones), kCones);
}

/// Embree tells of each piece of memory that it takes or gives back.
bool count_bytes(void* world, ssize_t more, bool) {
  auto& w = *static_cast<World*>(world);
  const std::int64_t now = w.bytes += more;
  for (std::int64_t most = w.most_bytes;
       now > most && !w.most_bytes.compare_exchange_weak(most, now);) {
  }
  return true;
}

RTCDevice device_of(const std::string& isa) {
  return rtcNewDevice(isa.empty() ? nullptr : ("isa=" + isa).c_str());
}

/// The widest packet that a device traces without cutting it up.
int packet_of(RTCDevice device) {
  const auto has = [&](RTCDeviceProperty which) {
    return rtcGetDeviceProperty(device, which) != 0;
  };
  return has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? 16
         : has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8
                                                          : 4;
}

}  // namespace

std::vector<Isa> offered_isas() {
  std::vector<Isa> offered;
  for (const Isa& isa : {Isa{"sse2", 4}, {"sse4.2", 4}, {"avx", 8}, {"avx2", 8}, {"avx512", 16}}) {
    const RTCDevice device = device_of(isa.name);
    if (device == nullptr) continue;
    // One that Embree was built without becomes a lesser one without a word.
    if (packet_of(device) == isa.packet) offered.push_back(isa);
    rtcReleaseDevice(device);
  }
  return offered;
}

World::World(Scene scene, Spheres how, const std::string& isa)
    : device(device_of(isa)), embree(nullptr) {
  if (device == nullptr) return;
  rtcSetDeviceMemoryMonitorFunction(device, count_bytes, this);
  embree = rtcNewScene(device);
  const Camera& camera = scene.camera;
  width = scene.resolution.width;
  height = scene.resolution.height;
  const Vec up = narrow(camera.window_up), across = narrow(camera.window_right);
  eye = narrow(camera.eye);
  right = across * (1 / static_cast<float>(width));
  down = up * (-1 / static_cast<float>(height));
  first = narrow(camera.window_center) - eye + up * 0.5f - across * 0.5f;
  background = narrow(scene.background);
  for (const zraka::Light& light : scene.lights)
    lights.push_back({narrow(light.position), narrow(light.color)});
  for (const Material& material : scene.materials)
    add_material(material, scene.ambient_light, materials);

  material_of.reserve(scene.shape_count());
  add_materials(scene.spheres, kSpheres, *this);
  add_materials(scene.triangles, kTriangles, *this);
  add_materials(scene.smooth_triangles, kSmoothTriangles, *this);
  add_materials(scene.cones, kCones, *this);

  rtcSetSceneBuildQuality(embree, RTC_BUILD_QUALITY_HIGH);
  add_spheres(scene, how, *this);
  add_triangles(scene.triangles, kTriangles, *this);
  add_triangles(scene.smooth_triangles, kSmoothTriangles, *this);
  add_corner_normals(scene, corner_normals);
  add_cones(scene, *this);
  // Embree's kernels for coherent rays make triangles 15 to 25 % faster, callbacks 4 to 12 %
  // slower.
  coherence_pays = scene.triangles.size() + scene.smooth_triangles.size() >
                   scene.spheres.size() + scene.cones.size();
  scene = {};
  rtcCommitScene(embree);
}

std::uint64_t World::scene_bytes() const {
  const auto size = [](const auto& v) { return v.size() * sizeof(v[0]); };
  return size(materials) + size(material_of) + size(corner_normals) + size(cones) + size(spheres);
}

int World::packet() const {
  return packet_of(device);
}

World::~World() {
  if (device == nullptr) return;
  rtcReleaseScene(embree);
  rtcReleaseDevice(device);
}

}  // namespace zraka::embree
