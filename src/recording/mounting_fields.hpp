// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lanefuse/rig.pb.h"
#include "sensors/rig.hpp"

namespace lanefuse {

/// Private to this folder: a mounting as a part of messages. Numbers that are not finite are refused with an
/// Error (input).
void put(const Mounting& mounting, v1::Mounting& message);
Mounting take(const v1::Mounting& message);

}  // namespace lanefuse
