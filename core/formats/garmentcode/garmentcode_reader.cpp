// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/garmentcode/garmentcode_reader.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/characters.h"
#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/geometry/polygon.h"

namespace toile {
namespace {

constexpr double kMaxCoordinate = 1e7;  // in the file's unit
constexpr double kMaxShare = 1e4;       // of an edge's length: distance of its control points
constexpr double kMaxOfArc = kPi / 6;   // radians per cubic curve: its error is negligible
constexpr int kPointsPerCurve = 32;
constexpr double kMetre = 1000;         // mm
constexpr double kUsualPerMetre = 100;  // cm
constexpr double kMinPerMetre = 1e-3, kMaxPerMetre = 1e6;

/// A point in coordinates of an edge: along the edge, and to its left, in lengths of the edge.
Eigen::Vector2d besideEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double along,
                           double left) {
    const Eigen::Vector2d edge = to - from;
    return from + along * edge + left * Eigen::Vector2d(-edge.y(), edge.x());
}

CubicCurve fromQuadratic(const Eigen::Vector2d& from, const Eigen::Vector2d& control,
                         const Eigen::Vector2d& to) {
    return {from, from + 2.0 / 3 * (control - from), to + 2.0 / 3 * (control - to), to};
}

/// A circular arc on the right or left of its chord.
std::vector<CubicCurve> arcCurves(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                  double radius, bool isLarge, bool isRight) {
    const double chord = (to - from).norm();
    if (!(chord > 0) || !(radius > 0)) {
        return {straightCurve(from, to)};
    }
    const double half = std::asin(std::min(1.0, chord / (2 * radius)));
    const double angle = isLarge ? 2 * kPi - 2 * half : 2 * half;
    const double r = std::max(radius, chord / 2);
    const Eigen::Vector2d left = Eigen::Vector2d(-(to - from).y(), (to - from).x()) / chord;
    const double away = std::sqrt(std::max(0.0, r * r - chord * chord / 4));
    const double side = isRight != isLarge ? 1 : -1;  // of the centre, from the chord
    const Eigen::Vector2d centre = (from + to) / 2 + side * away * left;
    const double turn = isRight ? angle : -angle;  // anti-clockwise if the arc is on the right
    const int count = std::max(1, static_cast<int>(std::ceil(angle / kMaxOfArc)));
    const double step = turn / count, handle = 4.0 / 3 * std::tan(step / 4);
    std::vector<CubicCurve> curves;
    Eigen::Vector2d at = from;
    for (int k = 0; k < count; ++k) {
        const Eigen::Vector2d out = at - centre;
        const Eigen::Vector2d next = k + 1 == count ? to : centre + Eigen::Rotation2Dd(step) * out;
        const Eigen::Vector2d outNext = next - centre;
        curves.push_back({at, at + handle * Eigen::Vector2d(-out.y(), out.x()),
                          next - handle * Eigen::Vector2d(-outNext.y(), outNext.x()), next});
        at = next;
    }
    return curves;
}

/// Outside of the reader class, because texts to translate are grouped by class.
Wording reasonOfUnit(double perMetre) {
    return perMetre > 0 ? worded("units_in_meter %1", {Wording(shortest(perMetre))})
                        : worded("the file states no unit; this format usually uses cm");
}

class GarmentCodeReader {
public:
    explicit GarmentCodeReader(std::optional<FileUnit> stated) : stated_(stated) {}

    Result<GarmentCode> read(const JsonDocument& document) {
        JsonFields fields(document, "", faults_);
        fields.readObject("properties", [this](JsonFields& properties) { readUnit(properties); });
        if (stated_) {
            code_.unit = millimetresPer(*stated_);
            code_.unitReason = {};
            code_.unitInDoubt = false;
        }
        bool hasPattern = false;
        fields.readObject("pattern", [&](JsonFields& pattern) {
            hasPattern = true;
            readPattern(pattern);
        });
        if (!hasPattern && !fields.failed()) {
            fields.fail("pattern", "is missing");
        }
        if (!faults_.first.empty()) {
            return Error{ErrorCode::MalformedFile, {}, faults_.first};
        }
        return std::move(code_);
    }

private:
    void readUnit(JsonFields& properties) {
        std::string coordinates = "relative";
        properties.read("curvature_coords", coordinates);
        isRelative_ = coordinates != "absolute";
        double perMetre = 0;
        properties.read("units_in_meter", perMetre, 0, kMaxPerMetre);
        if (perMetre >= kMinPerMetre) {
            code_.unit = kMetre / perMetre;
            code_.unitReason = reasonOfUnit(perMetre);
        } else {
            code_.unit = kMetre / kUsualPerMetre;
            code_.unitReason = reasonOfUnit(0);
            code_.unitInDoubt = true;
        }
    }

