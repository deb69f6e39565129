#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>
#include <xmmintrin.h>

#include "tests/bench/isector_bench/engine.h"

namespace eod::bench {

namespace {

/// Flush-to-zero and denormals-are-zero, as Embree's manual asks of each thread that casts; put
/// back at the end of a frame, so that no other engine computes with them.
class FlushToZero {
 public:
  FlushToZero() { _mm_setcsr(before_ | kFlush | kDenormalsAreZero); }
  ~FlushToZero() { _mm_setcsr(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  static constexpr unsigned kFlush = 0x8000, kDenormalsAreZero = 0x0040;
  unsigned before_ = _mm_getcsr();
};

/// One scene of default build quality, asked line by line: packets of 8 or 16 were no faster. All
/// in single precision, counted from the middle of the mesh. The device has one thread, so that
/// times of building compare.
class EmbreeEngine final : public Engine {
 public:
  EmbreeEngine(const IndexedMesh& mesh, RTCSceneFlags flags)
      : middle_(mesh.middle), device_(rtcNewDevice("threads=1")) {
    if (device_ == nullptr) throw std::runtime_error("Embree: no device");
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.corners.size()));
    for (const Eigen::Vector3d& p_M : mesh.corners) {
      const Eigen::Vector3f p = (p_M - middle_).cast<float>();
      corner = std::copy(p.begin(), p.end(), corner);
    }
    auto* index = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), mesh.triangles.size()));
    for (const auto& corners : mesh.triangles)
      index = std::copy(corners.begin(), corners.end(), index);
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, flags);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree: no scene");
  }
  ~EmbreeEngine() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeEngine(const EmbreeEngine&) = delete;
  EmbreeEngine& operator=(const EmbreeEngine&) = delete;

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    const FlushToZero mode;
    for (size_t i = 0; i < lines.size(); ++i) Cast(lines[i], hits[i]);
  }

 private:
  void Cast(const sim::SegmentQuery& line, sim::SegmentHit& hit) const {
    const Eigen::Vector3f start = (line.start - middle_).cast<float>();
    const Eigen::Vector3f direction = line.direction.cast<float>();
    RTCRayHit ray;
    ray.ray.org_x = start.x();
    ray.ray.org_y = start.y();
    ray.ray.org_z = start.z();
    ray.ray.dir_x = direction.x();
    ray.ray.dir_y = direction.y();
    ray.ray.dir_z = direction.z();
    ray.ray.tnear = 0;
    ray.ray.tfar = static_cast<float>(line.length);
    ray.ray.time = 0;
    ray.ray.mask = std::numeric_limits<unsigned>::max();
    ray.ray.id = 0;
    ray.ray.flags = 0;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    hit.hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    if (!hit.hit) return;
    hit.range = ray.ray.tfar;
    hit.point = line.start + hit.range * line.direction;
    hit.normal = Eigen::Vector3f(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).cast<double>();
    hit.triangle = static_cast<int>(ray.hit.primID);
  }

  Eigen::Vector3d middle_;
  RTCDevice device_;
  RTCScene scene_ = nullptr;
};

}  // namespace

std::unique_ptr<Engine> BuildEmbree(const Source& source) {
  return std::make_unique<EmbreeEngine>(source.mesh, RTC_SCENE_FLAG_NONE);
}

std::unique_ptr<Engine> BuildEmbreeRobust(const Source& source) {
  return std::make_unique<EmbreeEngine>(source.mesh, RTC_SCENE_FLAG_ROBUST);
}

}  // namespace eod::bench
