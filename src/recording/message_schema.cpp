// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/message_schema.hpp"

#include <cassert>
#include <set>

#include <google/protobuf/descriptor.pb.h>

#include "foxglove/camera_calibration.pb.h"
#include "foxglove/compressed_image.pb.h"
#include "foxglove/frame_transforms.pb.h"
#include "foxglove/location_fix.pb.h"
#include "foxglove/log.pb.h"
#include "foxglove/scene.pb.h"
#include "lanefuse/camera_view.pb.h"
#include "lanefuse/debug_view.pb.h"
#include "lanefuse/lane_estimate.pb.h"
#include "lanefuse/measurements.pb.h"
#include "lanefuse/rig.pb.h"
#include "osi3/osi_groundtruth.pb.h"
#include "osi3/osi_hostvehicledata.pb.h"
#include "osi3/osi_sensordata.pb.h"
#include "recording/message_bytes.hpp"
#include "recording/topics.hpp"

namespace lanefuse {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FileDescriptor;
using google::protobuf::FileDescriptorSet;

struct Entry {
  std::string_view topic;
  const Descriptor* (*descriptor)();
};

constexpr Entry kEntries[] = {
    {topic::kCalibration, &v1::Rig::descriptor},
    {topic::kTransforms, &foxglove::FrameTransforms::descriptor},
    {topic::kVehicleMotion, &osi3::HostVehicleData::descriptor},
    {topic::kWheelSpeeds, &v1::WheelSpeeds::descriptor},
    {topic::kSerialCamera, &v1::SerialLane::descriptor},
    {topic::kHighResolutionCamera, &v1::MarkingFeatures::descriptor},
    {topic::kRadar, &v1::RadarScan::descriptor},
    {topic::kObjects, &osi3::SensorData::descriptor},
    {topic::kCameraBoxes, &v1::CameraBoxes::descriptor},
    {topic::kGnssIns, &foxglove::LocationFix::descriptor},
    {topic::kImage, &foxglove::CompressedImage::descriptor},
    {topic::kCameraCalibration, &foxglove::CameraCalibration::descriptor},
    {topic::kLanes, &v1::LaneEstimate::descriptor},
    {topic::kLaneBoundaries, &osi3::SensorData::descriptor},
    {topic::kFusedFeatures, &v1::FusedFeatures::descriptor},
    {topic::kSwitches, &v1::SwitchStates::descriptor},
    {topic::kRoadCourse, &v1::RoadCourse::descriptor},
    {topic::kScene, &foxglove::SceneUpdate::descriptor},
    {topic::kCameraView, &v1::CameraView::descriptor},
    {topic::kTrackedObjects, &osi3::SensorData::descriptor},
    {topic::kStatus, &foxglove::Log::descriptor},
    {topic::kTrueRoad, &osi3::GroundTruth::descriptor},
    {topic::kTrueFrame, &osi3::GroundTruth::descriptor},
};

const Descriptor* descriptor_of(std::string_view topic) {
  for (const Entry& entry : kEntries) {
    if (entry.topic == topic) return entry.descriptor();
  }
  return nullptr;
}

/// A file behind all that it imports, so that readers can build one after the other.
void add_with_imports(const FileDescriptor& file, std::set<const FileDescriptor*>& seen,
                      FileDescriptorSet& set) {
  if (!seen.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) add_with_imports(*file.dependency(i), seen, set);
  file.CopyTo(set.add_file());
}

}  // namespace

MessageSchema schema_of(std::string_view topic) {
  const Descriptor* descriptor = descriptor_of(topic);
  assert(descriptor);
  FileDescriptorSet set;
  std::set<const FileDescriptor*> seen;
  add_with_imports(*descriptor->file(), seen, set);
  return {descriptor->full_name(), to_bytes(set), descriptor->file()->package() == "osi3"};
}

std::string schema_name_of(std::string_view topic) {
  const Descriptor* descriptor = descriptor_of(topic);
  return descriptor ? descriptor->full_name() : "";
}

std::string protobuf_version() { return google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION); }

}  // namespace lanefuse
