// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/drawing/text_outlines.h"
#include "core/formats/svg/svg_style.h"
#include "core/formats/writers.h"

namespace toile {
namespace {

constexpr double kFontPerCapital = 1.39;  // font size per height of a capital, typical sans-serif
constexpr const char* kSeamsLayer = "seams";

/// Collects the output of pugixml.
struct StringWriter : pugi::xml_writer {
    std::string bytes;

    void write(const void* data, std::size_t size) override {
        bytes.append(static_cast<const char*>(data), size);
    }
};

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

/// "M x,y L x,y ... Z"; no Z if it is open.
std::string pathData(const Points2& points, bool closed, const SvgScale& scale) {
    std::string data;
    data.reserve(static_cast<std::size_t>(points.rows()) * 22);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        data += i == 0 ? "M " : i == 1 ? " L " : " ";
        scale.append(data, points.row(i).transpose());
    }
    return closed ? data + " Z" : data;
}

/// "M x,y C x,y x,y x,y L x,y ... Z M ...".
std::string outlineData(const std::vector<std::vector<CubicCurve>>& contours,
                        const SvgScale& scale) {
    std::string data;
    for (const std::vector<CubicCurve>& contour : contours) {
        data += data.empty() ? "M " : " M ";
        scale.append(data, contour.front().start);
        for (const CubicCurve& curve : contour) {
            data += curve.isLine ? " L " : " C ";
            if (!curve.isLine) {
                scale.append(data, curve.startHandle);
                data += ' ';
                scale.append(data, curve.endHandle);
                data += ' ';
            }
            scale.append(data, curve.end);
        }
        data += " Z";
    }
    return data;
}

/// A part of a drawing: a block, the whole drawing, or everything outside of blocks.
struct SvgPart {
    std::string id, name;  ///< of the piece; empty for the page
    std::vector<const DrawnPath*> paths{};
    std::vector<const DrawnText*> texts{};
    std::vector<const DrawnEdge*> edges{};
};

class SvgWriter {
public:
    SvgWriter(const Drawing& drawing, const SvgOptions& options)
        : drawing_(drawing),
          groups_(options.groups),
          style_(svgStyle(options)),
          scale_(style_, drawing.height) {}

    std::string write() {
        pugi::xml_document document;
        const pugi::xml_node svg = addPage(document);
        if (groups_ == SvgGroups::Piece) {
            for (const DrawnBlock& block : drawing_.blocks) {
                addPiece(svg, block);
            }
        }
        addLayers(svg, groups_ == SvgGroups::Piece ? rest() : whole(), "layer-");
        StringWriter out;
        document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
        return std::move(out.bytes);
    }

private:
    /// Width, height and viewBox agree.
    pugi::xml_node addPage(pugi::xml_document& document) const {
        const std::string width = scale_.size(drawing_.width);
        const std::string height = scale_.size(drawing_.height);
        pugi::xml_node declaration = document.append_child(pugi::node_declaration);
        set(declaration, "version", "1.0");
        set(declaration, "encoding", "UTF-8");
        pugi::xml_node svg = document.append_child("svg");
        set(svg, "xmlns", "http://www.w3.org/2000/svg");
        set(svg, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
        set(svg, "xmlns:sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd");
        set(svg, "version", "1.1");
        set(svg, "width", width + style_.unit);
        set(svg, "height", height + style_.unit);
        set(svg, "viewBox", "0 0 " + width + " " + height);
        svg.append_child("title").text().set(cleanText(drawing_.title).c_str());
        const std::string unit = style_.perMillimetre == 1 ? "millimetre" : "point (1/72 inch)";
        svg.append_child("desc").text().set(("Sewing pattern at true scale, one user unit is one " +
                                             unit + ". Made by Toile " + std::string(version()) +
                                             ".")
                                                .c_str());
        pugi::xml_node view = svg.append_child("sodipodi:namedview");
        set(view, "id", "view");
        set(view, "inkscape:document-units", style_.unit);
        return svg;
    }

    static pugi::xml_node addGroup(pugi::xml_node parent, const std::string& id,
                                   const std::string& label) {
        pugi::xml_node group = parent.append_child("g");
        set(group, "id", id);
        set(group, "inkscape:groupmode", "layer");
        set(group, "inkscape:label", label);
        return group;
    }

    /// The name at the start of its label; else its id.
    std::string nameOf(const DrawnBlock& block) const {
        for (std::size_t k = block.text; k < block.text + block.textCount; ++k) {
            if (drawing_.texts[k].layer == LayerKind::Text && !drawing_.texts[k].lines.empty()) {
                return cleanText(drawing_.texts[k].lines.front());
            }
        }
        return block.id;
    }

    void addPiece(pugi::xml_node svg, const DrawnBlock& block) const {
        pugi::xml_node group = addGroup(svg, block.id, nameOf(block));
        set(group, "data-piece", block.id);
        SvgPart part;
        add(part.paths, drawing_.paths, block.path, block.path + block.pathCount);
        add(part.texts, drawing_.texts, block.text, block.text + block.textCount);
        add(part.edges, drawing_.edges, block.edge, block.edge + block.edgeCount);
        addLayers(group, part, block.id + "--layer-");
    }

    template <class Item>
    static void add(std::vector<const Item*>& to, const std::vector<Item>& from, std::size_t first,
                    std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            to.push_back(&from[k]);
        }
    }

    SvgPart whole() const {
        SvgPart part;
        add(part.paths, drawing_.paths, 0, drawing_.paths.size());
        add(part.texts, drawing_.texts, 0, drawing_.texts.size());
        add(part.edges, drawing_.edges, 0, drawing_.edges.size());
        return part;
    }

