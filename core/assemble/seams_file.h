// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_fields.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/cut/user_cuts.h"

namespace toile {

/// The contents of a seams file: seams to remove, the user's cuts, and the intended ease of seams.
/// The format is described in docs/seams.md.
struct SeamsFile {
    /// Of all points; if missing, they are in the unit of the garment's own file.
    std::optional<FileUnit> unit;
    std::vector<UserCut> cuts;      ///< points as written, in the axes of the garment's file
    std::vector<UserJoin> joins{};  ///< likewise; made before the cuts
    /// By the seam's name: intended extra length of its left side, as a part of the right (0.1 = 10
    /// %; the file uses percent).
    std::map<std::string, double> ease;

    bool empty() const { return cuts.empty() && joins.empty() && ease.empty(); }
    bool operator==(const SeamsFile&) const = default;
};

/// Errors: FileUnreadable; MalformedFile, naming the entry and the fault. Linear.
/// @param notes  if not null: receives unknown fields of the file (UnknownKey)
Result<SeamsFile> readSeamsFile(const std::filesystem::path& path, Problems* notes = nullptr);
/// The same for a text in memory. `name` is used in messages only.
Result<SeamsFile> parseSeamsFile(std::string_view text, const std::string& name,
                                 Problems* notes = nullptr);
/// The file's text; reads back to the same values.
std::string writeSeamsFile(const SeamsFile& file);

/// "path", "loop", "dart".
std::string_view name(UserCut::Kind kind);

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
