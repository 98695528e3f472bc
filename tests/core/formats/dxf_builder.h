// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/text.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// DXF files for tests, as other programs write them: `DxfBuilder` is filled from the top
/// downwards.
class DxfBuilder {
public:
    DxfBuilder& tag(int code, std::string_view value) {
        out_ += std::to_string(code) + "\r\n" + std::string(value) + "\r\n";
        return *this;
    }
    DxfBuilder& number(int code, double value) { return tag(code, fixed(value, 6)); }
    DxfBuilder& section(std::string_view name) { return tag(0, "SECTION").tag(2, name); }
    DxfBuilder& end() { return tag(0, "ENDSEC"); }
    DxfBuilder& at(double x, double y) { return number(10, x).number(20, y); }

    DxfBuilder& block(std::string_view name, double x = 0, double y = 0) {
        return tag(0, "BLOCK").tag(8, "1").tag(2, name).tag(70, "64").at(x, y);
    }
    DxfBuilder& endBlock() { return tag(0, "ENDBLK"); }

    DxfBuilder& text(std::string_view text, std::string_view layer = "1") {
        return tag(0, "TEXT").tag(8, layer).at(0, 0).tag(1, text);
    }

    DxfBuilder& polyline(std::string_view layer, const Points2& points, bool closed) {
        tag(0, "POLYLINE").tag(8, layer).tag(66, "1").tag(70, closed ? "1" : "0");
        for (const auto& row : points.rowwise()) {
            tag(0, "VERTEX").tag(8, layer).at(row.x(), row.y());
        }
        return tag(0, "SEQEND");
    }

    DxfBuilder& line(std::string_view layer, double x, double y, double toX, double toY) {
        return tag(0, "LINE").tag(8, layer).at(x, y).number(11, toX).number(21, toY);
    }

    DxfBuilder& point(std::string_view layer, double x, double y) {
        return tag(0, "POINT").tag(8, layer).at(x, y);
    }

    DxfBuilder& insert(std::string_view name, double x = 0, double y = 0) {
        return tag(0, "INSERT").tag(8, "1").tag(2, name).at(x, y);
    }

    std::string take() { return out_ + "0\r\nEOF\r\n"; }

private:
    std::string out_;
};

}  // namespace toile::test
