// SPDX-License-Identifier: Apache-2.0
// The functions of Embree 3 that the ground truth calls, loaded when first asked for: the library is larger
// than everything else together, and the program does all but the ground truth without it.
#pragma once

#include <embree3/rtcore.h>

namespace report {

struct Embree {
    decltype(&rtcNewDevice) newDevice;
    decltype(&rtcReleaseDevice) releaseDevice;
    decltype(&rtcGetDeviceError) getDeviceError;
    decltype(&rtcNewScene) newScene;
    decltype(&rtcReleaseScene) releaseScene;
    decltype(&rtcSetSceneFlags) setSceneFlags;
    decltype(&rtcSetSceneBuildQuality) setSceneBuildQuality;
    decltype(&rtcCommitScene) commitScene;
    decltype(&rtcNewGeometry) newGeometry;
    decltype(&rtcReleaseGeometry) releaseGeometry;
    decltype(&rtcSetNewGeometryBuffer) setNewGeometryBuffer;
    decltype(&rtcSetGeometryUserData) setGeometryUserData;
    decltype(&rtcSetGeometryIntersectFilterFunction) setGeometryIntersectFilterFunction;
    decltype(&rtcSetGeometryOccludedFilterFunction) setGeometryOccludedFilterFunction;
    decltype(&rtcCommitGeometry) commitGeometry;
    decltype(&rtcAttachGeometryByID) attachGeometryByID;
    decltype(&rtcIntersect1) intersect1;
    decltype(&rtcOccluded1) occluded1;
};

// libembree3.so.3 where the loader finds it, else ../lib/libembree3.so.3.gz beside the program, unpacked into
// memory. Throws a sentence when there is neither.
const Embree& embree();

} // namespace report
