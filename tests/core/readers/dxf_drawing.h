// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/dxf/dxf_document.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A DXF file as lines, records and texts, in millimetres.

struct DxfLine {
    std::string_view layer{};
    Points2 points = Points2(0, 2);  ///< mm
    bool closed = false;
};

/// A POINT, which pattern programs use as a record.
struct DxfRecord {
    std::string_view layer{};
    Eigen::Vector2d point{0, 0};     ///< mm
    std::optional<double> height{};  ///< code 30, mm
    std::optional<double> width{};   ///< code 39, mm
    std::optional<double> angle{};   ///< code 50, radians
};

/// What lies in a block, or on the page.
struct DxfGroupOfEntities {
    std::string_view name{};           ///< of the block
    std::vector<DxfLine> polylines{};  ///< and curves, in their order
    std::vector<DxfLine> lines{};      ///< LINE: two points
    std::vector<DxfRecord> records{};
    std::vector<std::string_view> texts{};
    /// Of texts "Key: value": by key in lower case, of several the first.
    std::map<std::string, std::string_view> said{};
    /// Names of inserted blocks, and where they are.
    std::vector<std::pair<std::string_view, Eigen::Vector2d>> inserts{};
};

struct DxfDrawing {
    std::vector<DxfGroupOfEntities> blocks{};
    DxfGroupOfEntities page{};
};

/// Refers to the bytes that the document does. Entities without finite coordinates are left out.
/// @param unit  of the file, mm  Cost: linear. Pure.
DxfDrawing dxfDrawing(const DxfDocument& document, double unit);

}  // namespace toile
