// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_fields.h"
#include "core/cut/seams_file.h"

namespace toile {

/// Reads unit, cuts, joins and ease, which a seams file and a project have alike.
/// @param easeUnit  what the file writes for a side twice as long as the other: 100 for percent
/// @param withIds   of cuts, and of those that they mirror: a seams file is written by people, and
///                  has none
void readSeams(JsonFields& fields, SeamsFile& seams, double easeUnit, bool withIds);

/// The most ease that can be stated, as a part of the seam's right side: ten times as long again.
inline constexpr double kMaxEase = 10;

/// The fields of these names.
OrderedJson cutsJson(const SeamsFile& seams, bool withIds);
OrderedJson joinsJson(const SeamsFile& seams);
OrderedJson easeJson(const SeamsFile& seams, double easeUnit);

}  // namespace toile
