// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg/svg_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/formats/svg/svg_path.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

constexpr std::size_t kLongestColour = 100;  // limit, as a class copies it to many elements

/// Calls `take` for each part between marks, trimmed of blanks.
template <class Take>
void forEachPart(std::string_view text, char mark, Take take) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(mark), text.size());
        take(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string hexColour(const std::array<double, 3>& parts) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const double part : parts) {
        const auto value = static_cast<unsigned>(std::clamp(std::round(part), 0.0, 255.0));
        text += {kDigits[value / 16], kDigits[value % 16]};
    }
    return text;
}

Error decimalComma(std::string_view number) {
    return {ErrorCode::MalformedFile,
            {},
            worded("a number has a decimal comma, \"%1\"; numbers need decimal points",
                   {readableName(number)})};
}

/// Converts "#f00" and "rgb(255, 0, 0)" to "#ff0000"; other words to lower case.
std::string colourText(std::string_view value) {
    std::string text(trimmed(value).substr(0, kLongestColour));
    std::ranges::transform(text, text.begin(), lowered);
    if (text.size() == 4 && text.front() == '#') {
        return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
    }
    if (!text.starts_with("rgb(")) {
        return text;
    }
    SvgNumbers numbers(std::string_view(text).substr(4));
    std::array<double, 3> parts{};
    for (double& part : parts) {
        const auto number = numbers.number();
        if (!number) {
            return text;
        }
        part = *number;
    }
    return hexColour(parts);
}

}  // namespace

void setSvgProperty(SvgLook& look, std::string_view name, std::string_view value) {
    if (name == "stroke") {
        look.stroke = colourText(value);
    } else if (name == "fill") {
        look.fill = colourText(value);
    } else if (name == "display") {
        look.isShown = look.isShown && trimmed(value) != "none";
    }
}

void setSvgProperties(SvgLook& look, std::string_view declarations) {
    forEachPart(declarations, ';', [&look](std::string_view declaration) {
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos) {
            setSvgProperty(look, trimmed(declaration.substr(0, colon)),
                           declaration.substr(colon + 1));
        }
    });
}

void setSvgLook(SvgLook& look, const SvgLook& other) {
    look.stroke = other.stroke.empty() ? look.stroke : other.stroke;
    look.fill = other.fill.empty() ? look.fill : other.fill;
    look.isShown = look.isShown && other.isShown;
}

std::map<std::string, SvgLook, std::less<>> svgClasses(std::string_view css) {
    std::map<std::string, SvgLook, std::less<>> classes;
    forEachPart(css, '}', [&classes](std::string_view rule) {
        const std::size_t open = rule.find('{');
        if (open == std::string_view::npos) {
            return;
        }
        SvgLook declared;
        setSvgProperties(declared, rule.substr(open + 1));
        forEachPart(rule.substr(0, open), ',', [&](std::string_view selector) {
            if (selector.starts_with('.') &&
                selector.find_first_of(" .>:[#", 1) == std::string_view::npos) {
                setSvgLook(classes[std::string(selector.substr(1))], declared);
            }
        });
    });
    return classes;
}

