// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/formats/pattern_file.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A DXF file (ASCII, R12 and later) as its entities, not yet interpreted.

/// A group code and its value, without blanks around it.
struct DxfGroup {
    int code = 0;
    std::string_view value{};  ///< UTF-8, without escapes such as \U+00E9 or %%d

    std::optional<double> number() const;
};

struct DxfEntity {
    std::string_view kind{};   ///< "POLYLINE", "TEXT"
    std::string_view layer{};  ///< empty if the file names no layer
    std::vector<DxfGroup> groups{};
    Points2 points = Points2(0, 2);  ///< vertices of POLYLINE and LWPOLYLINE
    std::vector<double> bulges{};    ///< of the edge after each vertex, tan(angle / 4) of its arc
    Points2 frame = Points2(0, 2);   ///< control points of a spline-fit POLYLINE
    bool closed = false;             ///< of POLYLINE and LWPOLYLINE
    /// From the entity's coordinates to those of the drawing or block, by its extrusion direction
    /// and the INSERTs it came through. Zero if it lies in a tilted plane.
    Eigen::Affine2d map = Eigen::Affine2d::Identity();

    /// The first group with this code.
    std::optional<double> number(int code) const;
    std::string_view text(int code) const;
    /// Codes `first` and `first` + 10; none if either is missing or not finite.
    std::optional<Eigen::Vector2d> point(int first = 10) const;
};

struct DxfBlock {
    std::string_view name{};
    Eigen::Vector2d base{0, 0};
    std::vector<DxfEntity> entities{};
};

/// Points into the bytes that were read, and into `decoded`.
struct DxfDocument {
    /// By "$NAME": the groups of each variable.
    std::map<std::string_view, std::vector<DxfGroup>> header{};
    std::map<std::string_view, int> layers{};  ///< LAYER table: name to colour
    std::vector<DxfBlock> blocks{};
    std::vector<DxfEntity> entities{};
    bool hasEnd = false;              ///< EOF
    std::string_view decimalComma{};  ///< a number with one; empty: none
    std::vector<Wording> notes{};     ///< on the code page
    std::shared_ptr<std::deque<std::string>> decoded{};
};

/// Replaces INSERTs by the entities of their blocks.
class DxfBlockInserter {
public:
    explicit DxfBlockInserter(const DxfDocument& document);

    /// The entities, with every INSERT replaced by transformed copies of its block's entities;
    /// those on layer 0 take the layer of the INSERT. INSERTs of blocks that are not in the file
    /// stay as `kMissingBlock`; as they are stay those beyond 16 levels or 50 000 copies, which all
    /// calls share.
    std::vector<DxfEntity> replaced(const std::vector<DxfEntity>& entities);

    static constexpr std::string_view kMissingBlock = "INSERT of a block that is not in the file";

private:
    void add(const std::vector<DxfEntity>& entities, const Eigen::Affine2d& map,
             std::string_view layer, int level);
    bool isFull() const;

    std::map<std::string_view, const DxfBlock*> blocks_;
    std::vector<DxfEntity> placed_;
    std::size_t copies_ = 0;  ///< of entities and blocks
};

/// Map from the coordinates of a block to those of the drawing it is inserted in. Pure.
Eigen::Affine2d insertionOf(const DxfBlock& block, const DxfEntity& insert);

/// Reads text as UTF-8 if it is valid UTF-8, else by $DWGCODEPAGE; adds a note if neither works.
/// @param bytes  must outlive the document
/// Errors: MalformedFile with the line (no pairs of code and value, a binary file, no ENTITIES and
/// no BLOCKS). Vertices that are not finite are left out. Cost: linear. Pure.
Result<DxfDocument> readDxfDocument(std::string_view bytes);

/// The unit of a DXF pattern and its source. By the standard "Units: METRIC" means millimetres and
/// ENGLISH inches, but files in centimetres say METRIC too, and $INSUNITS is often wrong. So the
/// stated unit is used only if it gives the largest piece a plausible size; otherwise the size
/// decides. `reason` names any doubt.
struct DxfUnit {
    LengthUnit unit = LengthUnit::Millimetre;
    Wording reason{};
    bool inDoubt = false;
};

/// The unit that $INSUNITS names; none if it is missing or unknown.
std::optional<LengthUnit> headerUnit(const DxfDocument& document);

/// @param units   the value of the text "Unit", which Toile writes, or else "Units"; or empty
/// @param extent  of the largest piece, in the file's unit; 0 if unknown
DxfUnit dxfUnit(const DxfDocument& document, const std::string& units, double extent);

}  // namespace toile