    void readPattern(JsonFields& pattern) {
        std::vector<std::string> order;
        pattern.readEach("panel_order", [&](const JsonDocument& json, const std::string&) {
            if (json.is_string()) {
                order.push_back(json.get<std::string>());
            }
        });
        pattern.readObject("panels", [&](JsonFields& panels) {
            const JsonDocument& all = panels.all();
            std::map<std::string, bool> isTaken;
            const auto take = [&](const std::string& name) {
                const auto found = all.is_object() ? all.find(name) : all.end();
                if (found != all.end() && !isTaken[name]) {
                    isTaken[name] = true;
                    JsonFields panel(*found, panels.placeOf(name), faults_);
                    numbers_[name] = static_cast<int>(code_.panels.size());
                    readPanel(panel, name);
                }
            };
            std::ranges::for_each(order, take);
            for (const auto& entry : all.items()) {
                take(entry.key());
            }
        });
        if (faults_.first.empty() && code_.panels.empty()) {
            pattern.fail("panels", "must have one at least");
        }
        pattern.readEach("stitches", [this](const JsonDocument& json, const std::string& place) {
            readStitch(json, place);
        });
    }

    std::vector<Eigen::Vector2d> readVertices(JsonFields& panel) {
        std::vector<Eigen::Vector2d> vertices;
        panel.readEach("vertices", [&](const JsonDocument& json, const std::string& place) {
            const auto at = numbersOf(json, 2);
            if (at && std::abs(at->front()) < kMaxCoordinate &&
                std::abs(at->back()) < kMaxCoordinate) {
                vertices.emplace_back(code_.unit * at->front(), code_.unit * at->back());
            } else {
                panel.failAt(place, "must be two numbers");
            }
        });
        return vertices;
    }

    void readPanel(JsonFields& fields, const std::string& name) {
        GarmentCodePanel panel;
        panel.name = readableName(name);
        fields.read("label", panel.label);
        if (const auto at = fields.numbers("translation", 3, kMaxCoordinate)) {
            panel.translation = code_.unit * Eigen::Vector3d((*at)[0], (*at)[1], (*at)[2]);
        }
        if (const auto turns = fields.numbers("rotation", 3, kMaxCoordinate)) {
            panel.rotation = {(*turns)[0], (*turns)[1], (*turns)[2]};
        }
        const std::vector<Eigen::Vector2d> vertices = readVertices(fields);
        fields.readEach("edges", [&](const JsonDocument& json, const std::string& place) {
            JsonFields edge(json, place, faults_);
            readEdge(edge, vertices, panel);
        });
        if (faults_.first.empty() && !isLoop(panel)) {
            fields.fail("edges", "must be a closed line, one after the other");
        }
        code_.panels.push_back(std::move(panel));
    }

    static bool isLoop(const GarmentCodePanel& panel) {
        const std::size_t count = panel.edges.size();
        for (std::size_t k = 0; k < count; ++k) {
            if (panel.edges[k].vertices[1] != panel.edges[(k + 1) % count].vertices[0]) {
                return false;
            }
        }
        // Two straight edges, there and back, enclose no area.
        return count > 2 || (count == 2 && std::ranges::any_of(panel.edges, [](const auto& edge) {
                                 return !edge.curves.front().isLine;
                             }));
    }

    void readEdge(JsonFields& fields, const std::vector<Eigen::Vector2d>& vertices,
                  GarmentCodePanel& panel) {
        GarmentCodeEdge edge;
        const auto ends = fields.numbers("endpoints", 2);
        const auto isVertex = [&vertices](double number) {
            return number >= 0 && number < static_cast<double>(vertices.size()) &&
                   number == std::floor(number);
        };
        if (!ends || !isVertex(ends->front()) || !isVertex(ends->back())) {
            if (!fields.failed()) {
                fields.fail("endpoints", "must be two vertices of the panel");
            }
            return;
        }
        edge.vertices = {static_cast<int>(ends->front()), static_cast<int>(ends->back())};
        edge.curves = readCurve(fields, vertices[static_cast<std::size_t>(edge.vertices[0])],
                                vertices[static_cast<std::size_t>(edge.vertices[1])]);
        edge.length = curveLength(edge.curves);
        panel.edges.push_back(std::move(edge));
    }

    /// Converts a control point of a curve.
    Eigen::Vector2d control(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            const std::vector<double>& point) const {
        return isRelative_ ? besideEdge(from, to, point[0], point[1])
                           : Eigen::Vector2d(code_.unit * point[0], code_.unit * point[1]);
    }

    std::vector<CubicCurve> readCurve(JsonFields& fields, const Eigen::Vector2d& from,
                                      const Eigen::Vector2d& to) {
        std::vector<CubicCurve> straight{straightCurve(from, to)};
        const JsonDocument* json = fields.find("curvature");
        if (!json || json->is_null()) {
            return straight;
        }
        if (const auto point = numbersOf(*json, 2)) {
            return isShare(*point) ? std::vector{fromQuadratic(from, control(from, to, *point), to)}
                                   : refused(fields, straight);
        }
        if (!json->is_object() || !json->contains("type") || !json->contains("params")) {
            return refused(fields, straight);
        }
        const JsonDocument &type = (*json)["type"], &params = (*json)["params"];
        const auto pointOf = [&params](std::size_t k) {
            return params.is_array() && k < params.size() ? numbersOf(params[k], 2) : std::nullopt;
        };
        const auto first = pointOf(0), second = pointOf(1);
        if (type == "quadratic" && first && isShare(*first)) {
            return {fromQuadratic(from, control(from, to, *first), to)};
        }
        if (type == "cubic" && first && second && isShare(*first) && isShare(*second)) {
            return {{from, control(from, to, *first), control(from, to, *second), to}};
        }
        if (const auto circle = type == "circle" ? circleOf(params) : std::nullopt) {
            return arcCurves(from, to, code_.unit * (*circle)[0], (*circle)[1] != 0,
                             (*circle)[2] != 0);
        }
        return refused(fields, straight);
    }