    /// Everything outside of blocks; the contents of each block are contiguous.
    SvgPart rest() const {
        SvgPart part;
        std::size_t path = 0, text = 0;
        for (const DrawnBlock& block : drawing_.blocks) {
            add(part.paths, drawing_.paths, path, block.path);
            add(part.texts, drawing_.texts, text, block.text);
            path = block.path + block.pathCount;
            text = block.text + block.textCount;
        }
        add(part.paths, drawing_.paths, path, drawing_.paths.size());
        add(part.texts, drawing_.texts, text, drawing_.texts.size());
        return part;
    }

    void addLayers(pugi::xml_node parent, const SvgPart& part, const std::string& ids) const {
        for (const LayerKind kind : style_.order) {
            const auto isOn = [kind](const auto* item) { return item->layer == kind; };
            const bool isEmpty =
                std::ranges::none_of(part.paths, isOn) && std::ranges::none_of(part.texts, isOn);
            if (groups_ == SvgGroups::Kind ? hasLayer(drawing_, kind) : !isEmpty) {
                addLayer(parent, part, kind, ids + namesOf(kind).svg);
            }
        }
        if (style_.hasSeams && !part.edges.empty()) {
            addSeams(parent, part, ids + kSeamsLayer);
        }
    }

    void addLayer(pugi::xml_node parent, const SvgPart& part, LayerKind kind,
                  const std::string& id) const {
        pugi::xml_node layer = addGroup(parent, id, namesOf(kind).svg);
        set(layer, "fill", "none");
        set(layer, "stroke", style_.colourOf(kind));
        set(layer, "stroke-width", scale_.size(style_.stroke));
        set(layer, "stroke-linejoin", "round");
        for (const DrawnPath* path : part.paths) {
            if (path->layer == kind) {
                pugi::xml_node node = layer.append_child("path");
                set(node, "id", path->id);
                setPiece(node, *path);
                set(node, "d", pathData(path->points, path->closed, scale_));
            }
        }
        for (const DrawnText* text : part.texts) {
            if (text->layer == kind && !(style_.textAsPaths && addOutlines(layer, *text))) {
                addText(layer, *text);
            }
        }
    }

    /// Invisible lines for programs that sew.
    void addSeams(pugi::xml_node parent, const SvgPart& part, const std::string& id) const {
        pugi::xml_node layer = addGroup(parent, id, kSeamsLayer);
        set(layer, "fill", "none");
        set(layer, "stroke", "none");
        for (const DrawnEdge* edge : part.edges) {
            pugi::xml_node node = layer.append_child("path");
            set(node, "id", edge->id);
            set(node, "data-seam", cleanText(edge->seam));
            if (!edge->pair.empty()) {
                set(node, "data-pair", edge->pair);
            }
            set(node, "data-length-3d", fixed(edge->length3d, kDrawingDecimals));
            set(node, "d", pathData(edge->points, false, scale_));
        }
    }

    /// Names the piece; unnecessary inside a group of the piece.
    void setPiece(pugi::xml_node node, const DrawnPath& path) const {
        const auto index = static_cast<std::size_t>(&path - drawing_.paths.data());
        for (const DrawnBlock& block : drawing_.blocks) {
            if (groups_ == SvgGroups::Kind && index >= block.path &&
                index < block.path + block.pathCount) {
                set(node, "data-piece", block.id);
            }
        }
    }

    /// False without a font.
    bool addOutlines(pugi::xml_node layer, const DrawnText& text) const {
        const auto contours = placedOutlines(text);
        if (contours.empty()) {
            return false;
        }
        std::string lines;
        for (const std::string& line : text.lines) {
            lines += (lines.empty() ? "" : "\n") + cleanText(line);
        }
        pugi::xml_node node = layer.append_child("path");
        set(node, "id", text.id);
        set(node, "data-text", lines);
        set(node, "fill", style_.colourOf(text.layer));
        set(node, "stroke", "none");
        set(node, "d", outlineData(contours, scale_));
        return true;
    }

    void addText(pugi::xml_node layer, const DrawnText& text) const {
        pugi::xml_node node = layer.append_child("text");
        set(node, "id", text.id);
        set(node, "font-family", "sans-serif");
        set(node, "font-size", scale_.length(text.height * kFontPerCapital));
        set(node, "text-anchor", "middle");
        set(node, "fill", style_.colourOf(text.layer));
        set(node, "stroke", "none");
        if (text.angle != 0) {
            const double degrees = -text.angle * 180 / std::numbers::pi;  // y points down here
            set(node, "transform",
                "rotate(" + fixed(degrees, kDrawingDecimals) + " " + scale_.x(text.position) + " " +
                    scale_.y(text.position) + ")");
        }
        // Capitals are centred on the line's middle; readers differ on dominant-baseline.
        Eigen::Vector2d start = text.position - Eigen::Vector2d(0, 0.5 * text.height);
        for (const std::string& line : text.lines) {
            // Blanks between the lines would become part of the text and shift its middle. An empty
            // text node keeps the printer from indenting the next element.
            node.append_child(pugi::node_pcdata);
            pugi::xml_node span = node.append_child("tspan");
            set(span, "x", scale_.x(start));
            set(span, "y", scale_.y(start));
            span.text().set(cleanText(line).c_str());
            start.y() -= kLineSpacing * text.height;
        }
        node.append_child(pugi::node_pcdata);
    }

    const Drawing& drawing_;
    SvgGroups groups_;
    SvgStyle style_;
    SvgScale scale_;
};

}  // namespace

std::string writeSvg(const Drawing& drawing, const SvgOptions& options) {
    return SvgWriter(drawing, options).write();
}

}  // namespace toile
