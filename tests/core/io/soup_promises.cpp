// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/io/soup_promises.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace toile::test {
namespace {

/// True where every index is one of `count` entries, or -1 where that is allowed.
bool inRange(const std::vector<int>& indices, int least, std::size_t count) {
    return std::all_of(indices.begin(), indices.end(), [least, count](int index) {
        return index >= least && index < static_cast<int>(count);
    });
}

bool facesAreValid(const PolygonSoup& soup) {
    const auto& start = soup.faceStart;
    if (start.empty() || start.front() != 0 ||
        start.back() != static_cast<int>(soup.corners.size())) {
        return false;
    }
    for (int face = 0; face < soup.faceCount(); ++face) {
        if (soup.cornerCount(face) < 3) {
            return false;
        }
    }
    return true;
}

bool namesAreValid(const std::vector<int>& perFace, const std::vector<std::string>& names,
                   int faceCount) {
    return perFace.size() == (names.empty() ? 0U : static_cast<std::size_t>(faceCount)) &&
           inRange(perFace, -1, names.size());
}

bool textIsValid(const PolygonSoup& soup) {
    if (soup.positionText.empty()) {
        return true;
    }
    if (!soup.text || soup.positionText.size() != soup.positions.size()) {
        return false;
    }
    const std::size_t size = soup.text->size();
    return std::all_of(soup.positionText.begin(), soup.positionText.end(), [size](TextSpan span) {
        return span.offset <= size && span.length <= size - span.offset;
    });
}

}  // namespace

std::string brokenPromise(const PolygonSoup& soup) {
    if (!facesAreValid(soup)) {
        return "a face has fewer than three corners, or faceStart does not fit the corners";
    }
    if (!inRange(soup.corners, 0, soup.positions.size())) {
        return "a corner's position index is out of range";
    }
    if (soup.cornerUvs.size() != (soup.uvs.empty() ? 0U : soup.corners.size())) {
        return "the corners' uv indices are not as many as the corners";
    }
    if (!inRange(soup.cornerUvs, -1, soup.uvs.size())) {
        return "a corner's uv index is out of range";
    }
    if (!namesAreValid(soup.faceObject, soup.objects, soup.faceCount()) ||
        !namesAreValid(soup.faceGroup, soup.groups, soup.faceCount()) ||
        !namesAreValid(soup.faceMaterial, soup.materials, soup.faceCount())) {
        return "a face's name is out of range, or not every face has one";
    }
    if (!textIsValid(soup)) {
        return "a position's text lies outside of the file";
    }
    return "";
}

}  // namespace toile::test
