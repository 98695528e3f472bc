// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_cuts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "core/base/unique_names.h"
#include "core/tailor/fair_lines.h"
#include "core/tailor/marked_mesh.h"

namespace toile {
namespace {

/// A garment nearer than this to its own mirror image, mm, is cut alike on both sides.
constexpr double kSymmetric = 0.5;

/// "left side": as the wearer has it.
std::string nameOf(const TailorSeam& seam, const GarmentBody& body) {
    std::string word = wordOf(seam.line);
    if (seam.side == 0) {
        return word;
    }
    return ((seam.side > 0) == body.isLeftAcross() ? "left " : "right ") + word;
}

/// Makes both sides alike: those of one are those of the other, reflected, and the centre lies in
/// the plane. What met a line that has moved goes along to it; lines that meet a person's cut stay.
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
    const std::vector<char>& isHeld_;
    const MirrorPlane& plane_;
    std::map<Key, Eigen::Vector3d> moved_;
};

/// Marks of the edges that a mesh still has after others were split.
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
    std::vector<char> isHeld;  // per cut: a person's own meets it
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
