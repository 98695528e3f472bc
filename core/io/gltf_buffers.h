// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace toile::io {

/// A path as a URI has it, without its escapes: "my mesh.bin" for "my%20mesh.bin". Pure.
std::string withoutEscapes(std::string_view uri);

/// What tells whether a .gltf is another than it was: the hash of its text and of the files beside
/// it that hold its buffers, as its text names them; those that cannot be read do not count.
/// @param text  of the file at this path  Cost: linear in all of them. Re-entrant.
std::uint64_t hashWithBuffers(const std::filesystem::path& path, std::string_view text);

}  // namespace toile::io