namespace {

constexpr std::size_t kMaxSvgPoints = 20'000'000;
constexpr std::size_t kDeepestSvg = 256;      // nesting of groups
constexpr std::size_t kLongestSvgName = 500;  // of a group: each line in it has a copy

/// "path" of "svg:path".
std::string_view localName(pugi::xml_node node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view valueOf(pugi::xml_node node, const char* attribute) {
    return node.attribute(attribute).value();
}

double numberOf(pugi::xml_node node, const char* attribute) {
    return SvgNumbers(valueOf(node, attribute)).number().value_or(0);
}

/// The size of the page, and the map from the file's coordinates to it.
struct SvgPage {
    double width = 0, height = 0;  ///< mm
    Eigen::Affine2d place = Eigen::Affine2d::Identity();
};

/// x, y, width and height; none if the box has no size.
std::optional<std::array<double, 4>> viewBoxOf(pugi::xml_node svg) {
    SvgNumbers numbers(valueOf(svg, "viewBox"));
    const auto corner = numbers.pair();
    const auto size = corner ? numbers.pair() : std::nullopt;
    if (!size || !(size->minCoeff() > 0)) {
        return {};
    }
    return std::array{corner->x(), corner->y(), size->x(), size->y()};
}

/// Fits a viewBox into a page of another shape: as large as possible, centred or at a side.
Eigen::Affine2d fitted(const std::array<double, 4>& box, double width, double height,
                       std::string_view aspect) {
    const auto [x, y, boxWidth, boxHeight] = box;
    Eigen::Vector2d scale(width / boxWidth, height / boxHeight), offset(0, 0);
    if (aspect.find("none") == std::string_view::npos) {
        scale.setConstant(scale.minCoeff());
        const auto has = [aspect](const char* word) {
            return aspect.find(word) != std::string_view::npos;
        };
        const double across = has("xMin") ? 0 : has("xMax") ? 1 : 0.5;
        const double down = has("YMin") ? 0 : has("YMax") ? 1 : 0.5;
        offset = {across * (width - scale.x() * boxWidth), down * (height - scale.y() * boxHeight)};
    }
    Eigen::Affine2d place = Eigen::Affine2d::Identity();
    place.translate(offset).scale(scale).translate(Eigen::Vector2d(-x, -y));
    return place;
}

SvgPage pageOf(pugi::xml_node svg) {
    const double pixel = svgLength("1").value_or(1);
    SvgPage page;
    auto width = svgLength(valueOf(svg, "width")), height = svgLength(valueOf(svg, "height"));
    const auto box = viewBoxOf(svg);
    if (box && !width && !height) {
        width = (*box)[2] * pixel;
    }
    if (box && width.has_value() != height.has_value()) {
        const double aspect = (*box)[3] / (*box)[2];
        width = width ? width : *height / aspect;
        height = height ? height : *width * aspect;
    }
    const bool hasSize = width && height && *width > 0 && *height > 0 && std::isfinite(*width) &&
                         std::isfinite(*height);
    page.width = hasSize ? *width : 0;
    page.height = hasSize ? *height : 0;
    page.place.translate(Eigen::Vector2d(0, page.height)).scale(Eigen::Vector2d(1, -1));
    if (box && hasSize) {
        page.place =
            page.place * fitted(*box, *width, *height, valueOf(svg, "preserveAspectRatio"));
    } else {
        page.place.scale(pixel);
    }
    return page;
}

/// Appends an arc to path data: a corner of a rectangle or a part of an ellipse.
void appendArc(std::string& data, double rx, double ry, double x, double y) {
    data += "A";
    for (const double number : {rx, ry, 0.0}) {
        data += ' ' + shortest(number);
    }
    data += " 0 1 " + shortest(x) + ' ' + shortest(y) + ' ';
}

std::string ellipseData(double x, double y, double rx, double ry) {
    if (!(rx > 0) || !(ry > 0)) {
        return {};
    }
    std::string data = "M" + shortest(x + rx) + ' ' + shortest(y);
    appendArc(data, rx, ry, x - rx, y);
    appendArc(data, rx, ry, x + rx, y);
    return data + "Z";
}

std::string rectangleData(pugi::xml_node node) {
    const double x = numberOf(node, "x"), y = numberOf(node, "y");
    const double width = numberOf(node, "width"), height = numberOf(node, "height");
    if (!(width > 0) || !(height > 0)) {
        return {};
    }
    const bool hasX = node.attribute("rx"), hasY = node.attribute("ry");
    const double rx = std::clamp(numberOf(node, hasX ? "rx" : "ry"), 0.0, width / 2);
    const double ry = std::clamp(numberOf(node, hasY ? "ry" : "rx"), 0.0, height / 2);
    std::string data = "M" + shortest(x + rx) + ' ' + shortest(y);
    const auto side = [&data, rx, ry](double toX, double toY, double arcX, double arcY) {
        data += "L" + shortest(toX) + ' ' + shortest(toY) + ' ';
        if (rx > 0 && ry > 0) {
            appendArc(data, rx, ry, arcX, arcY);
        }
    };
    const double right = x + width, bottom = y + height;
    side(right - rx, y, right, y + ry);
    side(right, bottom - ry, right - rx, bottom);
    side(x + rx, bottom, x, bottom - ry);
    side(x, y + ry, x + rx, y);
    return data + "Z";
}

/// Converts a shape to path data; empty for other elements.
std::string shapeData(pugi::xml_node node) {
    const std::string_view kind = localName(node);
    if (kind == "path") {
        return std::string(valueOf(node, "d"));
    }
    if (kind == "polyline" || kind == "polygon") {
        return "M" + std::string(valueOf(node, "points")) + (kind == "polygon" ? "Z" : "");
    }
    if (kind == "line") {
        return "M" + shortest(numberOf(node, "x1")) + ' ' + shortest(numberOf(node, "y1")) + "L" +
               shortest(numberOf(node, "x2")) + ' ' + shortest(numberOf(node, "y2"));
    }
    if (kind == "circle") {
        const double radius = numberOf(node, "r");
        return ellipseData(numberOf(node, "cx"), numberOf(node, "cy"), radius, radius);
    }
    if (kind == "ellipse") {
        return ellipseData(numberOf(node, "cx"), numberOf(node, "cy"), numberOf(node, "rx"),
                           numberOf(node, "ry"));
    }
    return kind == "rect" ? rectangleData(node) : std::string();
}

/// Properties that elements inherit from their groups.
struct SvgContext {
    Eigen::Affine2d place;
    std::string layer{}, piece{}, label{};
    bool isLayer = false;  ///< `layer` is a layer; else it is the outermost group
    SvgLook look{};
};

class SvgReader {
public:
    Result<ReadSvg> read(pugi::xml_node svg) {
        const SvgPage page = pageOf(svg);
        found_.width = page.width;
        found_.height = page.height;
        readClasses(svg);
        SvgContext whole{page.place};
        setLook(whole.look, svg);
        noteComma(svg);
        walk(svg, std::move(whole));
        if (!comma_.empty()) {
            return decimalComma(comma_);
        }
        if (most_ == 0) {
            return Error{ErrorCode::MalformedFile, {}, "it has too many points"};
        }
        return std::move(found_);
    }

private:
    /// Reads the classes of style elements at the places where programs put them.
    void readClasses(pugi::xml_node svg) {
        std::string css;
        for (const pugi::xml_node child : svg.children()) {
            if (localName(child) == "style") {
                css += child.text().get();
            }
            for (const pugi::xml_node inner : child.children()) {
                if (localName(child) == "defs" && localName(inner) == "style") {
                    css += inner.text().get();
                }
            }
        }
        classes_ = svgClasses(css);
    }

    /// Notes a number with a decimal comma, which no list of coordinates shows.
    void noteComma(pugi::xml_node node) {
        for (const char* name : {"version", "width", "height", "x", "y", "x1", "y1", "x2", "y2",
                                 "cx", "cy", "r", "rx", "ry", "stroke-width", "data-length-3d"}) {
            const std::string_view value = valueOf(node, name);
            comma_ = comma_.empty() && io::hasDecimalComma(value) ? value : comma_;
        }
    }

    void setLook(SvgLook& look, pugi::xml_node node) const {
        for (const char* name : {"stroke", "fill", "display"}) {
            if (const pugi::xml_attribute attribute = node.attribute(name)) {
                setSvgProperty(look, name, attribute.value());
            }
        }
        std::string_view names = valueOf(node, "class");
        while (!names.empty()) {
            const std::size_t end = std::min(names.find(' '), names.size());
            if (const auto found = classes_.find(names.substr(0, end)); found != classes_.end()) {
                setSvgLook(look, found->second);
            }
            names.remove_prefix(std::min(end + 1, names.size()));
        }
        setSvgProperties(look, valueOf(node, "style"));
    }

    SvgContext contextOf(pugi::xml_node node, const SvgContext& above) {
        noteComma(node);
        SvgContext context = above;
        context.place = above.place * svgTransform(valueOf(node, "transform"));
        setLook(context.look, node);
        std::string_view label = valueOf(node, "inkscape:label");
        label = label.empty() ? trimmed(node.child("title").text().get()) : label;
        const bool isLayer = valueOf(node, "inkscape:groupmode") == "layer";
        if (!label.empty() || isLayer) {
            context.label = isLayer ? "" : label.substr(0, kLongestSvgName);
        }
        if (const pugi::xml_attribute piece = node.attribute("data-piece")) {
            context.piece = std::string_view(piece.value()).substr(0, kLongestSvgName);
        }
        return context;
    }

    void enterGroup(pugi::xml_node group, SvgContext& context) const {
        std::string_view name = valueOf(group, "inkscape:label");
        for (const char* other : {"data-name", "id"}) {
            name = name.empty() ? valueOf(group, other) : name;
        }
        const bool isLayer = valueOf(group, "inkscape:groupmode") == "layer";
        if (isLayer || (!context.isLayer && context.layer.empty())) {
            context.layer = name.substr(0, kLongestSvgName);
            context.isLayer = isLayer;
        }
    }

    /// Not recursive, because groups may be nested deeper than the stack allows.
    void walk(pugi::xml_node root, SvgContext whole) {
        std::vector<SvgContext> contexts{std::move(whole)};
        pugi::xml_node node = root.first_child();
        while (node && most_ > 0) {
            const std::string_view kind = localName(node);
            const bool isGroup = kind == "g" || kind == "a" || kind == "svg" || kind == "switch";
            if (isGroup && node.first_child() && contexts.size() < kDeepestSvg) {
                SvgContext context = contextOf(node, contexts.back());
                enterGroup(node, context);
                contexts.push_back(std::move(context));
                node = node.first_child();
                continue;
            }
            addShape(node, contexts.back());
            while (!node.next_sibling() && node.parent() != root) {
                node = node.parent();
                contexts.pop_back();
            }
            node = node.next_sibling();
        }
    }

    void addShape(pugi::xml_node node, const SvgContext& above) {
        const std::string data = shapeData(node);
        if (data.empty()) {
            return;
        }
        const SvgContext context = contextOf(node, above);
        if (!context.look.isShown) {
            return;
        }
        for (SvgContour& contour : svgContours(data, context.place, most_)) {
            SvgLine& line = found_.lines.emplace_back();
            line.layer = context.layer;
            line.id = valueOf(node, "id");
            line.piece = context.piece;
            line.label = context.label;
            line.stroke = context.look.stroke;
            line.fill = context.look.fill;
            line.text = valueOf(node, "data-text");
            line.seam = seamOf(node);
            line.points = std::move(contour.points);
            line.closed = contour.closed;
        }
    }

    static std::optional<SvgSeam> seamOf(pugi::xml_node node) {
        const auto length = SvgNumbers(valueOf(node, "data-length-3d")).number();
        if (!length) {
            return {};
        }
        return SvgSeam{std::string(valueOf(node, "data-seam")),
                       std::string(valueOf(node, "data-pair")), *length};
    }

    ReadSvg found_;
    std::size_t most_ = kMaxSvgPoints;
    std::string_view comma_;  ///< a number of the file with a decimal comma; empty: none
    std::map<std::string, SvgLook, std::less<>> classes_;
};

}  // namespace

Result<ReadSvg> readSvg(std::string_view bytes) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed) {
        return Error{ErrorCode::MalformedFile,
                     {},
                     "byte " + std::to_string(parsed.offset) + ": it is not XML (" +
                         parsed.description() + ")"};
    }
    const pugi::xml_node svg = document.document_element();
    if (localName(svg) != "svg") {
        return Error{ErrorCode::MalformedFile, {}, "it is XML, but not SVG"};
    }
    return SvgReader().read(svg);
}

}  // namespace toile
