// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A DXF file (ASCII, R12 and later) as its entities, before anybody says what they mean.

/// A group code and its value, without blanks around it.
struct DxfGroup {
    int code = 0;
    std::string_view value{};  ///< of the bytes read

    std::optional<double> number() const;
};

struct DxfEntity {
    std::string_view kind{};   ///< "POLYLINE", "TEXT"
    std::string_view layer{};  ///< empty where none is named
    std::vector<DxfGroup> groups{};
    Points2 points = Points2(0, 2);  ///< of POLYLINE and LWPOLYLINE
    bool closed = false;             ///< likewise

    /// The first group with this code.
    std::optional<double> number(int code) const;
    std::string_view text(int code) const;
    /// Codes `first` and `first` + 10; none where one of them is no finite number.
    std::optional<Eigen::Vector2d> point(int first = 10) const;
};

struct DxfBlock {
    std::string_view name{};
    Eigen::Vector2d base{0, 0};
    std::vector<DxfEntity> entities{};
};

/// Refers to the bytes that were read.
struct DxfDocument {
    /// By "$NAME": the groups of each variable.
    std::map<std::string_view, std::vector<DxfGroup>> header{};
    std::map<std::string_view, int> layers{};  ///< of the LAYER table: name to colour
    std::vector<DxfBlock> blocks{};
    std::vector<DxfEntity> entities{};
    bool hasEnd = false;  ///< EOF
};

/// @param bytes  must outlive the document
/// Errors: MalformedFile with the line (no pairs of code and value, a binary file, no ENTITIES and
/// no BLOCKS). Vertices that are no finite numbers are left out. Cost: linear. Pure.
Result<DxfDocument> readDxfDocument(std::string_view bytes);

}  // namespace toile
