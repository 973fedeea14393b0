// SPDX-License-Identifier: Apache-2.0
// Embree 3 or 4, whichever is installed, behind the names that this folder uses.
#pragma once

#include <memory>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sundog::embree {

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using Scene = std::unique_ptr<RTCSceneTy, Release>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

#if RTC_VERSION_MAJOR >= 4
/// What callbacks are told of the query that they are part of.
using Context = RTCRayQueryContext;
inline Context make_context() {
    Context context;
    rtcInitRayQueryContext(&context);
    return context;
}

/// How a query is made: coherent rays are traced as a packet, others one by one where that is faster.
struct Query {
    [[gnu::always_inline]] explicit Query(bool coherent) {
        rtcInitIntersectArguments(&intersect);
        rtcInitOccludedArguments(&occluded);
        intersect.flags = occluded.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    }
    RTCIntersectArguments intersect;
    RTCOccludedArguments occluded;
};
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit4& ray) {
    rtcIntersect4(valid, scene, &ray, &query.intersect);
}
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit8& ray) {
    rtcIntersect8(valid, scene, &ray, &query.intersect);
}
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit16& ray) {
    rtcIntersect16(valid, scene, &ray, &query.intersect);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay4& ray) {
    rtcOccluded4(valid, scene, &ray, &query.occluded);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay8& ray) {
    rtcOccluded8(valid, scene, &ray, &query.occluded);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay16& ray) {
    rtcOccluded16(valid, scene, &ray, &query.occluded);
}
#else
/// What callbacks are told of the query that they are part of.
using Context = RTCIntersectContext;
inline Context make_context() {
    Context context;
    rtcInitIntersectContext(&context);
    return context;
}

/// How a query is made: coherent rays are traced as a packet, others one by one where that is faster.
struct Query {
    [[gnu::always_inline]] explicit Query(bool coherent) {
        rtcInitIntersectContext(&context);
        context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    RTCIntersectContext context;
};
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit4& ray) {
    rtcIntersect4(valid, scene, &query.context, &ray);
}
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit8& ray) {
    rtcIntersect8(valid, scene, &query.context, &ray);
}
[[gnu::always_inline]] inline void closest_hit(const int* valid, RTCScene scene, Query& query, RTCRayHit16& ray) {
    rtcIntersect16(valid, scene, &query.context, &ray);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay4& ray) {
    rtcOccluded4(valid, scene, &query.context, &ray);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay8& ray) {
    rtcOccluded8(valid, scene, &query.context, &ray);
}
[[gnu::always_inline]] inline void any_hit(const int* valid, RTCScene scene, Query& query, RTCRay16& ray) {
    rtcOccluded16(valid, scene, &query.context, &ray);
}
#endif

}  // namespace sundog::embree
