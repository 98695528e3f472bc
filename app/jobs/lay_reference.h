// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/document/reference.h"
#include "app/jobs/reference_finder.h"
#include "core/base/result.h"

namespace toile::app {

/// The work behind a reference pattern, for jobs, for `ReferenceFinder` and for pictures without a
/// window.

/// Reads a pattern by its ending. Errors: of `readPatternFile`.
/// @param path  absolute
Result<ReferenceFile> readReference(const std::filesystem::path& path);

/// What is to be found out of the document's reference pattern; none where none is open, or no
/// pattern is there yet.
std::optional<ReferenceQuestion> referenceQuestion(const Document& document);

/// Pairs the pieces and lays the file's outlines on them. Pure. Cost: of `matchPatterns`.
ReferenceMatch layReference(const ReferenceQuestion& question);

}  // namespace toile::app
