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

/// Limits of an archive: entries, and bytes of all its meshes together. Those are limited by the
/// archive's size too: meshes as text pack 3 to 15 times, so more than that is no mesh.
inline constexpr long long kMaxZipEntries = 1000, kMaxUnzippedBytes = (1LL << 31) - 1;
inline constexpr long long kMaxUnpackingRatio = 30, kSmallUnzippedBytes = 1LL << 25;

struct UnzippedFile {
    std::string name;  ///< in the archive
    std::shared_ptr<const std::string> bytes;
};

/// The meshes in a .zip archive: all files with the first of the endings that any of them has, in
/// the archive's order. Folders, hidden files and what macOS adds are passed over. Unpacked in
/// memory; nothing is written anywhere, so that names in the archive mean nothing.
/// @param archive  its bytes  @param name  the archive, for messages
/// @param endings  ".obj" ...: what can be read, the likeliest first
/// Errors: MalformedFile; NoGeometry where no mesh is in it; FileUnreadable where one is encrypted,
/// packed in a way that is not known, or where they are beyond the bounds; Cancelled.
/// Cost: linear in the meshes. Re-entrant.
Result<std::vector<UnzippedFile>> meshesInZip(std::string_view archive, const std::string& name,
                                              std::span<const std::string_view> endings,
                                              const Progress& progress);

/// The first 64 KiB of the first file in an archive whose name ends so, in any case; empty where
/// none can be read.
std::string startOfZipEntry(std::string_view archive, std::string_view ending);

}  // namespace toile::io
