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

/// A path as a URI has it, without its escapes: "my mesh.bin" for "my%20mesh.bin". Pure.
std::string withoutEscapes(std::string_view uri);

/// The path with links resolved, if something is there that is in this folder or below.
/// @param folder  empty: the working folder
std::optional<std::filesystem::path> pathBelow(const std::filesystem::path& folder,
                                               const std::filesystem::path& path);

/// Bytes of all the buffers of a .gltf together; what goes beyond is refused.
inline constexpr std::uintmax_t kMostBufferBytes = (1ULL << 31) - 1;

/// What tells whether a .gltf is another than it was: the hash of its text and of the files beside
/// it that hold its buffers, as its text names them; those that are not there do not count.
/// @param text  of the file at this path
/// @param progress  polled between the buffers, nothing is reported
/// Errors: FileUnreadable where a buffer does not lie in the file's folder or below, is no file
/// (a pipe, a device), cannot be read, or all are beyond the bound; Cancelled.
/// Cost: linear in all of them. Re-entrant.
Result<std::uint64_t> hashWithBuffers(const std::filesystem::path& path, std::string_view text,
                                      const Progress& progress);

}  // namespace toile::io
