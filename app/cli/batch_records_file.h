// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/cli/refusal.h"

namespace toile::app {

struct BatchArguments;

/// The file of the records of all garments of a list: shirts.jsonl of shirts.txt; stdin.jsonl.
std::filesystem::path recordsOf(const BatchArguments& batch);

/// Why a list must not have these records: they would take the place of the list itself, or of
/// those of another of the same name that is still there. Which list they are of is put down beside
/// them, in shirts.jsonl.of; a list that is no file has no such note, and where what has that name
/// is none it stays. Otherwise nothing, or what `writeFile` says. Precondition: the folder is
/// there, if it can be made.
std::optional<Refusal> refusalOfRecords(const BatchArguments& batch);

}  // namespace toile::app
