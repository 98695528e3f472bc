// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace toile::io {

/// A path from a URI, without its escapes: "my mesh.bin" for "my%20mesh.bin". Pure.
std::string withoutEscapes(std::string_view uri);

/// The path with links resolved, if it exists in this folder or below.
/// @param folder  empty: the working folder
std::optional<std::filesystem::path> pathBelow(const std::filesystem::path& folder,
                                               const std::filesystem::path& path);

/// Maximum total size of the buffers of a .gltf in bytes; more is refused.
inline constexpr std::uintmax_t kMaxBufferBytes = (1ULL << 31) - 1;

/// A hash that detects changes of a .gltf: of its text and of the files next to it that hold its
/// buffers, as its text names them; missing files are ignored.
/// @param text  of the file at this path
/// @param progress  polled between the buffers, nothing is reported
/// Errors: FileUnreadable if a buffer is not in the file's folder or below, is not a file (a pipe,
/// a device), cannot be read, or all exceed the limit; Cancelled.
/// Cost: linear in all of them. Re-entrant.
Result<std::uint64_t> hashWithBuffers(const std::filesystem::path& path, std::string_view text,
                                      const Progress& progress);

}  // namespace toile::io
