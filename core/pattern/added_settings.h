// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/words.h"
#include "core/garment/seam.h"

namespace toile {

/// User settings for additions to the outlines of a pattern. Like `SegmentSettings` they refer to
/// stretches of rims and cuts, or to places on the garment, never to flat coordinates.

/// The leg over which a closed dart is laid.
enum class DartLay { First, Second };

/// Their names in project files.
inline constexpr Word<DartLay> kDartLayWords[] = {{DartLay::First, "first"},
                                                  {DartLay::Second, "second"}};

/// Settings of a dart.
struct DartSettings {
    SeamPlace seam;  ///< its two legs
    /// Distance of the legs at the mouth, mm; empty: as the cloth lies flat.
    std::optional<double> intake{};
    std::optional<DartLay> lay{};  ///< none: by convention (`findDarts`)

    bool operator==(const DartSettings&) const = default;

    bool saysNothing() const { return !intake && !lay; }
};

/// Limits of an intake, mm.
inline constexpr double kMinIntake = 0.1, kMaxIntake = 1000;

/// A strip along the outline of one piece that is copied as a piece of its own: the facing of a
/// neckline, the lining of a waistband.
struct Facing {
    std::string name{};                ///< empty: named after its piece
    std::vector<LineStretch> edges{};  ///< of neighbouring segments, along the outline
    double width = 50;                 ///< mm, from the outline inwards

    bool operator==(const Facing&) const = default;
};

/// Limits of the width of facings and extensions, mm.
inline constexpr double kMinStrip = 1, kMaxStrip = 1000;

/// A line drawn within the cloth: style line, pocket place, quilting; a single point is a drill
/// point.
struct InternalLine {
    std::string name{};
    /// One or more, near the surface, in axes and unit of the garment's first file.
    std::vector<Eigen::Vector3d> points{};
    bool closed = false;  ///< leads back to the first of three or more points

    bool operator==(const InternalLine&) const = default;
};

/// Texts on the labels of all pieces.
struct LabelTexts {
    std::string size{};
    std::string date{};  ///< as it is printed

    bool operator==(const LabelTexts&) const = default;
};

}  // namespace toile
