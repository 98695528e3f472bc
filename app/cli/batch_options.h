// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

struct BatchArguments;

/// Adds what `toile batch` is told beside the options of flatten to a command.
void addBatchOptions(CLI::App& command, BatchArguments& batch);

/// `BatchArguments::words` of a command that has been parsed.
std::vector<std::string> flattenWords(const CLI::App& command);

}  // namespace toile::app
