// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile {

/// The whole file as bytes. Errors: FileUnreadable (missing, a folder, no permission, longer than 2
/// GiB); OutOfMemory.
Result<std::string> readFile(const std::filesystem::path& path);

/// A path with forward slashes, as UTF-8.
std::string pathText(const std::filesystem::path& path);

/// Writes beside the target, flushes to the disk, renames: the target is either the old file or the
/// whole new one, whatever happens, and nothing else is left: what a process killed at the wrong
/// moment leaves is taken away at the next write of the same file. Links lead on to what they name,
/// also where that is not there yet; owner, permissions and access list of an old file stay.
/// Written in place, so not in one step, is what cannot be replaced: a pipe or a terminal, a file
/// in a folder that lets nothing be made, a file of another's that a new one would take from them.
/// Errors: FileUnwritable.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace toile
