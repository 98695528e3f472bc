// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/exported_garments.h"

#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "core/pattern/half_pattern.h"
#include "core/toile/pipeline.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile::test {

ExportOptions dxfOptions(DxfProfile profile, LengthUnit unit) {
    ExportOptions options;
    options.dxf.profile = profile;
    options.dxf.unit = unit;
    return options;
}

ExportedGarment exported(Pattern pattern) {
    ExportedGarment made;
    made.laid = cutAndPlace(std::move(pattern));
    return made;
}

ExportedGarment exported(const std::string& file, bool isPattern) {
    ExportedGarment made;
    made.garment = garmentOf(file);
    const LineSettings lines = isPattern ? withPattern({}) : LineSettings{};
    Progress progress;
    made.results = flattenGarment(made.garment, {}, progress, 0, lines);
    Pattern pattern = makePattern(made.garment, made.results, lines);
    for (PatternPiece& piece : pattern.pieces) {
        piece.grain = isPattern ? std::optional(kGrainUpwards) : std::nullopt;
    }
    made.laid = cutAndPlace(std::move(pattern));
    return made;
}

void cutByHalf(ExportedGarment& made) {
    Pattern pattern = std::move(made.laid.wholePattern);
    for (PatternPiece& piece : pattern.pieces) {
        piece.byHalf = true;
        piece.quantity = 2;
    }
    made.laid = cutAndPlace(std::move(pattern));
}

ExportedGarment markedPieces(NotchForm form) {
    Pattern pattern = sewingPattern();
    pattern.hasNotches = true;
    pattern.notchForm = form;
    PatternPiece& panel = pattern.pieces[0];
    const Eigen::RowVector2d middle = panel.outline.colwise().mean();
    panel.holes.push_back(curvedPanel(40, 20).colwise().reverse());
    panel.holes[0].rowwise() += middle - panel.holes[0].colwise().mean();
    Points2 line(4, 2);
    line << 0, -60, 20, -70, 60, -70, 80, -55;
    panel.internals.push_back({0, "style line", line.rowwise() + middle});
    panel.internals.push_back({1, "button", middle + Eigen::RowVector2d(-50, 30)});
    panel.internals.push_back(
        {2, "patch", rectangle(middle.x() + 30, middle.y() + 40, 35, 25), true});
    panel.notches = {{1, 0.25, -1, 100, 1}, {1, 0.5, -1, 420.5, 2}, {2, 0.5, 0, 30, 1}};
    panel.grain = 0.3;
    ExportedGarment made = exported(std::move(pattern));
    Placement& turned = made.laid.marker.copies[0].placement;
    turned.mirrored = true;
    turned.turn = 0.4;
    return made;
}

std::string dxfOf(const ExportedGarment& garment, const ExportOptions& options) {
    const auto files = formatOf(FormatId::Dxf).write(garment.source(options));
    EXPECT_TRUE(files);
    return files ? files->front().bytes : std::string();
}

}  // namespace toile::test
