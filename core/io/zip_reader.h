// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace toile::io {

/// Entries of an archive, and bytes of the mesh in it; what goes beyond is refused, and so is what
/// was packed more tightly than any mesh can be.
inline constexpr long long kMostZipEntries = 1000, kMostUnzippedBytes = (1LL << 31) - 1;
inline constexpr long long kTightestPacking = 300, kSmallUnzippedBytes = 1LL << 26;

struct UnzippedFile {
    std::string name;  ///< in the archive
    std::shared_ptr<const std::string> bytes;
};

/// The mesh in a .zip archive: the only OBJ file of it, else the only file with one of the endings.
/// Folders, hidden files and what macOS adds are passed over. Unpacked in memory; nothing is
/// written anywhere, so that names in the archive mean nothing.
/// @param archive  its bytes  @param name  the archive, for messages
/// @param endings  ".obj" ...: what can be read
/// Errors: MalformedFile; NoGeometry where no mesh is in it; FileUnreadable where there are
/// several, where it is encrypted, packed in a way that is not known, or beyond the bounds;
/// Cancelled. Cost: linear in the mesh. Re-entrant.
Result<UnzippedFile> meshInZip(std::string_view archive, const std::string& name,
                               std::span<const std::string_view> endings, const Progress& progress);

}  // namespace toile::io
