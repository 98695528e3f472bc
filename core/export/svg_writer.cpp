// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include <pugixml.hpp>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/export/writers.h"

namespace toile {
namespace {

constexpr double kStroke = 0.3;           // mm
constexpr double kFontPerCapital = 1.39;  // font size per height of a capital, usual sans-serif

struct SvgLayer {
    const char* name;
    const char* colour;  ///< cutters choose the operation by it
};

/// In the order of the kinds.
constexpr SvgLayer kSvgLayers[] = {
    {"cut", "#ff0000"},   {"sew", "#606060"},   {"notches", "#c06000"}, {"internal", "#0070c0"},
    {"marks", "#008000"}, {"grain", "#800080"}, {"text", "#000000"},    {"check", "#0000ff"}};
static_assert(std::size(kSvgLayers) == kLayerKinds.size());

/// Collects what pugixml writes.
struct StringWriter : pugi::xml_writer {
    std::string bytes;

    void write(const void* data, std::size_t size) override {
        bytes.append(static_cast<const char*>(data), size);
    }
};

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

std::string number(double value) {
    return fixed(value, kDrawingDecimals);
}

std::string plain(double value) {
    return shortest(value);  // sizes that are whole numbers read better without decimals
}

/// "M x,y L x,y ... Z" with y counted downwards from the page's top; no Z where it is open.
std::string pathData(const Points2& points, bool closed, double pageHeight) {
    std::string data;
    data.reserve(static_cast<std::size_t>(points.rows()) * 22);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        data += i == 0 ? "M " : i == 1 ? " L " : " ";
        appendFixed(data, points(i, 0), kDrawingDecimals);
        data += ',';
        appendFixed(data, pageHeight - points(i, 1), kDrawingDecimals);
    }
    return closed ? data + " Z" : data;
}

void addPath(pugi::xml_node layer, const DrawnPath& path, double pageHeight) {
    pugi::xml_node node = layer.append_child("path");
    set(node, "id", path.id);
    set(node, "d", pathData(path.points, path.closed, pageHeight));
}

void addText(pugi::xml_node layer, const DrawnText& text, const char* colour, double pageHeight) {
    pugi::xml_node node = layer.append_child("text");
    set(node, "id", text.id);
    set(node, "font-family", "sans-serif");
    set(node, "font-size", number(text.height * kFontPerCapital));
    set(node, "text-anchor", "middle");
    set(node, "fill", colour);
    set(node, "stroke", "none");
    if (text.angle != 0) {
        const double degrees = -text.angle * 180 / std::numbers::pi;  // y points down here
        set(node, "transform",
            "rotate(" + number(degrees) + " " + number(text.position.x()) + " " +
                number(pageHeight - text.position.y()) + ")");
    }
    // Capitals are centred on the line's middle; no reader agrees on dominant-baseline.
    double baseline = pageHeight - text.position.y() + 0.5 * text.height;
    for (const std::string& line : text.lines) {
        // Blanks between the lines would be part of the text and push it off its middle: an empty
        // text node keeps the printer from indenting the next element.
        node.append_child(pugi::node_pcdata);
        pugi::xml_node span = node.append_child("tspan");
        set(span, "x", number(text.position.x()));
        set(span, "y", number(baseline));
        span.text().set(cleanText(line).c_str());
        baseline += kLineSpacing * text.height;
    }
    node.append_child(pugi::node_pcdata);
}

void addLayer(pugi::xml_node svg, const Drawing& drawing, LayerKind kind) {
    const SvgLayer& style = kSvgLayers[static_cast<std::size_t>(kind)];
    pugi::xml_node layer = svg.append_child("g");
    set(layer, "id", std::string("layer-") + style.name);
    set(layer, "inkscape:groupmode", "layer");
    set(layer, "inkscape:label", style.name);
    set(layer, "fill", "none");
    set(layer, "stroke", style.colour);
    set(layer, "stroke-width", plain(kStroke));
    set(layer, "stroke-linejoin", "round");
    for (const DrawnPath& path : drawing.paths) {
        if (path.layer == kind) {
            addPath(layer, path, drawing.height);
        }
    }
    for (const DrawnText& text : drawing.texts) {
        if (text.layer == kind) {
            addText(layer, text, style.colour, drawing.height);
        }
    }
}

/// Width, height and viewBox say the same: one user unit is one millimetre.
pugi::xml_node addPage(pugi::xml_document& document, const Drawing& drawing) {
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node svg = document.append_child("svg");
    set(svg, "xmlns", "http://www.w3.org/2000/svg");
    set(svg, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    set(svg, "xmlns:sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd");
    set(svg, "version", "1.1");
    set(svg, "width", plain(drawing.width) + "mm");
    set(svg, "height", plain(drawing.height) + "mm");
    set(svg, "viewBox", "0 0 " + plain(drawing.width) + " " + plain(drawing.height));
    svg.append_child("title").text().set(cleanText(drawing.title).c_str());
    svg.append_child("desc").text().set(
        ("Sewing pattern at true scale, one user unit is one millimetre. Made by Toile " +
         std::string(version()) + ".")
            .c_str());
    pugi::xml_node view = svg.append_child("sodipodi:namedview");
    set(view, "id", "view");
    set(view, "inkscape:document-units", "mm");
    return svg;
}

}  // namespace

std::string writeSvg(const Drawing& drawing) {
    pugi::xml_document document;
    const pugi::xml_node svg = addPage(document, drawing);
    for (const LayerKind kind : kLayerKinds) {
        if (hasLayer(drawing, kind)) {
            addLayer(svg, drawing, kind);
        }
    }
    StringWriter out;
    document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
    return std::move(out.bytes);
}

}  // namespace toile
