// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "core/formats/dxf/dxf_tags.h"
#include "core/formats/writers.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

/// Colours of the layers in AutoCAD's index, in the order of the kinds: red, grey, yellow, cyan,
/// green, magenta, black on white or white on black, blue.
constexpr std::array<int, kLayerKinds.size()> kDxfColours{1, 8, 2, 4, 3, 6, 7, 5};

/// The codes of $INSUNITS.
int unitCode(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Inch:
            return 1;
        case LengthUnit::Centimetre:
            return 5;
        case LengthUnit::Decimetre:
            return 14;
        case LengthUnit::Metre:
            return 6;
        case LengthUnit::Millimetre:
            break;
    }
    return 4;
}

void writeHeader(DxfTags& out, const Drawing& drawing, LengthUnit unit) {
    out.beginSection("HEADER");
    out.tag(9, "$ACADVER");
    out.tag(1, "AC1009");
    out.tag(9, "$MEASUREMENT");  // metric; newer than R12, but importers look for it
    out.tag(70, unit == LengthUnit::Inch ? 0 : 1);
    out.tag(9, "$INSUNITS");
    out.tag(70, unitCode(unit));
    out.tag(9, "$EXTMIN");
    out.point(10, {0, 0});
    out.tag(9, "$EXTMAX");
    out.point(10, {drawing.width, drawing.height});
    out.endSection();
}

void writeTables(DxfTags& out, const Drawing& drawing) {
    out.beginSection("TABLES");
    out.beginTable("LTYPE", 1);
    out.tag(0, "LTYPE");
    out.tag(2, "CONTINUOUS");
    out.tag(70, 0);
    out.tag(3, "Solid line");
    out.tag(72, 65);
    out.tag(73, 0);
    out.number(40, 0);
    out.endTable();
    const auto isThere = [&](LayerKind kind) -> bool { return hasLayer(drawing, kind); };
    out.beginTable("LAYER", static_cast<int>(std::ranges::count_if(kLayerKinds, isThere)));
    for (const LayerKind kind : kLayerKinds) {
        if (!isThere(kind)) {
            continue;
        }
        out.tag(0, "LAYER");
        out.tag(2, namesOf(kind).dxf);
        out.tag(70, 0);
        out.tag(62, kDxfColours[static_cast<std::size_t>(kind)]);
        out.tag(6, "CONTINUOUS");
    }
    out.endTable();
    out.beginTable("STYLE", 1);
    out.tag(0, "STYLE");
    out.tag(2, "STANDARD");
    out.tag(70, 0);
    out.number(40, 0);
    out.number(41, 1);
    out.number(50, 0);
    out.tag(71, 0);
    out.length(42, 2.5);
    out.tag(3, "txt");
    out.tag(4, "");
    out.endTable();
    out.endSection();
}

void writePath(DxfTags& out, const DrawnPath& path) {
    const char* layer = namesOf(path.layer).dxf;
    out.tag(0, "POLYLINE");
    out.tag(8, layer);
    out.tag(66, 1);  // vertices follow
    out.point(10, {0, 0});
    out.tag(70, path.closed ? 1 : 0);
    for (Eigen::Index i = 0; i < path.points.rows(); ++i) {
        out.tag(0, "VERTEX");
        out.tag(8, layer);
        out.point(10, path.points.row(i).transpose());
    }
    out.tag(0, "SEQEND");
    out.tag(8, layer);
}

/// One line of a text, `below` the first one.
void writeLine(DxfTags& out, const DrawnText& text, const std::string& line, double below) {
    const std::string ascii = dxfText(line);
    const double width = textExtent({ascii}, text.height).x();
    const Eigen::Rotation2Dd turn(text.angle);
    const Eigen::Vector2d middle =
        text.position + turn * Eigen::Vector2d(0, -below - 0.5 * text.height);
    const Eigen::Vector2d left = middle + turn * Eigen::Vector2d(-0.5 * width, 0);
    out.tag(0, "TEXT");
    out.tag(8, namesOf(text.layer).dxf);
    out.point(10, left);  // for readers that ignore centring
    out.length(40, text.height);
    out.tag(1, ascii);
    if (text.angle != 0) {
        out.number(50, text.angle * 180 / std::numbers::pi);
    }
    out.number(41, kCharacterWidth);  // CAD stroke fonts are as wide as high
    out.tag(7, "STANDARD");
    out.tag(72, 1);  // centred on the point that follows
    out.point(11, middle);
}

}  // namespace

std::string writePlainDxf(const Drawing& drawing, LengthUnit unit) {
    DxfTags out(unit);
    writeHeader(out, drawing, unit);
    writeTables(out, drawing);
    out.beginSection("ENTITIES");
    for (const DrawnPath& path : drawing.paths) {
        writePath(out, path);
    }
    for (const DrawnText& text : drawing.texts) {
        double below = 0;
        for (const std::string& line : text.lines) {
            writeLine(out, text, line, below);
            below += kLineSpacing * text.height;
        }
    }
    out.endSection();
    out.tag(0, "EOF");
    return out.take();
}

}  // namespace toile
