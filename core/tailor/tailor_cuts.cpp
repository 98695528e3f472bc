// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/base/text.h"
#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"
#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"

namespace toile::tailor {
namespace {

struct Fairness {
    double near;    ///< mm: largest distance of the line from its way
    double step;    ///< mm: largest distance between its points
    int roundings;  ///< number of shortenings around each of them
};

/// The point between two neighbours on a path. @param share  0 at the first
SurfacePoint between(const SurfaceLinks& links, const SurfacePoint& a, const SurfacePoint& b,
                     double share) {
    const int face = links.commonFace(a, b);
    const auto first = links.seenFrom(face, a), second = links.seenFrom(face, b);
    return {face, (1 - share) * first->barycentric + share * second->barycentric};
}

/// Both parts of a path. @param at  mm from its start
std::array<PathPolyline, 2> divided(const SurfaceLinks& links, const PathPolyline& path,
                                    double at) {
    std::array<PathPolyline, 2> parts;
    double before = 0;
    std::size_t k = 1;
    parts[0].points.push_back(path.points.front());
    for (; k < path.points.size(); ++k) {
        const double step = (positionOf(links.mesh(), path.points[k]) -
                             positionOf(links.mesh(), path.points[k - 1]))
                                .norm();
        if (before + step >= at || k + 1 == path.points.size()) {
            const double share = step > 0 ? std::clamp((at - before) / step, 0.0, 1.0) : 0;
            const SurfacePoint middle = between(links, path.points[k - 1], path.points[k], share);
            parts[0].points.push_back(middle);
            parts[1].points.push_back(middle);
            break;
        }
        before += step;
        parts[0].points.push_back(path.points[k]);
    }
    parts[1].points.insert(parts[1].points.end(),
                           path.points.begin() + static_cast<std::ptrdiff_t>(k), path.points.end());
    for (PathPolyline& part : parts) {
        part.length = measuredLength(links.mesh(), part);
    }
    return parts;
}

PathPolyline joined(PathPolyline first, const PathPolyline& second) {
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    first.length += second.length;
    return first;
}

double distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
    double least = (line.front() - p).norm();
    for (std::size_t k = 1; k < line.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(p, line[k - 1], line[k]));
    }
    return least;
}

/// The fewest consecutive geodesics that stay near a path. Each is a globally shortest one: a path
/// pulled tight may pass the bumps of uneven cloth on other sides, and turn far more.
std::vector<PathPolyline> geodesicsNear(const SurfaceLinks& links, std::span<const int> way,
                                        double near) {
    auto shortest = geodesicPath(links, links.atVertex(way.front()), links.atVertex(way.back()));
    PathPolyline path =
        shortest ? std::move(*shortest) : polylineOf(links, {way.begin(), way.end()});
    const std::vector<Eigen::Vector3d> line = positionsOf(links.mesh(), path);
    double most = near;
    std::size_t farthest = 0;
    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
        const double distance = distanceTo(line, links.mesh().V.row(way[k]).transpose());
        if (distance > most) {
            most = distance;
            farthest = k;
        }
    }
    if (farthest == 0) {
        return {std::move(path)};
    }
    std::vector<PathPolyline> parts = geodesicsNear(links, way.first(farthest + 1), near);
    std::vector<PathPolyline> rest = geodesicsNear(links, way.subspan(farthest), near);
    std::ranges::move(rest, std::back_inserter(parts));
    return parts;
}

/// A path in parts of equal length, none longer than a step.
std::vector<PathPolyline> inSteps(const SurfaceLinks& links, PathPolyline path, double step) {
    const int count = std::max(1, static_cast<int>(std::ceil(path.length / step)));
    const double each = path.length / count;
    std::vector<PathPolyline> parts;
    for (int k = 1; k < count; ++k) {
        auto [part, rest] = divided(links, path, each);
        parts.push_back(std::move(part));
        path = std::move(rest);
    }
    parts.push_back(std::move(path));
    return parts;
}

/// Shortens a line around every second inner point, alternating between even and odd ones.
void roundKinks(const SurfaceLinks& links, std::vector<PathPolyline>& parts, int roundings) {
    for (int round = 0; round < 2 * roundings; ++round) {
        for (auto k = static_cast<std::size_t>(1 + round % 2); k < parts.size(); k += 2) {
            const PathPolyline whole = straightened(links, joined(parts[k - 1], parts[k]));
            auto [before, after] = divided(links, whole, whole.length / 2);
            parts[k - 1] = std::move(before);
            parts[k] = std::move(after);
        }
    }
}

