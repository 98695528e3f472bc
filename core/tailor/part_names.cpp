// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/part_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include "core/cut/surface_paths.h"

namespace toile {
namespace {

/// A part is on one side of a plane if this share of its area is.
constexpr double kOnOneSide = 0.85;
/// A part is front or back if its mean normal has at least this component in that direction.
constexpr double kLooksThere = 0.2;
/// Largest width of a band, mm, and smallest share of its own rim at an opening.
constexpr double kWidestBand = 60, kBandAtOpening = 0.38;
/// Share of a cuff that belongs to a sleeve.
constexpr double kAllOfCuff = 0.9;

/// Position of a part's area.
struct PartArea {
    double whole = 0;
    Eigen::Vector3d centre{0, 0, 0};
    Eigen::Vector3d facing{0, 0, 0};  ///< mean normal; short if the part goes all round
    double left = 0;                  ///< area with positive `across`
};

PartArea areaOf(const MeshArrays& mesh, const GarmentBody& body) {
    PartArea area;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Vector3d normal = doubleAreaNormal(mesh, f) / 2;
        const Eigen::Vector3d middle =
            (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
        area.whole += normal.norm();
        area.facing += normal;
        area.centre += normal.norm() * middle;
        area.left += body.across(middle) > 0 ? normal.norm() : 0;
    }
    const double whole = std::max(area.whole, 1e-12);
    area.centre /= whole;
    area.facing /= whole;
    area.left /= whole;
    return area;
}

double rimLength(const Piece& piece) {
    double length = 0;
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        if (piece.table.isBorder(e)) {
            length += (piece.mesh.V.row(piece.table.edges(e, 1)) -
                       piece.mesh.V.row(piece.table.edges(e, 0)))
                          .norm();
        }
    }
    return length;
}

class PartNaming {
public:
    PartNaming(const Piece& whole, const GarmentBody& body, const std::vector<TailorCut>& cuts,
               const Piece& part)
        : whole_(whole), body_(body), cuts_(cuts), part_(part), area_(areaOf(part.mesh, body)) {
        for (Eigen::Index v = 0; v < part.mesh.V.rows(); ++v) {
            places_.insert(placeOf(part.mesh, static_cast<int>(v)));
        }
    }

    std::string run() const {
        if (body_.form == BodyForm::Unknown || area_.whole <= 0) {
            return {};
        }
        const std::string band = bandName();
        const std::string limb = band.empty() ? limbName() : band;
        const std::string front = frontName(!limb.empty());
        std::string name = sideWord();
        for (const std::string& word : {limb, front}) {
            name += name.empty() || word.empty() ? word : " " + word;
        }
        return name.empty() ? "body" : name;
    }

private:
    using Place = std::array<double, 3>;

    static Place placeOf(const MeshArrays& mesh, int v) {
        return {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)};
    }

    /// Length of an opening's rim that belongs to the part, mm.
    double lengthAt(const BodyOpening& opening) const {
        const std::vector<int>& rim = opening.loop.vertices;
        double length = 0;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const int a = rim[k], b = rim[(k + 1) % rim.size()];
            if (places_.contains(placeOf(whole_.mesh, a)) &&
                places_.contains(placeOf(whole_.mesh, b))) {
                length += (whole_.mesh.V.row(b) - whole_.mesh.V.row(a)).norm();
            }
        }
        return length;
    }

    double lengthAt(OpeningKind kind) const {
        const BodyOpening* opening = body_.find(kind);
        return opening ? lengthAt(*opening) : 0;
    }

    std::string sideWord() const {
        if (area_.left < kOnOneSide && area_.left > 1 - kOnOneSide) {
            return {};
        }
        return (area_.left > 0.5) == body_.isLeftAcross() ? "left" : "right";
    }

    /// "neck band", "cuff": a strip along an opening.
    const char* bandName() const {
        const double rim = std::max(rimLength(part_), 1e-12);
        if (2 * area_.whole / rim > kWidestBand) {
            return "";
        }
        for (const BodyOpening& opening : body_.openings) {
            if (lengthAt(opening) < kBandAtOpening * rim) {
                continue;
            }
            switch (opening.kind) {
                case OpeningKind::Neck:
                    return "neck band";
                case OpeningKind::Waist:
                    return "waistband";
                case OpeningKind::Hem:
                    return "hem band";
                case OpeningKind::Cuff:
                    return hasSleeves() ? "cuff" : "armhole band";
                case OpeningKind::Ankle:
                    return "cuff";
                case OpeningKind::Armhole:
                    return "armhole band";
                case OpeningKind::Other:
                    break;
            }
        }
        return "";
    }

    bool hasSleeves() const {
        return std::ranges::any_of(cuts_, [](const TailorCut& cut) {
            return cut.line == TailorLine::Armhole || cut.line == TailorLine::Underarm;
        });
    }

    bool isSleeve() const {
        const auto cuffs = body_.pair(OpeningKind::Cuff);
        if (!cuffs) {
            return false;
        }
        for (const TailorCut& cut : cuts_) {
            if (cut.line == TailorLine::Armhole && cut.cut.points.size() > 2 &&
                cut.side * (area_.left - 0.5) > 0 &&
                isBeyond(cut.cut.points, (*cuffs)[cut.side < 0 ? 0 : 1]->centre)) {
                return true;
            }
        }
        return std::ranges::any_of(*cuffs, [this](const BodyOpening* cuff) {
            return lengthAt(*cuff) > kAllOfCuff * cuff->loop.perimeter &&
                   lengthAt(OpeningKind::Hem) == 0 && lengthAt(OpeningKind::Neck) == 0;
        });
    }

    /// Whether the part is beyond a closed line, as seen from the middle of the garment.
    bool isBeyond(const std::vector<Eigen::Vector3d>& loop, const Eigen::Vector3d& cuff) const {
        Eigen::Vector3d middle(0, 0, 0), normal(0, 0, 0);
        for (const Eigen::Vector3d& point : loop) {
            middle += point / static_cast<double>(loop.size());
        }
        for (std::size_t k = 0; k < loop.size(); ++k) {
            normal += (loop[k] - middle).cross(loop[(k + 1) % loop.size()] - middle);
        }
        normal *= normal.dot(cuff - middle) < 0 ? -1 : 1;
        return normal.dot(area_.centre - middle) > 0;
    }

    std::string limbName() const {
        if (body_.form == BodyForm::Trousers) {
            return sideWord().empty() ? "" : "leg";
        }
        if (isSleeve()) {
            return "sleeve";
        }
        for (const TailorCut& cut : cuts_) {
            if (cut.line == TailorLine::Waist && !cut.cut.points.empty()) {
                double height = 0;
                for (const Eigen::Vector3d& point : cut.cut.points) {
                    height += body_.height(point) / static_cast<double>(cut.cut.points.size());
                }
                return body_.height(area_.centre) < height ? "skirt" : "bodice";
            }
        }
        return {};
    }

    std::string frontName(bool isLimb) const {
        const double ahead = area_.facing.dot(body_.forward);
        const double least = isLimb ? 2 * kLooksThere : kLooksThere;
        return std::abs(ahead) < least ? "" : ahead > 0 ? "front" : "back";
    }

    const Piece& whole_;
    const GarmentBody& body_;
    const std::vector<TailorCut>& cuts_;
    const Piece& part_;
    const PartArea area_;
    std::set<Place> places_;
};

}  // namespace

std::string partName(const Piece& whole, const GarmentBody& body,
                     const std::vector<TailorCut>& cuts, const Piece& part) {
    return PartNaming(whole, body, cuts, part).run();
}

}  // namespace toile
