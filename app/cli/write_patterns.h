// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <vector>

#include "app/cli/refusal.h"
#include "core/formats/export_source.h"

namespace toile::app {

/// Why there is no pattern to take away or to sew: no piece lies flat. Nothing where one does.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results);

/// The same of these files: a report has to say also why none does.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results,
                                          const std::vector<std::filesystem::path>& outputs);

/// Why a pattern was not sewn: where nothing of it is flat, that says more than the error.
Refusal refusalOfProof(const Error& error, const PieceResults& results);

/// Exports a pattern to files, and says of each that it is written and how it reads back, or why it
/// is not. @return whether all are written
bool writePatterns(const std::vector<std::filesystem::path>& outputs, const ExportSource& source,
                   std::ostream& out, std::ostream& err);

}  // namespace toile::app
