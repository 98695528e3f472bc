// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile {

/// The whole file as bytes. Errors: FileUnreadable (missing, a folder, a pipe or a device, no
/// permission, longer than 2 GiB); OutOfMemory.
Result<std::string> readFile(const std::filesystem::path& path);

/// A path with forward slashes, as UTF-8.
std::string pathText(const std::filesystem::path& path);

/// Writes a temporary file next to the target, flushes it to the disk and renames it: the target is
/// always either the old file or the complete new one. If a process is killed at the wrong moment,
/// the next write of the same file deletes what it left. Links are followed, also if their target
/// does not exist yet; owner, permissions and access list of an old file are kept. Writes in place,
/// not atomically, if the target cannot be replaced: a pipe or a terminal, a file in a read-only
/// folder, another user's file whose ownership a new one would change.
/// Errors: FileUnwritable.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toile
