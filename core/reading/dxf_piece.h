// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/reading/dxf_document.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// What a layer of a pattern in DXF holds, by AAMA's and ASTM's numbers or by its name.
enum class DxfRole {
    Other,
    Known,  ///< says nothing that is not in other layers: turn and curve points, the check square
    Cut,
    Sew,
    Internal,
    CutOut,
    Notch,
    Drill,
    Grain,
    Fold,
    Text,
    FineCut,  ///< quality lines: the same line with other points, as the next
    FineSew,
    FineInternal,
    FineCutOut,
};

DxfRole dxfRole(std::string_view layer);

/// "Piece Name: front" as "piece name" and "front"; none where it has no such form.
struct DxfField {
    std::string key{};  ///< lower case, without blanks around it
    std::string value{};
};
std::optional<DxfField> dxfField(std::string_view text);

/// The fields of texts by their keys, the first of each.
using DxfFields = std::map<std::string, std::string>;
DxfFields dxfFields(const std::vector<DxfEntity>& entities);

/// How the coordinates of a block come to lie in the plane, mm.
struct DxfPlace {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    double scale = 1;  ///< of lengths
};

/// A piece of the entities of one block; its fold undone. Without an outline it has no points.
/// @param notes  what was left out or put right is added, with the piece's name
/// Cost: about n log n in the points. Pure but for the notes.
FilePiece dxfPiece(const std::vector<DxfEntity>& entities, const DxfPlace& place,
                   std::vector<Wording>& notes);

/// The layers of lines, by the places of their two ends.
using DxfLayersAt = std::map<std::pair<double, double>, std::string_view>;

/// The lines of these entities in a role, mm, joined where their ends meet; internal lines are not.
/// @param layers  if given, those of the lines are added
std::vector<FileLine> dxfLines(const std::vector<DxfEntity>& entities, DxfRole role,
                               const DxfPlace& place, DxfLayersAt* layers = nullptr);

/// Where a point of an entity lies, mm.
inline Eigen::Vector2d placedPoint(const DxfEntity& entity, const Eigen::Vector2d& point,
                                   const DxfPlace& place) {
    return place.map * (entity.map * point);
}

/// Entities that are left out, counted by kind.
class DxfLeftOut {
public:
    enum Reason { KindNotRead, LayerNotRead, InNoPiece };
    void add(Reason reason, const DxfEntity& entity);
    /// Those whose kind is not read, and those on layers of these roles.
    void addUnread(const std::vector<DxfEntity>& entities, const std::set<DxfRole>& roles);
    /// Adds a note for each reason.
    void tell(std::vector<Wording>& notes) const;

private:
    std::map<Reason, std::map<std::string, long long>> counts_;
};

/// How far apart the ends of lines may be that are one, for entities of this extent, mm.
double dxfNearness(double extent);

}  // namespace toile
