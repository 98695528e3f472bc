// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace toile::io {

/// Limits of an archive: entries, and bytes of all its meshes together. The latter are limited by
/// the archive's size too: meshes as text compress 3 to 15 times, so more is not a mesh.
inline constexpr long long kMaxZipEntries = 1000, kMaxUnzippedBytes = (1LL << 31) - 1;
inline constexpr long long kMaxUnpackingRatio = 30, kSmallUnzippedBytes = 1LL << 25;

struct UnzippedFile {
    std::string name;  ///< in the archive
    std::shared_ptr<const std::string> bytes;
};

/// The meshes in a .zip archive: all files with the first of the endings that any of them has, in
/// the archive's order. Folders, hidden files and those that macOS adds are skipped. Unpacked in
/// memory; nothing is written to disk, so that names in the archive are harmless.
/// @param archive  its bytes  @param name  the archive, for messages
/// @param endings  ".obj" ...: readable endings, the most likely first
/// Errors: MalformedFile; NoGeometry if it contains no mesh; FileUnreadable if one is encrypted,
/// packed in an unknown way, or if they exceed the limits; Cancelled.
/// Cost: linear in the meshes. Re-entrant.
Result<std::vector<UnzippedFile>> meshesInZip(std::string_view archive, const std::string& name,
                                              std::span<const std::string_view> endings,
                                              const Progress& progress);

/// The first 64 KiB of the first file in an archive with this ending, ignoring case; empty if none
/// can be read.
std::string startOfZipEntry(std::string_view archive, std::string_view ending);

}  // namespace toile::io
