// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile {

/// The whole file as bytes. Errors: FileUnreadable (missing, a folder, no permission).
Result<std::string> readFile(const std::filesystem::path& path);

/// Writes beside the target, flushes to the disk, renames: the target is either the old file or the
/// whole new one, whatever happens; permissions and links stay. What is no file (a pipe, a
/// terminal) is written to directly. Errors: FileUnwritable.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toile
