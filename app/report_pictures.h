// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/view_state.h"
#include "core/formats/writers.h"

namespace toile {
struct Proof;
}  // namespace toile

namespace toile::app {

/// What the HTML report shows beside the drawing: the garment and its pattern as the views have
/// them, with the checkerboard and with the strain. None where there is no OpenGL without a window.
/// Any thread without a context of its own, one at a time; before there is an application, the main
/// thread: it makes one then, without a screen, that stays to the end of the program. Cost: that of
/// the scene, and tenths of a second where the processor draws.
std::vector<ReportPicture> reportPictures(const ExportSource& source);

/// What a picture of a proof shows.
struct ProofPicture {
    Overlay overlay = Overlay::Gap;
    double sewn = 1;  ///< the garment from as designed, 0, to as sewn, 1
    int width = 1600, height = 800;
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< none: as the window begins
    bool dark = false;
};

/// A pattern that was sewn back together, as the views have it with the legend below, as a PNG
/// file's bytes; empty where there is no OpenGL without a window. As `reportPictures` else.
/// @param proof  of the source's garment, not null
std::string proofPicture(const ExportSource& source, const std::shared_ptr<const Proof>& proof,
                         const ProofPicture& wanted = {});

}  // namespace toile::app
