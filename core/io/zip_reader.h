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

/// Entries of an archive, and bytes of the meshes in it; what goes beyond is refused, and so is
/// what was packed more tightly than any mesh can be.
inline constexpr long long kMostZipEntries = 1000, kMostUnzippedBytes = (1LL << 31) - 1;
inline constexpr long long kTightestPacking = 300, kSmallUnzippedBytes = 1LL << 26;

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

}  // namespace toile::io
