// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_fields.h"
#include "core/cut/seams_file.h"

namespace toile {

/// Reads unit, cuts, joins and ease, the fields that a seams file and a project share.
/// @param easeUnit  the file's value for a side twice as long as the other: 100 for percent
/// @param withIds   whether cuts and the cuts that they mirror have ids: a seams file is written by
///                  people, without ids
void readSeams(JsonFields& fields, SeamsFile& seams, double easeUnit, bool withIds);

/// Maximum ease, as a part of the seam's right side: ten times as long again.
inline constexpr double kMaxEase = 10;

/// The field "cuts", "joins" or "ease" as JSON.
OrderedJson cutsJson(const SeamsFile& seams, bool withIds);
OrderedJson joinsJson(const SeamsFile& seams);
OrderedJson easeJson(const SeamsFile& seams, double easeUnit);

}  // namespace toile