/// The smooth line for a path along edges: the fewest geodesics that stay near it, with the kinks
/// between them rounded.  @param way  vertices, at least two
/// @return geodesics of equal length, one after the other, from its first vertex to its last
/// Cost: some shortest ways (`geodesicPath`) and dozens of shortenings (`straightened`). Pure.
std::vector<PathPolyline> fairPath(const SurfaceLinks& links, std::span<const int> way,
                                   const Fairness& fairness) {
    PathPolyline path;
    bool hasKinks = false;
    for (PathPolyline& part : geodesicsNear(links, way, fairness.near)) {
        hasKinks = !path.points.empty();
        path = hasKinks ? joined(std::move(path), part) : std::move(part);
    }
    std::vector<PathPolyline> parts = inSteps(links, std::move(path), fairness.step);
    if (hasKinks) {
        roundKinks(links, parts, fairness.roundings);
    }
    return parts;
}

/// Edges that look like a seam are kept if a run of them is at least this long, mm; no edge turns
/// by more than this from the one before, as a cosine.
constexpr double kLongEnough = 50, kNoCorner = 0.8;
/// For armholes, which are concave, and for other lines.
constexpr Fairness kFairHollow{5, 20, 3}, kFairStraight{18, 40, 6};
/// A line this close to another meets it, mm; at a point of the other, if one is this close.
constexpr double kMeets = 1, kMeetsAtPoint = 3;
/// A line that begins on the line it ends on has left it at this distance, mm.
constexpr double kLeft = 10;
constexpr int kPartsLookedAt = 8;

/// A line on the surface: its points, and those between where its geodesics cross edges.
struct FairLine {
    struct Point {
        Eigen::Vector3d at;
        bool isOwn;  ///< of the line; false: crossed by a geodesic
    };
    std::vector<Point> points;

    /// The place of the line nearest to a given point, and the points on either side of it.
    struct Nearest {
        Eigen::Vector3d at;
        std::size_t after = 0;
        double distance = 0;
    };
    Nearest nearest(const Eigen::Vector3d& p) const {
        Nearest found{points.front().at, 0, (points.front().at - p).norm()};
        for (std::size_t k = 1; k < points.size(); ++k) {
            const Eigen::Vector3d &a = points[k - 1].at, &b = points[k].at;
            const Eigen::Vector3d at = a + geometry::nearestShare(p, a, b) * (b - a);
            if ((at - p).norm() < found.distance) {
                found = {at, k, (at - p).norm()};
            }
        }
        return found;
    }

    /// Returns the point where another line meets this one: a near own point, or a new one.
    Eigen::Vector3d meet(const Nearest& place) {
        for (Point& point : points) {
            if (point.isOwn && (point.at - place.at).norm() < kMeetsAtPoint) {
                return point.at;
            }
        }
        points.insert(
            points.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(place.after, 1)),
            {place.at, true});
        return place.at;
    }

    /// Ends this line on another: where it first reaches it, or is nearest to it.
    void endOn(FairLine& other) {
        bool hasLeft = other.nearest(points.front().at).distance > kMeets;
        for (std::size_t k = 1; k < points.size(); ++k) {
            for (int part = 1; part <= kPartsLookedAt; ++part) {
                const double share = static_cast<double>(part) / kPartsLookedAt;
                const auto place =
                    other.nearest((1 - share) * points[k - 1].at + share * points[k].at);
                hasLeft = hasLeft || place.distance > kLeft;
                if (hasLeft && place.distance < kMeets) {
                    points.resize(k);
                    points.push_back({other.meet(place), true});
                    return;
                }
            }
        }
        const auto place = other.nearest(points.back().at);
        while (points.size() > 2 &&
               (points[points.size() - 2].at - place.at).norm() < 2 * place.distance) {
            points.pop_back();
        }
        points.back() = {other.meet(place), true};
    }
};

class FairLines {
public:
    FairLines(const BodyWays& ways, const MeshLines& lines, const std::vector<TailorSeam>& seams,
              const std::vector<std::vector<int>>& cuts)
        : ways_(ways), lines_(lines), seams_(seams) {
        for (const std::vector<int>& cut : cuts) {
            held_.insert(cut.begin(), cut.end());
        }
        for (std::size_t s = 0; s < seams.size(); ++s) {
            if (!isOfMesh(seams[s])) {
                held_.insert(seams[s].way.front());
                held_.insert(seams[s].way.back());
            }
            for (const int v : seams[s].way) {
                seamAt_.emplace(v, s);
            }
        }
    }

