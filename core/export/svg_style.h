// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/export/drawing.h"
#include "core/export/export_options.h"

namespace toile {

/// How an SVG file is written for a program or machine.
struct SvgStyle {
    const char* unit = "mm";   ///< of the page and, without saying so, of every number
    double perMillimetre = 1;  ///< units
    double stroke = 0.3;       ///< mm
    bool hasSeams = true;      ///< the sides of seams as lines that are not seen
    bool textAsPaths = false;
    std::array<const char*, kLayerKinds.size()> colours{};  ///< in the order of the kinds
    std::vector<LayerKind> order{};                         ///< of the layers

    const char* colourOf(LayerKind kind) const { return colours[static_cast<std::size_t>(kind)]; }
};

SvgStyle svgStyle(const SvgOptions& options);

/// "cut", as layers are called.
const char* svgLayerName(LayerKind kind);

/// Places and lengths of a drawing in the numbers of the file: y counted downwards from the top of
/// the page.
class SvgScale {
public:
    SvgScale(const SvgStyle& style, double pageHeight)
        : scale_(style.perMillimetre), height_(pageHeight) {}

    /// "12.0000,7.5000"
    void append(std::string& out, const Eigen::Vector2d& point) const;
    std::string x(const Eigen::Vector2d& point) const;
    std::string y(const Eigen::Vector2d& point) const;
    /// A length, in the decimals of places.
    std::string length(double millimetres) const;
    /// In as few digits as it needs: sizes of whole numbers read better without decimals.
    std::string size(double millimetres) const;

private:
    double scale_, height_;
};

}  // namespace toile
