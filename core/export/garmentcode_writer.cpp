// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/garmentcode_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/export/json.h"

namespace toile {
namespace {

constexpr double kMillimetresPerUnit = 10;  // centimetres, as in the format's own files
constexpr double kFinest = 1e7;             // of a centimetre: further digits carry no information
constexpr double kFinestShare = 1e10;

double rounded(double value, double finest) {
    const double result = std::round(value * finest) / finest;
    return result == 0 ? 0 : result;  // never -0
}

Json pointJson(const Eigen::Vector2d& point) {
    return {number(point.x()), number(point.y())};
}

Eigen::Vector2d vertexOf(const Eigen::Vector2d& point) {
    return {rounded(point.x() / kMillimetresPerUnit, kFinest),
            rounded(point.y() / kMillimetresPerUnit, kFinest)};
}

/// A control point along an edge and to its left, relative to its length.
Eigen::Vector2d relativeTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                           const Eigen::Vector2d& control) {
    const Eigen::Vector2d edge = to - from, way = control - from;
    const double square = edge.squaredNorm();
    return {rounded(edge.dot(way) / square, kFinestShare),
            rounded((edge.x() * way.y() - edge.y() * way.x()) / square, kFinestShare)};
}

/// Rotations about x, then y, then z, in degrees.
std::array<double, 3> anglesOf(const Eigen::Matrix3d& turn) {
    const double across = std::hypot(turn(0, 0), turn(1, 0));
    constexpr double kUpright = 1e-9;
    const double y = std::atan2(-turn(2, 0), across);
    const double x = across > kUpright ? std::atan2(turn(2, 1), turn(2, 2))
                                       : std::atan2(-turn(1, 2), turn(1, 1));
    const double z = across > kUpright ? std::atan2(turn(1, 0), turn(0, 0)) : 0;
    return {rounded(x / kDegree, kFinest), rounded(y / kDegree, kFinest),
            rounded(z / kDegree, kFinest)};
}

Json edgeJson(const PanelEdge& edge, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              std::size_t index, std::size_t next) {
    Json json;
    json["endpoints"] = {index, next};
    const Eigen::Vector2d first = edge.curve.startHandle / kMillimetresPerUnit,
                          second = edge.curve.endHandle / kMillimetresPerUnit;
    if (!edge.curve.isLine && (to - from).squaredNorm() > 0) {
        Json curvature;
        curvature["type"] = "cubic";
        curvature["params"] = Json::array(
            {pointJson(relativeTo(from, to, first)), pointJson(relativeTo(from, to, second))});
        json["curvature"] = std::move(curvature);
    }
    return json;
}

Json panelJson(const SewnPanel& panel) {
    Json json;
    const Eigen::Vector3d shift = panel.shift / kMillimetresPerUnit;
    json["translation"] = {number(rounded(shift.x(), kFinest)), number(rounded(shift.y(), kFinest)),
                           number(rounded(shift.z(), kFinest))};
    const auto angles = anglesOf(panel.turn);
    json["rotation"] = {number(angles[0]), number(angles[1]), number(angles[2])};
    json["vertices"] = Json::array();
    json["edges"] = Json::array();
    const std::size_t count = panel.edges.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Eigen::Vector2d from = vertexOf(panel.edges[k].curve.start),
                              to = vertexOf(panel.edges[(k + 1) % count].curve.start);
        json["vertices"].push_back(pointJson(from));
        json["edges"].push_back(edgeJson(panel.edges[k], from, to, k, (k + 1) % count));
    }
    json["label"] = panel.label;
    return json;
}

}  // namespace

std::string writeGarmentCode(const SewnPanels& panels) {
    Json pattern;
    pattern["panels"] = Json::object();
    pattern["stitches"] = Json::array();
    pattern["panel_order"] = Json::array();
    for (const SewnPanel& panel : panels.panels) {
        pattern["panels"][panel.name] = panelJson(panel);
        pattern["panel_order"].push_back(panel.name);
    }
    for (const SewnEdges& stitch : panels.stitches) {
        Json sides = Json::array();
        for (const auto& [panel, edge] : stitch.sides) {
            Json side;
            side["panel"] = panels.panels[static_cast<std::size_t>(panel)].name;
            side["edge"] = edge;
            sides.push_back(std::move(side));
        }
        pattern["stitches"].push_back(std::move(sides));
    }
    Json properties;
    properties["curvature_coords"] = "relative";
    properties["normalize_panel_translation"] = false;
    properties["normalized_edge_loops"] = true;
    properties["units_in_meter"] = 100;
    Json json;
    json["pattern"] = std::move(pattern);
    json["parameters"] = Json::object();
    json["parameter_order"] = Json::array();
    json["properties"] = std::move(properties);
    return jsonText(json);
}

}  // namespace toile