    std::vector<std::vector<Eigen::Vector3d>> run() {
        for (const TailorSeam& seam : seams_) {
            made_.push_back(fair(seam));
        }
        for (std::size_t s = 0; s < seams_.size(); ++s) {
            if (isOfMesh(seams_[s]) && !isRound(seams_[s])) {
                endOnOther(s, seams_[s].way.back());
                std::ranges::reverse(made_[s].points);
                endOnOther(s, seams_[s].way.front());
                std::ranges::reverse(made_[s].points);
            }
        }
        std::vector<std::vector<Eigen::Vector3d>> lines;
        for (std::size_t s = 0; s < seams_.size(); ++s) {
            std::vector<Eigen::Vector3d>& line = lines.emplace_back();
            for (const FairLine::Point& point : made_[s].points) {
                if (point.isOwn) {
                    line.push_back(point.at);
                }
            }
            if (isRound(seams_[s])) {
                line.pop_back();
            }
        }
        return lines;
    }

private:
    /// Lines found only by the mesh: they end on lines that follow the form.
    static bool isOfMesh(const TailorSeam& seam) {
        return seam.line == TailorLine::Style || seam.line == TailorLine::Band;
    }

    static bool isRound(const TailorSeam& seam) { return seam.way.front() == seam.way.back(); }

    /// Ends a style line on another line if its end vertex is on that line's way.
    void endOnOther(std::size_t s, int end) {
        const auto other = seamAt_.find(end);
        if (other != seamAt_.end() && other->second != s && !held_.contains(end)) {
            made_[s].endOn(made_[other->second]);
        }
    }

    std::vector<char> fixedVertices(const std::vector<int>& way) const {
        std::vector<char> isFixed;
        isFixed.reserve(way.size());
        for (const int v : way) {
            isFixed.push_back(held_.contains(v) ? 1 : 0);
        }
        isFixed.front() = isFixed.back() = 1;
        std::size_t first = 0;  // start of a run of the seam's edges
        double length = 0;
        for (std::size_t k = 1; k <= way.size(); ++k) {
            if (k < way.size() && isSeam(way[k - 1], way[k]) &&
                (length == 0 || isStraightOn(way[k - 2], way[k - 1], way[k]))) {
                length += (ways_.at(way[k]) - ways_.at(way[k - 1])).norm();
                continue;
            }
            if (length >= kLongEnough) {
                std::fill(isFixed.begin() + static_cast<std::ptrdiff_t>(first),
                          isFixed.begin() + static_cast<std::ptrdiff_t>(k), char{1});
            }
            const bool isCorner = k < way.size() && isSeam(way[k - 1], way[k]);
            first = isCorner ? k - 1 : k;
            length = isCorner ? (ways_.at(way[k]) - ways_.at(way[k - 1])).norm() : 0;
        }
        return isFixed;
    }

    bool isSeam(int from, int to) const {
        return lines_.at(findEdge(ways_.links().table().edges, from, to)) >= MeshLines::kLikely;
    }

    bool isStraightOn(int a, int b, int c) const {
        const Eigen::Vector3d before = ways_.at(b) - ways_.at(a), after = ways_.at(c) - ways_.at(b);
        return before.dot(after) > kNoCorner * before.norm() * after.norm();
    }

    void addFair(std::span<const int> way, TailorLine line, FairLine& made) const {
        const SurfaceLinks& links = ways_.links();
        for (const PathPolyline& part :
             fairPath(links, way, line == TailorLine::Armhole ? kFairHollow : kFairStraight)) {
            for (std::size_t k = 1; k + 1 < part.points.size(); ++k) {
                made.points.push_back({positionOf(links.mesh(), part.points[k]), false});
            }
            made.points.push_back({positionOf(links.mesh(), part.points.back()), true});
        }
        made.points.back().at = ways_.at(way.back());
    }