    /// Radius, large arc flag, and whether the arc is on the right; flags as numbers or words.
    static std::optional<std::array<double, 3>> circleOf(const JsonDocument& params) {
        std::array<double, 3> found{};
        if (!params.is_array() || params.size() != found.size()) {
            return {};
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (params[k].is_boolean()) {
                found[k] = params[k].get<bool>() ? 1 : 0;
            } else if (params[k].is_number()) {
                found[k] = params[k].get<double>();
            } else {
                return {};
            }
        }
        return found[0] > 0 && found[0] < kMaxCoordinate ? std::optional(found) : std::nullopt;
    }

    bool isShare(const std::vector<double>& point) const {
        const double most = isRelative_ ? kMaxShare : kMaxCoordinate;
        return std::abs(point[0]) < most && std::abs(point[1]) < most;
    }

    static std::vector<CubicCurve> refused(JsonFields& fields,
                                           const std::vector<CubicCurve>& straight) {
        if (!fields.failed()) {
            fields.fail("curvature", "must be a quadratic or cubic curve or a part of a circle");
        }
        return straight;
    }

    void readStitch(const JsonDocument& json, const std::string& place) {
        const bool isPair = json.is_array() && json.size() >= 2;
        GarmentCodeStitch stitch;
        for (std::size_t k = 0; k < 2; ++k) {
            const JsonDocument* side = isPair && json[k].is_object() ? &json[k] : nullptr;
            const auto panel = side && side->contains("panel") && (*side)["panel"].is_string()
                                   ? numbers_.find((*side)["panel"].get<std::string>())
                                   : numbers_.end();
            const bool hasEdge =
                side && side->contains("edge") && (*side)["edge"].is_number_integer();
            const long long edge = hasEdge ? (*side)["edge"].get<long long>() : -1;
            if (panel == numbers_.end() || edge < 0 ||
                edge >= static_cast<long long>(
                            code_.panels[static_cast<std::size_t>(panel->second)].edges.size())) {
                if (faults_.first.empty()) {
                    faults_.first = place + " must be two edges of panels";
                }
                return;
            }
            stitch.sides[k] = {panel->second, static_cast<int>(edge)};
        }
        code_.stitches.push_back(stitch);
    }

    std::optional<FileUnit> stated_;
    JsonFaults faults_;
    GarmentCode code_;
    std::map<std::string, int> numbers_;  ///< of panels
    bool isRelative_ = true;
};

/// The unit with this length in mm, or the nearest unit that Toile has.
LengthUnit unitOf(double millimetres) {
    LengthUnit best = LengthUnit::Centimetre;
    for (const LengthUnit unit : kLengthUnits) {
        if (std::abs(std::log(millimetres / millimetresPer(unit))) <
            std::abs(std::log(millimetres / millimetresPer(best)))) {
            best = unit;
        }
    }
    return best;
}

}  // namespace

Result<GarmentCode> readGarmentCode(std::string_view bytes, std::optional<FileUnit> stated) {
    const auto document = parseJson(bytes, {}, ErrorCode::MalformedFile);
    if (!document) {
        return Error{ErrorCode::MalformedFile, {}, document.error().detail};
    }
    return GarmentCodeReader(stated).read(*document);
}

Points2 outlineOf(const GarmentCodePanel& panel) {
    std::vector<Eigen::RowVector2d> points;
    for (const GarmentCodeEdge& edge : panel.edges) {
        for (const CubicCurve& curve : edge.curves) {
            const Points2 line = sampled({curve}, curve.isLine ? 1 : kPointsPerCurve);
            for (Eigen::Index k = 0; k + 1 < line.rows(); ++k) {
                points.emplace_back(line.row(k));
            }
        }
    }
    Points2 outline(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        outline.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return outline;
}

PatternFile patternOf(const GarmentCode& code) {
    PatternFile file;
    file.format = worded("GarmentCode JSON, %1 of stitched edges",
                         {countWording(static_cast<long long>(code.stitches.size()), "pair")});
    file.unit = unitOf(code.unit);
    file.unitReason = code.unitReason;
    file.unitInDoubt = code.unitInDoubt;
    file.notes = code.notes;
    for (const GarmentCodePanel& panel : code.panels) {
        FilePiece& piece = file.pieces.emplace_back();
        piece.id = piece.name = panel.name;
        piece.annotation = panel.label;
        piece.sew = geometry::antiClockwise(outlineOf(panel));
    }
    return file;
}

}  // namespace toile
