// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"

namespace toile {

/// The style of an SVG file for a program or machine.
struct SvgStyle {
    const char* unit = "mm";   ///< of the page, and implied for every number
    double perMillimetre = 1;  ///< units per mm
    double stroke = 0.3;       ///< mm
    bool hasSeams = true;      ///< the sides of seams as invisible lines
    bool textAsPaths = false;
    std::array<const char*, kLayerKinds.size()> colours{};  ///< in the order of the kinds
    std::vector<LayerKind> order{};                         ///< of the layers

    const char* colourOf(LayerKind kind) const { return colours[static_cast<std::size_t>(kind)]; }
};

SvgStyle svgStyle(const SvgOptions& options);

/// Converts places and lengths of a drawing to numbers of the file: y counted downwards from the
/// top of the page.
class SvgScale {
public:
    SvgScale(const SvgStyle& style, double pageHeight)
        : scale_(style.perMillimetre), height_(pageHeight) {}

    /// "12.0000,7.5000"
    void append(std::string& out, const Eigen::Vector2d& point) const;
    std::string x(const Eigen::Vector2d& point) const;
    std::string y(const Eigen::Vector2d& point) const;
    /// A length, with as many decimals as places.
    std::string length(double millimetres) const;
    /// With as few digits as needed: whole numbers have no decimals.
    std::string size(double millimetres) const;

private:
    double scale_, height_;
};

}  // namespace toile