    FairLine fair(const TailorSeam& seam) const {
        const std::vector<int>& way = seam.way;
        const std::vector<char> isFixed = fixedVertices(way);
        FairLine made{{{ways_.at(way.front()), true}}};
        for (std::size_t first = 0; first + 1 < way.size() && !ways_.isCancelled();) {
            std::size_t last = first + 1;
            while (isFixed[last] == 0) {
                ++last;
            }
            if (last == first + 1) {
                made.points.push_back({ways_.at(way[last]), true});
            } else {
                if (way[first] == way[last]) {
                    last = (first + last) / 2;  // it is closed, and fixed nowhere else
                }
                addFair(std::span(way).subspan(first, last - first + 1), seam.line, made);
            }
            first = last;
        }
        return made;
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const std::vector<TailorSeam>& seams_;
    std::set<int> held_;
    std::map<int, std::size_t> seamAt_;  ///< by vertex: the first seam through it
    std::vector<FairLine> made_;
};

/// Makes smooth lines of paths along edges. Where a path follows a seam of the mesh it keeps the
/// edges. Elsewhere its zigzag is removed: it becomes the fewest geodesics that stay near it, with
/// the kinks between them rounded on the surface. Lines that meet share a point; a style line or a
/// band ends on the final course of the others.
/// @param cuts  ways that are cut in any case: lines meet them at their vertices
/// @return per seam points on the surface, joined by geodesics; a closed seam does not repeat its
/// first
/// Cost: some geodesics (`geodesicPath`) and dozens of shortenings (`straightened`) each.
/// Deterministic. Pure.
std::vector<std::vector<Eigen::Vector3d>> fairLines(const BodyWays& ways, const MeshLines& lines,
                                                    const std::vector<TailorSeam>& seams,
                                                    const std::vector<std::vector<int>>& cuts) {
    return FairLines(ways, lines, seams, cuts).run();
}

}  // namespace
}  // namespace toile::tailor

namespace toile {
namespace {

/// A garment closer than this to its own mirror image, mm, is cut symmetrically.
constexpr double kSymmetric = 0.5;

/// "left side": the wearer's left.
std::string nameOf(const TailorSeam& seam, const GarmentBody& body) {
    std::string word = wordOf(seam.line);
    if (seam.side == 0) {
        return word;
    }
    return ((seam.side > 0) == body.isLeftAcross() ? "left " : "right ") + word;
}

/// Makes both sides symmetric: reflects the lines of one side to the other, and moves the centre
/// into the plane. Lines that met a moved line follow it; lines that meet a user's cut stay.
class Reflection {
public:
    /// @param isHeld  per cut
    Reflection(std::vector<TailorCut>& cuts, const std::vector<char>& isHeld,
               const MirrorPlane& plane)
        : cuts_(cuts), isHeld_(isHeld), plane_(plane) {}

    void run() {
        for (TailorCut& cut : cuts_) {
            if (cut.line == TailorLine::Centre && !isHeld(cut)) {
                for (Eigen::Vector3d& point : cut.cut.points) {
                    move(point, (point + plane_.reflected(point)) / 2);
                }
            }
        }
        follow();
        for (TailorCut& cut : cuts_) {
            const auto other = std::ranges::find_if(cuts_, [&cut](const TailorCut& one) {
                return one.line == cut.line && one.side == -cut.side && one.side < 0;
            });
            if (other != cuts_.end() && !isHeld(cut) && !isHeld(*other)) {
                const std::vector<Eigen::Vector3d> before = cut.cut.points;
                cut.cut.points.clear();
                for (const Eigen::Vector3d& point : other->cut.points) {
                    cut.cut.points.push_back(plane_.reflected(point));
                }
                for (const Eigen::Vector3d& point : before) {
                    moved_.emplace(key(point), nearestOf(cut.cut.points, point));
                }
            }
        }
        follow();
    }

private:
    using Key = std::array<double, 3>;

    bool isHeld(const TailorCut& cut) const {
        return isHeld_[static_cast<std::size_t>(&cut - cuts_.data())] != 0;
    }

