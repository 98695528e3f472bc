// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/writers.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

constexpr std::size_t kLongestText = 250;  // R12 holds no longer string

struct DxfLayer {
    const char* name;
    int colour;  ///< AutoCAD colour index
};

/// In the order of the kinds.
constexpr DxfLayer kDxfLayers[] = {{"CUT", 1},       // red
                                   {"SEW", 8},       // grey
                                   {"NOTCHES", 2},   // yellow
                                   {"INTERNAL", 4},  // cyan
                                   {"MARKS", 3},     // green
                                   {"GRAIN", 6},     // magenta
                                   {"TEXT", 7},      // black on white, white on black
                                   {"CHECK", 5}};    // blue
static_assert(std::size(kDxfLayers) == kLayerKinds.size());

const DxfLayer& styleOf(LayerKind kind) {
    return kDxfLayers[static_cast<std::size_t>(kind)];
}

/// Text that stays text: "%%" starts a control code in a DXF string, as '^' does.
std::string dxfText(std::string_view line) {
    std::string text = asciiText(line).substr(0, kLongestText);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool doubled = text[i] == '%' && i + 1 < text.size() && text[i + 1] == '%';
        if (doubled || text[i] == '^') {
            text[i] = '_';
        }
    }
    return text;
}

/// Group codes and values, one per line, codes three wide as AutoCAD writes them.
class TagWriter {
public:
    void tag(int code, std::string_view value) {
        const std::string digits = std::to_string(code);
        out_.append(digits.size() < 3 ? 3 - digits.size() : 0, ' ').append(digits);
        out_.append("\r\n").append(value).append("\r\n");
    }

    void tag(int code, int value) { tag(code, std::string_view(std::to_string(value))); }

    void tag(int code, double value) {
        tag(code, std::string_view(fixed(value, kDrawingDecimals)));
    }

    /// A point as codes first, first + 10 and first + 20.
    void point(int first, double x, double y) {
        tag(first, x);
        tag(first + 10, y);
        tag(first + 20, 0.0);
    }

    void beginSection(const char* name) {
        tag(0, "SECTION");
        tag(2, name);
    }

    void endSection() { tag(0, "ENDSEC"); }

    void beginTable(const char* name, int entries) {
        tag(0, "TABLE");
        tag(2, name);
        tag(70, entries);
    }

    void endTable() { tag(0, "ENDTAB"); }

    std::string take() { return std::move(out_); }

private:
    std::string out_;
};

void writeHeader(TagWriter& out, const Drawing& drawing) {
    out.beginSection("HEADER");
    out.tag(9, "$ACADVER");
    out.tag(1, "AC1009");
    out.tag(9, "$MEASUREMENT");  // metric; younger than R12, but what importers look for
    out.tag(70, 1);
    out.tag(9, "$INSUNITS");  // millimetres
    out.tag(70, 4);
    out.tag(9, "$EXTMIN");
    out.point(10, 0, 0);
    out.tag(9, "$EXTMAX");
    out.point(10, drawing.width, drawing.height);
    out.endSection();
}

void writeTables(TagWriter& out, const Drawing& drawing) {
    out.beginSection("TABLES");
    out.beginTable("LTYPE", 1);
    out.tag(0, "LTYPE");
    out.tag(2, "CONTINUOUS");
    out.tag(70, 0);
    out.tag(3, "Solid line");
    out.tag(72, 65);
    out.tag(73, 0);
    out.tag(40, 0.0);
    out.endTable();
    const auto isThere = [&](LayerKind kind) -> bool { return hasLayer(drawing, kind); };
    out.beginTable("LAYER", static_cast<int>(std::ranges::count_if(kLayerKinds, isThere)));
    for (const LayerKind kind : kLayerKinds) {
        if (!isThere(kind)) {
            continue;
        }
        out.tag(0, "LAYER");
        out.tag(2, styleOf(kind).name);
        out.tag(70, 0);
        out.tag(62, styleOf(kind).colour);
        out.tag(6, "CONTINUOUS");
    }
    out.endTable();
    out.beginTable("STYLE", 1);
    out.tag(0, "STYLE");
    out.tag(2, "STANDARD");
    out.tag(70, 0);
    out.tag(40, 0.0);
    out.tag(41, 1.0);
    out.tag(50, 0.0);
    out.tag(71, 0);
    out.tag(42, 2.5);
    out.tag(3, "txt");
    out.tag(4, "");
    out.endTable();
    out.endSection();
}

void writePath(TagWriter& out, const DrawnPath& path) {
    const char* layer = styleOf(path.layer).name;
    out.tag(0, "POLYLINE");
    out.tag(8, layer);
    out.tag(66, 1);  // vertices follow
    out.point(10, 0, 0);
    out.tag(70, path.closed ? 1 : 0);
    for (Eigen::Index i = 0; i < path.points.rows(); ++i) {
        out.tag(0, "VERTEX");
        out.tag(8, layer);
        out.point(10, path.points(i, 0), path.points(i, 1));
    }
    out.tag(0, "SEQEND");
    out.tag(8, layer);
}

/// One line of a text, `below` the first one.
void writeLine(TagWriter& out, const DrawnText& text, const std::string& line, double below) {
    const std::string ascii = dxfText(line);
    const double width = textExtent({ascii}, text.height).x();
    const Eigen::Rotation2Dd turn(text.angle);
    const Eigen::Vector2d middle =
        text.position + turn * Eigen::Vector2d(0, -below - 0.5 * text.height);
    const Eigen::Vector2d left = middle + turn * Eigen::Vector2d(-0.5 * width, 0);
    out.tag(0, "TEXT");
    out.tag(8, styleOf(text.layer).name);
    out.point(10, left.x(), left.y());  // for readers that do not centre
    out.tag(40, text.height);
    out.tag(1, ascii);
    if (text.angle != 0) {
        out.tag(50, text.angle * 180 / std::numbers::pi);
    }
    out.tag(41, kCharacterWidth);  // the stroke fonts of CAD are as wide as high
    out.tag(7, "STANDARD");
    out.tag(72, 1);  // centred on the point that follows
    out.point(11, middle.x(), middle.y());
}

}  // namespace

std::string writeDxf(const Drawing& drawing) {
    TagWriter out;
    writeHeader(out, drawing);
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
