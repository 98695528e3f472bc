// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/formats.h"

namespace toile::test {

/// Whether a format is read back by the program when it writes, or by the readers in this folder.
bool isReadBack(const Format& format);

/// Reads the files of such a format again and compares them with what they were made from: by the
/// format's own `readBack`; PDF, HPGL, USD and GLB files by the readers in this folder, which share
/// no code with the writers. Errors: NotReadBack. Pure.
Result<ReadBack> readBack(const Format& format, const ExportedFiles& files,
                          const ExportSource& source);

}  // namespace toile::test
