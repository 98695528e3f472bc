// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/growth_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/text.h"
#include "tests/bench/report/bars.h"
#include "tests/bench/report/svg_picture.h"

namespace toile::bench {
namespace {

struct Style {
    const char* what;   ///< of the benchmark's name
    const char* label;  ///< at the end of its line
    const char* colour;
    Marker marker;
};

// Okabe and Ito's colours, which keep apart under every common kind of colour blindness.
constexpr std::array<Style, 6> kStyles{{
    {"floor", "floor", "#8c8c8c", Marker::Ring},
    {"curvature", "curvature", "#0072b2", Marker::Disk},
    {"wang2005", "wang2005", "#009e73", Marker::Square},
    {"isometric", "isometric", "#d55e00", Marker::Diamond},
    {"cgalLscm", "CGAL LSCM", "#cc79a7", Marker::Triangle},
    {"cgalArap", "CGAL ARAP", "#b8860b", Marker::Cross},
}};

struct Series {
    const Style* style;
    std::vector<PlanePoint> points;  ///< triangles, seconds
};

/// Triangles and seconds to the place in the picture.
struct Field {
    double left, top, width, height;
    double lowX, highX, lowY, highY;  ///< decimal logarithms

    double x(double triangles) const {
        return left + width * (std::log10(triangles) - lowX) / (highX - lowX);
    }
    double y(double seconds) const {
        return top + height * (highY - std::log10(seconds)) / (highY - lowY);
    }
};

constexpr double kFieldWidth = 300, kFieldHeight = 340, kLabelWidth = 92;
constexpr double kLeft = 62, kTop = 44, kGap = 34, kBottom = 54;
constexpr double kLabelSpacing = 14;

std::vector<Series> seriesOf(const Measurements& run, const std::string& surface) {
    std::vector<Series> all;
    for (const Style& style : kStyles) {
        Series series{&style, {}};
        for (const std::string size : kSizes) {
            const std::string piece = surface + "/" + size;
            const Measurement* found = run.find(std::string(style.what) + "/" + piece);
            if (style.what == kStyles[0].what) {
                const auto floor = run.floorOf(piece);
                found = floor ? floor->measurement : nullptr;
            }
            if (found != nullptr) {
                const auto triangles = found->counters.find("triangles");
                series.points.push_back(
                    {triangles == found->counters.end() ? std::stod(size) : triangles->second,
                     found->lowest()});
            }
        }
        if (!series.points.empty()) {
            all.push_back(std::move(series));
        }
    }
    return all;
}

std::string powerOfTen(int exponent, bool seconds) {
    if (seconds) {
        return exponent < 0 ? fixed(std::pow(10.0, exponent), -exponent)
                            : shortest(std::pow(10.0, exponent));
    }
    return exponent >= 6   ? shortest(std::pow(10.0, exponent - 6)) + " M"
           : exponent >= 3 ? shortest(std::pow(10.0, exponent - 3)) + " k"
                           : shortest(std::pow(10.0, exponent));
}

void drawAxes(SvgPicture& picture, const Field& field, const std::string& title, bool withSeconds) {
    const double right = field.left + field.width, bottom = field.top + field.height;
    for (int k = static_cast<int>(std::ceil(field.lowY)); k <= field.highY; ++k) {
        const double y = field.y(std::pow(10.0, k));
        picture.line("grid", {field.left, y}, {right, y});
        if (withSeconds) {
            picture.text("tick", {field.left - 8, y + 4}, powerOfTen(k, true),
                         " text-anchor=\"end\"");
        }
    }
    for (int k = static_cast<int>(std::ceil(field.lowX)); k <= field.highX; ++k) {
        const double x = field.x(std::pow(10.0, k));
        picture.line("grid", {x, field.top}, {x, bottom});
        picture.text("tick", {x, bottom + 18}, powerOfTen(k, false), " text-anchor=\"middle\"");
    }
    picture.line("axis", {field.left, bottom}, {right, bottom});
    picture.line("axis", {field.left, field.top}, {field.left, bottom});
    picture.text("title", {field.left, field.top - 14}, title);
    picture.text("tick", {field.left + 0.5 * field.width, bottom + 40}, "triangles",
                 " text-anchor=\"middle\"");
    if (withSeconds) {
        picture.text("tick", {field.left - 8, field.top - 14}, "seconds", " text-anchor=\"end\"");
    }
}

void drawName(SvgPicture& picture, PlanePoint at, const Style& style, const char* anchor) {
    picture.text("name", at, style.label,
                 std::string(" text-anchor=\"") + anchor + "\" fill=\"" + style.colour + "\"");
}

/// Names beside the ends of the lines: of those that end early to the left, of the others in a
/// column on the right, moved apart where lines end close together.
void drawNames(SvgPicture& picture, const Field& field, const std::vector<Series>& all) {
    struct Name {
        const Series* series;
        PlanePoint end;
        double y;
    };
    double last = 0;
    for (const Series& series : all) {
        last = std::max(last, field.x(series.points.back().x));
    }
    std::vector<Name> names;
    for (const Series& series : all) {
        const PlanePoint end{field.x(series.points.back().x), field.y(series.points.back().y)};
        if (end.x < last - 20) {
            drawName(picture, {end.x - 9, end.y + 1}, *series.style, "end");
        } else {
            names.push_back({&series, end, end.y});
        }
    }
    std::stable_sort(names.begin(), names.end(),
                     [](const Name& a, const Name& b) { return a.y < b.y; });
    for (int round = 0; round < 100; ++round) {  // push each pair apart until all have room
        for (std::size_t k = 1; k < names.size(); ++k) {
            const double missing = kLabelSpacing - (names[k].y - names[k - 1].y);
            if (missing > 0) {
                names[k - 1].y -= 0.5 * missing;
                names[k].y += 0.5 * missing;
            }
        }
    }
    const double right = field.left + field.width;
    for (const Name& name : names) {
        picture.line("leader", {name.end.x + 6, name.end.y}, {right + 9, name.y});
        drawName(picture, {right + 12, name.y + 4}, *name.series->style, "start");
    }
}

}  // namespace

std::string growthPlot(const Measurements& run) {
    std::vector<std::pair<std::string, std::vector<Series>>> surfaces;
    double lowest = 1e-2, highest = 1;
    for (const std::string surface : kSurfaces) {
        surfaces.emplace_back(surface, seriesOf(run, surface));
        for (const Series& series : surfaces.back().second) {
            for (const PlanePoint& p : series.points) {
                lowest = std::min(lowest, p.y);
                highest = std::max(highest, p.y);
            }
        }
    }
    const double lowY = std::log10(lowest) - 0.15, highY = std::log10(highest) + 0.15;
    SvgPicture picture;
    double left = kLeft;
    for (const auto& [surface, all] : surfaces) {
        const Field field{
            left, kTop, kFieldWidth, kFieldHeight, std::log10(2000.0), std::log10(1.4e6),
            lowY, highY};
        drawAxes(picture, field, "the " + surface, left == kLeft);
        for (const Series& series : all) {
            std::vector<PlanePoint> places;
            for (const PlanePoint& p : series.points) {
                places.push_back({field.x(p.x), field.y(p.y)});
            }
            picture.curve(places, series.style->colour);
            for (const PlanePoint& p : places) {
                picture.marker(series.style->marker, p, series.style->colour);
            }
        }
        drawNames(picture, field, all);
        left += kFieldWidth + kLabelWidth + kGap;
    }
    const std::string width = fixed(left - kGap + 8, 0),
                      height = fixed(kTop + kFieldHeight + kBottom, 0);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" role=\"img\">\n<title>Seconds over triangles</title>\n<style>\n"
           ".paper { fill: #ffffff }\n"
           "text { font: 12px sans-serif }\n"
           ".tick, .title { fill: #444444 }\n"
           ".title { font-weight: bold }\n"
           ".axis { stroke: #777777 }\n"
           ".grid { stroke: #e4e4e4 }\n"
           ".leader { stroke: #aaaaaa; stroke-width: 0.6 }\n"
           "@media (prefers-color-scheme: dark) {\n"
           ".paper { fill: #14171c }\n"
           ".tick, .title { fill: #c4c8ce }\n"
           ".grid { stroke: #2a2f37 }\n"
           "}\n</style>\n<rect class=\"paper\" width=\"" +
           width + "\" height=\"" + height + "\"/>\n" + picture.written() + "</svg>\n";
}

}  // namespace toile::bench
