// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "core/flatten/base/piece_result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"
#include "core/pattern/line_settings.h"

namespace toile {

/// All data that files are made from and compared with. The referenced data must outlive it. For
/// one thread: the drawing is made on first use.
class ExportSource {
public:
    /// @param results  one per piece of the garment  @param laid  its pattern
    /// @param drawing  of `laid`, if it differs from that of `draw`
    ExportSource(const Garment& garment, const PieceResults& results, const LaidOutPattern& laid,
                 const ExportOptions& options = {}, DrawingWords words = {},
                 LineSettings lines = {}, Fabric fabric = fabricPresets().front(),
                 std::optional<Drawing> drawing = std::nullopt)
        : garment_(garment),
          results_(results),
          laid_(laid),
          options_(options),
          words_(std::move(words)),
          lines_(std::move(lines)),
          fabric_(std::move(fabric)),
          drawing_(std::move(drawing)) {}

    const Garment& garment() const { return garment_; }
    const PieceResults& results() const { return results_; }
    const LaidOutPattern& laid() const { return laid_; }
    const ExportOptions& options() const { return options_; }
    const DrawingWords& words() const { return words_; }
    /// The settings with which the outlines were drawn.
    const LineSettings& lines() const { return lines_; }
    /// The fabric of pieces without a material of the pattern.
    const Fabric& fabric() const { return fabric_; }

    /// The drawing of `laid().pattern`.
    const Drawing& drawing() const {
        if (!drawing_) {
            drawing_ = draw(laid_.pattern, laid_.marker, words_);
        }
        return *drawing_;
    }

private:
    const Garment& garment_;
    const PieceResults& results_;
    const LaidOutPattern& laid_;
    ExportOptions options_;
    DrawingWords words_;
    LineSettings lines_;
    Fabric fabric_;
    mutable std::optional<Drawing> drawing_;
};

}  // namespace toile
