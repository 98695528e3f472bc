// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace toile::bench {

struct PlanePoint {
    double x = 0, y = 0;
};

enum class Marker { Disk, Square, Diamond, Triangle, Cross, Ring };

/// The elements of a picture in SVG, y down, one after the other. A kind is the CSS class of an
/// element.
class SvgPicture {
public:
    void line(const char* kind, PlanePoint a, PlanePoint b);
    /// @param more  further attributes, each with a blank before it
    void text(const char* kind, PlanePoint at, const std::string& words,
              const std::string& more = {});
    void curve(const std::vector<PlanePoint>& points, const std::string& colour);
    void marker(Marker marker, PlanePoint at, const std::string& colour);

    const std::string& written() const { return written_; }

private:
    std::string written_;
};

}  // namespace toile::bench
