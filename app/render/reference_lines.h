// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/render/scene.h"

namespace toile {
struct PatternMatch;
}  // namespace toile

namespace toile::app {

/// Lines of a reference pattern over the flat pieces of a scene. Apart from that, since which
/// pieces they belong to is found out later. Shared and never changed.
struct ReferenceLines {
    std::vector<LineVertex> vertices{};
    LineRuns runs{};  ///< `LineRuns::reference` alone
};

/// The outlines of the file's pieces, each laid on the piece that it surely is. Pure; linear.
ReferenceLines referenceLines(const PatternMatch& match);

}  // namespace toile::app
