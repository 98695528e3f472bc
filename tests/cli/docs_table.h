// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::test {

/// Expects docs/<page> to have this text between its lines `<!-- table: <name>, written by a test
/// -->` and `<!-- end of table -->`; with TOILE_UPDATE_DOCS in the environment writes it there
/// instead.
void expectTableInDocs(const std::string& page, const std::string& name, const std::string& table);

/// The same for Markdown tables of measured figures: times are not looked at, other numbers may
/// differ as `differingFigures` allows.
void expectFiguresInDocs(const std::string& page, const std::string& name,
                         const std::string& table);

/// For tables of garments that a clone lacks: writes the table with TOILE_UPDATE_DOCS in the
/// environment, and else does nothing.
void updateTableInDocs(const std::string& page, const std::string& name, const std::string& table);

/// The first two lines that differ by more than rounding on another machine explains, or nothing.
/// Columns whose head speaks of time are left out; numbers with decimals may differ by half a
/// percent and one in the last digit, and below 1e-9 they are all alike; counts in a table by two
/// percent or one, but from zero only in a row with an energy that is none or beyond 1e12.
std::string differingFigures(const std::string& ours, const std::string& theirs);

}  // namespace toile::test
