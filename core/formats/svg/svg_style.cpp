// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg/svg_style.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/formats/writers.h"

namespace toile {
namespace {

using SvgColours = std::array<const char*, kLayerKinds.size()>;

constexpr SvgColours kScreenColours{"#ff0000", "#606060", "#c06000", "#0070c0",
                                    "#008000", "#800080", "#000000", "#0000ff"};

/// LightBurn identifies operations by the colours of its palette and maps others to the nearest
/// one, which could merge two of ours. In its numbers: 02, 01, 05, 06, 03, 07, 00, 09.
constexpr SvgColours kLaserColours{"#ff0000", "#0000ff", "#ff8000", "#00e0e0",
                                   "#00e000", "#ff00ff", "#000000", "#0000a0"};

/// A thousandth of an inch: laser drivers follow a line this thin instead of filling it.
constexpr double kHairline = 0.0254;  // mm

/// Lines that hold the piece are cut last, because a loose piece may move.
std::vector<LayerKind> cutLast() {
    std::vector<LayerKind> order(kLayerKinds.begin(), kLayerKinds.end());
    std::rotate(order.begin(), order.begin() + 1, order.end());
    return order;
}

}  // namespace

SvgStyle svgStyle(const SvgOptions& options) {
    SvgStyle style;
    style.textAsPaths = options.textAsPaths;
    style.colours = kScreenColours;
    style.order.assign(kLayerKinds.begin(), kLayerKinds.end());
    // These programs read a number without a unit as a point, 1/72 inch, regardless of the page
    // size. A page in points means the same to all other programs.
    if (options.preset == SvgPreset::Illustrator || options.preset == SvgPreset::Silhouette ||
        options.preset == SvgPreset::Cricut) {
        style.unit = "pt";
        style.perMillimetre = kPointsPerMillimetre;
    }
    // Cutters follow invisible lines too.
    style.hasSeams =
        options.preset == SvgPreset::Inkscape || options.preset == SvgPreset::Illustrator;
    if (options.preset == SvgPreset::Cricut) {
        style.textAsPaths = true;  // Design Space reads neither texts nor most transforms
    }
    if (options.preset == SvgPreset::Laser) {
        style.colours = kLaserColours;
        style.stroke = kHairline;
        style.order = cutLast();
    }
    return style;
}

void SvgScale::append(std::string& out, const Eigen::Vector2d& point) const {
    appendFixed(out, scale_ * point.x(), kDrawingDecimals);
    out += ',';
    appendFixed(out, scale_ * (height_ - point.y()), kDrawingDecimals);
}

std::string SvgScale::x(const Eigen::Vector2d& point) const {
    return length(point.x());
}

std::string SvgScale::y(const Eigen::Vector2d& point) const {
    return length(height_ - point.y());
}

std::string SvgScale::length(double millimetres) const {
    return fixed(scale_ * millimetres, kDrawingDecimals);
}

std::string SvgScale::size(double millimetres) const {
    return scale_ == 1 ? shortest(millimetres) : length(millimetres);
}

}  // namespace toile
