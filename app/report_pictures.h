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

/// Pictures for the HTML report: garment and pattern as in the views, with checkerboard and with
/// strain. Empty if there is no OpenGL without a window. Call from one thread at a time, without a
/// current context of its own. Without an application, call from the main thread: this creates one
/// without a screen, which lives until exit. Cost: that of the scene, plus tenths of a second in
/// software rendering.
std::vector<ReportPicture> reportPictures(const ExportSource& source);

/// Options for a picture of a proof.
struct ProofPicture {
    Overlay overlay = Overlay::Gap;
    double sewn = 1;  ///< position between designed (0) and sewn (1) garment
    int width = 1600, height = 800;
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< nullopt: the initial view
    bool dark = false;
};

/// A proved pattern as in the views with the legend below, as bytes of a PNG file. Empty without
/// OpenGL. Threads and application: see `reportPictures`.
/// @param proof  of the source's garment, not null
std::string proofPicture(const ExportSource& source, const std::shared_ptr<const Proof>& proof,
                         const ProofPicture& wanted = {});

}  // namespace toile::app
