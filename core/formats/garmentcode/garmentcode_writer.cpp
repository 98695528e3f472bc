// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/garmentcode/garmentcode_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <Eigen/SVD>

#include "core/base/units.h"
#include "core/formats/json.h"
#include "core/pattern/curve_fit.h"

namespace toile {
namespace {

constexpr int kHalvings = 50;

/// The parameter at which a curve has this length.
double parameterAt(const CubicCurve& curve, double length) {
    if (curve.isLine) {
        return length / curveLength(curve);
    }
    double low = 0, high = 1;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (low + high) / 2;
        (curveLength(dividedAt(curve, middle)[0]) < length ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

std::array<CubicCurve, 2> dividedAt(const CubicCurve& curve, double t) {
    const auto between = [t](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return Eigen::Vector2d(a + t * (b - a));
    };
    if (curve.isLine) {
        const Eigen::Vector2d place = between(curve.start, curve.end);
        return {straightCurve(curve.start, place), straightCurve(place, curve.end)};
    }
    const Eigen::Vector2d a = between(curve.start, curve.startHandle),
                          b = between(curve.startHandle, curve.endHandle),
                          c = between(curve.endHandle, curve.end), ab = between(a, b),
                          bc = between(b, c), place = between(ab, bc);
    return {CubicCurve{curve.start, a, ab, place}, CubicCurve{place, bc, c, curve.end}};
}

std::vector<CubicCurve> dividedChain(const std::vector<CubicCurve>& chain,
                                     const std::vector<double>& places, double near) {
    std::vector<CubicCurve> parts;
    std::size_t next = 0;
    double begin = 0;
    for (CubicCurve rest : chain) {
        double length = curveLength(rest);
        const double end = begin + length;
        while (next < places.size() && places[next] <= begin + near) {
            ++next;
        }
        for (; next < places.size() && places[next] < end - near; ++next) {
            if (places[next] <= begin + near) {
                continue;
            }
            auto [before, after] = dividedAt(rest, parameterAt(rest, places[next] - begin));
            parts.push_back(before);
            rest = after;
            begin = places[next];
        }
        parts.push_back(rest);
        begin = end;
    }
    return parts;
}

std::vector<double> jointsOf(const std::vector<CubicCurve>& chain) {
    std::vector<double> joints;
    double at = 0;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        joints.push_back(at += curveLength(chain[k]));
    }
    return joints;
}

namespace {

/// A curve is divided if the distance of its ends is less than this share of its length, because
/// control points are relative to the chord.
constexpr double kMinChord = 0.2;

void addHalved(const CubicCurve& curve, std::vector<CubicCurve>& chain) {
    const double length = curveLength(curve);
    if (!(length > 0)) {
        return;
    }
    if (!curve.isLine && (curve.end - curve.start).norm() < kMinChord * length) {
        const auto halves = dividedAt(curve, 0.5);
        chain.insert(chain.end(), halves.begin(), halves.end());
    } else {
        chain.push_back(curve);
    }
}

/// One side of a seam: consecutive segments of one piece.
struct SeamRun {
    int piece = -1;
    std::vector<int> segments{};
    std::vector<CubicCurve> chain{};
    std::vector<std::size_t> first{};  ///< index of each segment's first curve in the chain

    void measure(const std::vector<std::vector<std::vector<CubicCurve>>>& curves) {
        for (const int segment : segments) {
            first.push_back(chain.size());
            const auto& own =
                curves[static_cast<std::size_t>(piece)][static_cast<std::size_t>(segment)];
            chain.insert(chain.end(), own.begin(), own.end());
        }
    }
};

using SideKey = std::pair<int, bool>;  // number of the seam, right side

/// The runs of all seams, each from the start of its side along the outline. A side that is not one
/// run is left out.
std::map<SideKey, SeamRun> seamRuns(const Pattern& pattern) {
    std::map<SideKey, SeamRun> runs;
    for (int p = 0; p < static_cast<int>(pattern.pieces.size()); ++p) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(p)];
        const int count = static_cast<int>(piece.segments.size());
        for (const SeamLine& seam : piece.seams) {
            if (seam.kind == SeamKind::Free) {
                continue;
            }
            const auto isPart = [&](int k) {
                const PatternSegment& segment =
                    piece.segments[static_cast<std::size_t>((k + count) % count)];
                return segment.seam == seam.number && segment.isRight == seam.isRight;
            };
            SeamRun run{p};
            int start = -1;
            for (int k = 0; k < count; ++k) {
                const bool begins =
                    isPart(k) &&
                    (!isPart(k - 1) || std::abs(piece.segments[static_cast<std::size_t>(k)].from -
                                                seam.from) < kSameJoint);
                start = begins && start < 0 ? k : start;
            }
            for (int k = start; start >= 0 && k < start + count && isPart(k); ++k) {
                run.segments.push_back(k % count);
            }
            if (!run.segments.empty()) {
                runs.emplace(SideKey{seam.number, seam.isRight}, std::move(run));
            }
        }
    }
    return runs;
}

/// Divides the curves of both sides at the joints of either, so that they correspond one to one.
/// @param opposed  the right one runs from the end of the seam to its start
void divideAlike(SeamRun& left, SeamRun& right, bool opposed) {
    const double lengthLeft = curveLength(left.chain), lengthRight = curveLength(right.chain);
    const auto across = [&](double at, double from, double to) {
        return opposed ? to * (1 - at / from) : to * at / from;
    };
    std::vector<double> onLeft;  // the joints of the right side
    for (const double joint : jointsOf(right.chain)) {
        onLeft.push_back(across(joint, lengthRight, lengthLeft));
    }
    std::ranges::sort(onLeft);
    // Joints of the two sides at the same place divide neither side. Each joint is matched once, so
    // both sides get the same number, measured on the left side.
    const std::vector<double> leftJoints = jointsOf(left.chain);
    std::vector<double> newOnLeft, newOnRight;
    const auto divideRight = [&](double place) {
        newOnRight.push_back(across(place, lengthLeft, lengthRight));
    };
    std::size_t l = 0, r = 0;
    while (l < leftJoints.size() || r < onLeft.size()) {
        const bool isLast = r == onLeft.size();
        if (!isLast && l < leftJoints.size() && std::abs(leftJoints[l] - onLeft[r]) < kSameJoint) {
            ++l;
            ++r;
        } else if (isLast || (l < leftJoints.size() && leftJoints[l] < onLeft[r])) {
            divideRight(leftJoints[l++]);
        } else {
            newOnLeft.push_back(onLeft[r++]);
        }
    }
    std::ranges::sort(newOnRight);
    const auto divide = [](SeamRun& run, const std::vector<double>& places) {
        std::vector<double> starts(run.first.size(), 0);
        double at = 0;
        for (std::size_t k = 0, s = 0; k < run.chain.size(); ++k) {
            while (s < run.first.size() && run.first[s] == k) {
                starts[s++] = at;
            }
            at += curveLength(run.chain[k]);
        }
        run.chain = dividedChain(run.chain, places, 0);
        at = 0;
        std::size_t s = 0;
        for (std::size_t k = 0; k < run.chain.size(); ++k) {
            while (s < run.first.size() && at >= starts[s] - kSameJoint / 4) {
                run.first[s++] = k;
            }
            at += curveLength(run.chain[k]);
        }
    };
    divide(left, newOnLeft);
    divide(right, newOnRight);
}

/// Finds the rigid motion that brings a flat piece nearest to its place in the garment.
void placeInSpace(const Points2& flat, const Points3& garment, SewnPanel& panel) {
    const Eigen::Vector3d middle = garment.colwise().mean().transpose();
    const Eigen::Vector2d flatMiddle = flat.colwise().mean().transpose();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> from = flat.rowwise() - flatMiddle.transpose();
    const Points3 to = garment.rowwise() - middle.transpose();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    spread.leftCols<2>() = to.transpose() * from;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
    sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d turn = svd.matrixU() * sign * svd.matrixV().transpose();
    if (turn.allFinite() && middle.allFinite()) {
        panel.turn = turn;
        panel.shift = middle - turn.leftCols<2>() * flatMiddle;
    }
}

}  // namespace

SewnPanels sewnPanels(const ExportSource& source) {
    const Pattern& pattern = source.laid().wholePattern;
    std::vector<std::vector<std::vector<CubicCurve>>> curves(pattern.pieces.size());
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            std::vector<CubicCurve>& chain = curves[p].emplace_back();
            for (const CubicCurve& curve : curvesOf(piece, outline, segment)) {
                addHalved(curve, chain);
            }
        }
    }
    std::map<SideKey, SeamRun> runs = seamRuns(pattern);
    struct Sewn {
        SeamRun *left, *right;
        bool opposed;
    };
    std::vector<Sewn> sewn;
    for (auto& [key, run] : runs) {
        const auto other = runs.find({key.first, true});
        const auto number = static_cast<std::size_t>(key.first);
        if (key.second || other == runs.end() || number < 1 ||
            number > source.garment().seams.seams.size()) {
            continue;
        }
        const Seam& seam = source.garment().seams.seams[number - 1];
        run.measure(curves);
        other->second.measure(curves);
        if (run.chain.empty() || other->second.chain.empty()) {
            continue;
        }
        const bool opposed = seam.left.reversed != seam.right.reversed;
        divideAlike(run, other->second, opposed);
        sewn.push_back({&run, &other->second, opposed});
    }
    // Assign the divided curves to their segments again.
    for (const Sewn& seam : sewn) {
        for (const SeamRun* run : {seam.left, seam.right}) {
            for (std::size_t s = 0; s < run->segments.size(); ++s) {
                const std::size_t end =
                    s + 1 < run->first.size() ? run->first[s + 1] : run->chain.size();
                curves[static_cast<std::size_t>(run->piece)]
                      [static_cast<std::size_t>(run->segments[s])]
                          .assign(run->chain.begin() + static_cast<std::ptrdiff_t>(run->first[s]),
                                  run->chain.begin() + static_cast<std::ptrdiff_t>(end));
            }
        }
    }
    SewnPanels made;
    std::vector<std::vector<int>> firstEdges(pattern.pieces.size());
    std::vector<int> panelOf(pattern.pieces.size(), -1);
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        if (piece.outline.rows() == 0 || piece.segments.empty()) {
            continue;
        }
        panelOf[p] = static_cast<int>(made.panels.size());
        SewnPanel& panel = made.panels.emplace_back();
        panel.name = piece.slug;
        panel.label = piece.name;
        for (const auto& chain : curves[p]) {
            firstEdges[p].push_back(static_cast<int>(panel.edges.size()));
            for (const CubicCurve& curve : chain) {
                panel.edges.push_back({curve, curveLength(curve)});
            }
        }
        if (p < source.results().size() && source.results()[p] && source.results()[p]->flat &&
            p < source.garment().pieces.size()) {
            placeInSpace(source.results()[p]->flat->Q, source.garment().pieces[p]->mesh.V, panel);
        }
    }
    for (const Sewn& seam : sewn) {
        const auto edgesOf = [&](const SeamRun& run) {
            std::vector<SewnEdges::Side> sides;
            const auto piece = static_cast<std::size_t>(run.piece);
            for (const int segment : run.segments) {
                const int first = firstEdges[piece][static_cast<std::size_t>(segment)];
                const auto count =
                    static_cast<int>(curves[piece][static_cast<std::size_t>(segment)].size());
                for (int k = first; k < first + count; ++k) {
                    sides.push_back({panelOf[piece], k});
                }
            }
            return sides;
        };
        const auto left = edgesOf(*seam.left);
        auto right = edgesOf(*seam.right);
        if (seam.opposed) {
            std::ranges::reverse(right);
        }
        for (std::size_t k = 0; k < std::min(left.size(), right.size()); ++k) {
            made.stitches.push_back({{left[k], right[k]}});
        }
    }
    return made;
}

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
    constexpr double kNoTilt = 1e-9;
    const double y = std::atan2(-turn(2, 0), across);
    const double x =
        across > kNoTilt ? std::atan2(turn(2, 1), turn(2, 2)) : std::atan2(-turn(1, 2), turn(1, 1));
    const double z = across > kNoTilt ? std::atan2(turn(1, 0), turn(0, 0)) : 0;
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
