// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/pipeline/pipeline.h"

namespace toile::app {

/// What was typed of how pieces are flattened; nothing where it was not.
struct StatedOptions {
    std::optional<Method> method{};
    std::optional<Quality> quality{};
    std::optional<BoundarySolver> boundarySolver{};
    std::optional<FreeBoundary> freeBoundary{};
    std::optional<StretchOutline> stretchOutline{};
    std::optional<double> authalic{};
    std::optional<Fairing> fairing{};
    bool trueSeams = false;
    std::optional<Mirror> mirror{};
    bool byHalf = false;                       ///< every piece, in files; asks for mirrored pieces
    std::optional<double> allowance{}, hem{};  ///< AllowanceWidths; mm
    std::optional<bool> notches{};             ///< placed by themselves, or none
    std::optional<GrainRule> grain{};
    bool pattern = false;                       ///< `withPattern`
    std::optional<std::string> size{}, date{};  ///< LabelTexts

    /// These options where something was typed, the given ones else.
    FlattenOptions over(FlattenOptions options) const;
    LineSettings over(LineSettings lines) const;

    bool operator==(const StatedOptions&) const = default;
};

}  // namespace toile::app
