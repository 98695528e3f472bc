// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/formats/export_source.h"
#include "core/formats/formats.h"

namespace toile::test {

/// A garment with all that its files are made of.
struct ExportedGarment {
    Garment garment{};
    PieceResults results{};
    LaidOutPattern laid{};

    ExportSource source(const ExportOptions& options = {}) const {
        return {garment, results, laid, options};
    }
};

ExportOptions dxfOptions(DxfProfile profile, LengthUnit unit = LengthUnit::Millimetre);

/// A pattern alone, laid out.
ExportedGarment exported(Pattern pattern);
/// Of the samples or of the shared garments, as `withPattern` draws it or as it is.
ExportedGarment exported(const std::string& file, bool isPattern);
/// Draws halves of what is symmetric, each cut twice.
void cutByHalf(ExportedGarment& made);

/// `sewingPattern` with internal lines, drill points, a hole with a notch on its rim, notches, and
/// one piece turned and mirrored.
ExportedGarment markedPieces(NotchForm form = NotchForm::Slit);

/// The first file.
std::string dxfOf(const ExportedGarment& garment, const ExportOptions& options);

}  // namespace toile::test