    static Key key(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

    static Eigen::Vector3d nearestOf(const std::vector<Eigen::Vector3d>& points,
                                     const Eigen::Vector3d& place) {
        return *std::ranges::min_element(points, {}, [&place](const Eigen::Vector3d& point) {
            return (point - place).squaredNorm();
        });
    }

    void move(Eigen::Vector3d& point, const Eigen::Vector3d& to) {
        moved_.emplace(key(point), to);
        point = to;
    }

    /// Moves the points that coincide with a moved point.
    void follow() {
        for (TailorCut& cut : cuts_) {
            for (Eigen::Vector3d& point : cut.cut.points) {
                if (const auto moved = moved_.find(key(point)); moved != moved_.end()) {
                    point = moved->second;
                }
            }
        }
        moved_.clear();
    }

    std::vector<TailorCut>& cuts_;
    const std::vector<char>& isHeld_;
    const MirrorPlane& plane_;
    std::map<Key, Eigen::Vector3d> moved_;
};

/// Border marks of the edges that still exist after other edges were split.
std::vector<char> bordersIn(const EdgeTable& table, const EdgeTable& before,
                            const std::vector<char>& borders) {
    std::vector<char> isBorder(static_cast<std::size_t>(table.edges.rows()), 0);
    for (Eigen::Index e = 0; e < before.edges.rows(); ++e) {
        const int now = borders[static_cast<std::size_t>(e)] != 0
                            ? findEdge(table.edges, before.edges(e, 0), before.edges(e, 1))
                            : -1;
        if (now >= 0) {
            isBorder[static_cast<std::size_t>(now)] = 1;
        }
    }
    return isBorder;
}

/// Whether most of a way runs along borders of the file.
bool isFileBorder(const std::vector<int>& way, const BodyWays& ways, const MeshLines& lines) {
    double along = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const int edge = findEdge(ways.links().table().edges, way[k - 1], way[k]);
        along += lines.isBorder(edge) ? ways.lengths()[static_cast<std::size_t>(edge)] : 0;
    }
    return along > ways.length(way) / 2;
}

}  // namespace

const char* wordOf(TailorLine line) {
    switch (line) {
        case TailorLine::Side:
            return "side";
        case TailorLine::Underarm:
            return "underarm";
        case TailorLine::Armhole:
            return "armhole";
        case TailorLine::Shoulder:
            return "shoulder";
        case TailorLine::Centre:
            return "centre";
        case TailorLine::Inseam:
            return "inseam";
        case TailorLine::Waist:
            return "waist";
        case TailorLine::Style:
            return "style line";
        case TailorLine::Band:
            return "band";
        case TailorLine::Ridge:
            return "ridge";
        case TailorLine::Opening:
            return "opening";
        case TailorLine::Dart:
            return "dart";
    }
    return "";
}

std::vector<TailorCut> tailorCuts(const std::shared_ptr<const Piece>& piece,
                                  const Progress& progress) {
    const auto body = readBody(piece, progress);
    return body ? tailorCuts(*piece, *body, {}, progress) : std::vector<TailorCut>{};
}

std::vector<TailorCut> tailorCuts(const Piece& piece, const GarmentBody& body,
                                  const std::vector<UserCut>& own, const Progress& progress,
                                  const std::vector<char>& borders) {
    if (body.form == BodyForm::Unknown || progress.isCancelled()) {
        return {};
    }
    const tailor::MarkedMesh marked = tailor::markedMesh(piece.mesh, piece.table, own, progress);
    const SurfaceLinks links(marked.mesh, marked.table);
    const BodyWays ways(links, body, progress);
    MeshLines lines = findMeshLines(links);
    if (!borders.empty()) {
        lines.addBorders(links, bordersIn(marked.table, piece.table, borders));
    }
    if (!marked.ways.empty()) {
        lines.addSure(marked.marks());
    }
    const std::vector<TailorSeam> seams = tailorSeams(ways, lines, marked.ways, progress);
    std::vector<std::vector<Eigen::Vector3d>> fair =
        tailor::fairLines(ways, lines, seams, marked.ways);
    UniqueNames names;
    for (const UserCut& cut : own) {
        names.take(cut.name);
    }
    std::vector<TailorCut> cuts;
    std::vector<char> isHeld;  // per cut: it meets a user's cut
    const std::set<int> atOwn = marked.vertices();
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const TailorSeam& seam = seams[s];
        TailorCut& made = cuts.emplace_back();
        isHeld.push_back(
            std::ranges::any_of(seam.way, [&atOwn](int v) { return atOwn.contains(v); }));
        made.line = seam.line;
        made.side = seam.side;
        made.likeliness = seam.likeliness;
        made.isFileBorder = isFileBorder(seam.way, ways, lines);
        made.cut.name = names.free(nameOf(seam, body));
        made.cut.points = std::move(fair[s]);
        made.cut.kind =
            seam.way.front() == seam.way.back() ? UserCut::Kind::Loop : UserCut::Kind::Path;
    }
    if (body.plane.deviation < kSymmetric) {
        Reflection(cuts, isHeld, body.plane).run();
    }
    return cuts;
}

}  // namespace toile
