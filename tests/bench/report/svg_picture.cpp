// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/svg_picture.h"

#include <initializer_list>

#include "core/base/text.h"

namespace toile::bench {
namespace {

std::string number(double value) {
    return fixed(value, 1);
}

/// name="value" with a blank before it.
std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string circle(PlanePoint at, const char* radius) {
    return "<circle" + attribute("cx", number(at.x)) + attribute("cy", number(at.y)) +
           attribute("r", radius);
}

/// A closed line through points about `at`.
std::string path(PlanePoint at, std::initializer_list<PlanePoint> around) {
    std::string d;
    for (const PlanePoint& p : around) {
        d += (d.empty() ? "M" : "L") + number(at.x + p.x) + " " + number(at.y + p.y);
    }
    return "<path" + attribute("d", d + "Z");
}

std::string shapeOf(Marker marker, PlanePoint at) {
    switch (marker) {
        case Marker::Disk:
            return circle(at, "3.6");
        case Marker::Ring:
            return circle(at, "5");
        case Marker::Square:
            return path(at, {{-3.2, -3.2}, {3.2, -3.2}, {3.2, 3.2}, {-3.2, 3.2}});
        case Marker::Diamond:
            return path(at, {{0, -4.8}, {4.8, 0}, {0, 4.8}, {-4.8, 0}});
        case Marker::Triangle:
            return path(at, {{0, -4.6}, {4.4, 3.4}, {-4.4, 3.4}});
        case Marker::Cross:
            return path(at, {{-3.6, -3.6}, {3.6, 3.6}, {0, 0}, {-3.6, 3.6}, {3.6, -3.6}, {0, 0}});
    }
    return "";
}

}  // namespace

void SvgPicture::line(const char* kind, PlanePoint a, PlanePoint b) {
    written_ += "<line" + attribute("class", kind) + attribute("x1", number(a.x)) +
                attribute("y1", number(a.y)) + attribute("x2", number(b.x)) +
                attribute("y2", number(b.y)) + "/>\n";
}

void SvgPicture::text(const char* kind, PlanePoint at, const std::string& words,
                      const std::string& more) {
    written_ += "<text" + attribute("class", kind) + attribute("x", number(at.x)) +
                attribute("y", number(at.y)) + more + ">" + words + "</text>\n";
}

void SvgPicture::curve(const std::vector<PlanePoint>& points, const std::string& colour) {
    std::string places;
    for (const PlanePoint& p : points) {
        places += (places.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    }
    written_ += "<polyline fill=\"none\" stroke-width=\"1.8\"" + attribute("stroke", colour) +
                attribute("points", places) + "/>\n";
}

void SvgPicture::marker(Marker marker, PlanePoint at, const std::string& colour) {
    const bool hollow = marker == Marker::Ring || marker == Marker::Cross;
    written_ += shapeOf(marker, at) +
                (hollow ? " fill=\"none\" stroke-width=\"1.8\"" + attribute("stroke", colour)
                        : attribute("fill", colour)) +
                "/>\n";
}

}  // namespace toile::bench
