// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace toile {

/// What a project file held when it was last read or written here: what else it holds now, another
/// program has put there. Shared by those jobs that run one after the other; the GUI thread makes
/// one, and leaves it to them.
struct KnownFile {
    std::filesystem::path path{};
    std::optional<std::uint64_t> hash{};  ///< contentHash of the bytes; none: not known
};

/// True where there is such a file, and it holds something else. Reads it.
bool wasChangedByOthers(const KnownFile& known);

}  // namespace toile
