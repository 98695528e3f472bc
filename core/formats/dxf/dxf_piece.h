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

#include "core/formats/dxf/dxf_document.h"
#include "core/formats/pattern_file.h"

namespace toile {

/// Contents of a layer in a DXF pattern, by AAMA's and ASTM's numbers or by its name.
enum class DxfRole {
    Other,
    Known,  ///< redundant with other layers: turn and curve points, the check square
    Cut,
    Sew,
    Internal,
    CutOut,
    Notch,
    Drill,
    Grain,
    Fold,
    Text,
    FineCut,  ///< quality lines (and the next): the same line with other points
    FineSew,
    FineInternal,
    FineCutOut,
};

DxfRole dxfRole(std::string_view layer);

/// Splits "Piece Name: front" into "piece name" and "front"; none if the text has no such form.
struct DxfField {
    std::string key{};  ///< lower case, without blanks around it
    std::string value{};
};
std::optional<DxfField> dxfField(std::string_view text);

/// Fields of texts by key; the first one with each key.
using DxfFields = std::map<std::string, std::string>;
DxfFields dxfFields(const std::vector<DxfEntity>& entities);

/// Placement of a block in the plane, mm.
struct DxfPlace {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    double scale = 1;  ///< of lengths
};

/// The piece described by the entities of one block, unfolded. No points if it has no outline.
/// @param notes  receives notes on omitted or corrected parts, with the piece's name
/// Cost: about n log n in the points. Pure except for the notes.
FilePiece dxfPiece(const std::vector<DxfEntity>& entities, const DxfPlace& place,
                   std::vector<Wording>& notes);

/// Layers of lines, keyed by the coordinates of each of their two ends.
using DxfLayersAt = std::map<std::pair<double, double>, std::string_view>;

/// The lines with this role, mm, joined where their ends meet; internal lines are not joined.
/// @param layers  if given, receives the layers of the lines
std::vector<FileLine> dxfLines(const std::vector<DxfEntity>& entities, DxfRole role,
                               const DxfPlace& place, DxfLayersAt* layers = nullptr);

/// Position of a point of an entity, mm.
inline Eigen::Vector2d placedPoint(const DxfEntity& entity, const Eigen::Vector2d& point,
                                   const DxfPlace& place) {
    return place.map * (entity.map * point);
}

/// Counts omitted entities by kind.
class DxfLeftOut {
public:
    enum Reason { KindNotRead, LayerNotRead, InNoPiece, InsertedAgain };
    void add(Reason reason, const DxfEntity& entity);
    /// Adds entities of kinds that Toile does not read, and entities on layers of these roles.
    void addUnread(const std::vector<DxfEntity>& entities, const std::set<DxfRole>& roles);
    /// Adds a note for each reason.
    void tell(std::vector<Wording>& notes) const;

private:
    std::map<Reason, std::map<std::string, long long>> counts_;
};

/// Ends of lines closer than this are joined, for entities of this extent, mm.
double dxfNearness(double extent);

}  // namespace toile
