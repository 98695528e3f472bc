// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::test {

/// Expects docs/<page> to have this text between its lines `<!-- table: <name>, written by a test
/// -->` and `<!-- end of table -->`; with TOILE_UPDATE_DOCS in the environment writes it there
/// instead.
void expectTableInDocs(const std::string& page, const std::string& name, const std::string& table);

}  // namespace toile::test
