// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_cuts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "core/base/unique_names.h"

namespace toile {
namespace {

/// Edges from here on are a seam's, and stay; rounds of ironing for the others.
constexpr double kStays = 0.6;
constexpr int kRounds = 40;

/// A garment nearer than this to its own mirror image, mm, is cut alike on both sides.
constexpr double kSymmetric = 0.5;

/// "left side": as the wearer has it.
std::string nameOf(const TailorSeam& seam, const GarmentBody& body) {
    std::string word = wordOf(seam.line);
    if (seam.side == 0) {
        return word;
    }
    const bool isLeftAcross = body.up.cross(body.forward).dot(body.plane.normal) > 0;
    return ((seam.side > 0) == isLeftAcross ? "left " : "right ") + word;
}

class Ironing {
public:
    Ironing(const BodyWays& ways, const MeshLines& lines, const std::vector<TailorSeam>& seams)
        : ways_(ways), lines_(lines), nearest_(ways.links().mesh()) {
        for (const TailorSeam& seam : seams) {
            held_.insert(seam.way.front());
            held_.insert(seam.way.back());
        }
    }

    /// The points of a line, its teeth ironed out; of one that goes round the first is not
    /// repeated.
    std::vector<Eigen::Vector3d> ironed(const std::vector<int>& way) const {
        const std::size_t n = way.size();
        std::vector<Eigen::Vector3d> points;
        std::vector<char> isFree(n, 1);
        for (std::size_t k = 0; k < n; ++k) {
            points.push_back(ways_.at(way[k]));
            if (held_.contains(way[k]) || k == 0 || k + 1 == n) {
                isFree[k] = 0;
            }
        }
        for (std::size_t k = 1; k < n; ++k) {
            const int edge = findEdge(ways_.links().table().edges, way[k - 1], way[k]);
            if (lines_.at(edge) >= kStays) {
                isFree[k] = isFree[k - 1] = 0;
            }
        }
        for (int round = 0; round < kRounds; ++round) {
            std::vector<Eigen::Vector3d> next = points;
            for (std::size_t k = 1; k + 1 < n && !ways_.isCancelled(); ++k) {
                if (isFree[k] != 0) {
                    const Eigen::Vector3d middle = (points[k - 1] + points[k + 1]) / 2;
                    next[k] = onSurface((points[k] + middle) / 2);
                }
            }
            points = std::move(next);
        }
        if (way.front() == way.back()) {
            points.pop_back();
        }
        return points;
    }

private:
    Eigen::Vector3d onSurface(const Eigen::Vector3d& p) const {
        return positionOf(ways_.links().mesh(), nearest_.find(p));
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const NearestSurface nearest_;
    std::set<int> held_;  ///< where seams end
};

/// Makes both sides alike: those of one are those of the other, reflected, and the centre lies in
/// the plane. What met a line that has moved goes along to it.
class Reflection {
public:
    Reflection(std::vector<TailorCut>& cuts, const MirrorPlane& plane)
        : cuts_(cuts), plane_(plane) {}

    void run() {
        for (TailorCut& cut : cuts_) {
            if (cut.line == TailorLine::Centre) {
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
            if (other != cuts_.end()) {
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

    /// Takes along what lay on a point that has moved.
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
    const MirrorPlane& plane_;
    std::map<Key, Eigen::Vector3d> moved_;
};

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
    if (!body || body->form == BodyForm::Unknown || progress.isCancelled()) {
        return {};
    }
    const SurfaceLinks links(piece->mesh, piece->table);
    const BodyWays ways(links, *body, progress);
    const MeshLines lines = findMeshLines(links);
    const std::vector<TailorSeam> seams = tailorSeams(ways, lines, progress);
    const Ironing ironing(ways, lines, seams);
    UniqueNames names;
    std::vector<TailorCut> cuts;
    for (const TailorSeam& seam : seams) {
        TailorCut& made = cuts.emplace_back();
        made.line = seam.line;
        made.side = seam.side;
        made.likeliness = seam.likeliness;
        made.cut.name = names.free(nameOf(seam, *body));
        made.cut.points = ironing.ironed(seam.way);
        made.cut.kind =
            seam.way.front() == seam.way.back() ? UserCut::Kind::Loop : UserCut::Kind::Path;
    }
    if (body->plane.deviation < kSymmetric) {
        Reflection(cuts, body->plane).run();
    }
    return cuts;
}

}  // namespace toile
