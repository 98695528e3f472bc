// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

struct DxfTag {
    int code;
    std::string value;
};

struct DxfPolyline {
    std::string layer;
    bool closed = false;
    std::vector<Eigen::RowVector2d> points;
    Points2 matrix() const;
};

struct DxfText {
    std::string layer, value;
    double height = 0;
    Eigen::Vector2d middle;  ///< of its baseline
};

/// As much of a DXF as a cutter needs; written apart from the writer, by the published group codes.
struct DxfFile {
    explicit DxfFile(const std::string& bytes);

    std::vector<std::string> faults;  ///< what breaks the format
    std::map<std::string, std::vector<DxfTag>> header;
    std::map<std::string, int> layers;  ///< name to colour
    int blocks = 0;
    std::vector<DxfPolyline> polylines;
    std::vector<DxfText> texts;

private:
    void readTags(const std::string& bytes);
    void readTag(const DxfTag& tag);
    std::vector<DxfTag> tags_;
    std::string section_, table_, entity_, variable_, layerName_;
};

}  // namespace toile::test
