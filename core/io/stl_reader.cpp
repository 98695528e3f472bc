// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/geometry/point_index.h"
#include "core/io/soup.h"
#include "core/io/soup_builder.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

// A binary file: 80 bytes of any content, the number of facets, then 50 bytes each (normal, three
// corners, two bytes more).
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kCornerBytes = 12;

std::uint32_t promisedFacets(const std::string& bytes) {
    return io::readBytes<std::uint32_t>(bytes.data() + 80, std::endian::little);
}

/// Decided by the size, as some binary files begin with "solid" too. A file that does not may have
/// further bytes after its facets.
bool isBinary(const std::string& bytes) {
    if (bytes.size() < kHeaderBytes) {
        return false;
    }
    if (bytes.size() == kHeaderBytes + kFacetBytes * std::size_t{promisedFacets(bytes)}) {
        return true;
    }
    io::TextCursor cursor(bytes);
    cursor.skipSpace();
    return !equalsIgnoringCase(cursor.token().substr(0, 5), "solid");
}

Eigen::Vector3d positionAt(const char* bytes) {
    const auto number = [bytes](std::size_t axis) {
        return static_cast<double>(
            io::readBytes<float>(bytes + sizeof(float) * axis, std::endian::little));
    };
    return {number(0), number(1), number(2)};
}

class StlReader {
public:
    StlReader(std::shared_ptr<const std::string> bytes, const std::string& name,
              std::string_view placeWord)
        : file_(std::move(bytes)),
          bytes_(*file_),
          builder_(name, placeWord),
          soup_(builder_.soup()),
          index_(soup_.positions) {}

    Result<PolygonSoup> readBinary(const Progress& progress) {
        const std::size_t count = promisedFacets(bytes_);
        const std::size_t there = (bytes_.size() - kHeaderBytes) / kFacetBytes;
        if (count > there) {
            return builder_.malformed("byte 80: " + std::to_string(count) +
                                      " facets promised, but the file ends after " +
                                      std::to_string(there));
        }
        soup_.corners.reserve(3 * count);
        soup_.faceStart.reserve(count + 1);
        const char* facet = bytes_.data() + kHeaderBytes;
        for (std::size_t i = 0; i < count; ++i, facet += kFacetBytes) {
            if (i % io::kRecordsPerCancelCheck == 0 && progress.isCancelled()) {
                return builder_.cancelled();
            }
            const int place = static_cast<int>(i) + 1;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                addCorner(positionAt(facet + kNormalBytes + kCornerBytes * corner), place);
            }
            builder_.endFace(place);
        }
        return builder_.finish();
    }

    Result<PolygonSoup> readAscii(const Progress& progress) {
        io::TextCursor cursor(bytes_);
        cursor.skipSpace();
        if (!equalsIgnoringCase(cursor.token(), "solid")) {
            return builder_.malformed(
                "line 1: the file neither begins with \"solid\" nor has the "
                "size of a binary STL file");
        }
        cursor.nextLine();
        int words = 0;
        for (cursor.skipSpace(); !cursor.atEnd(); cursor.skipSpace()) {
            if (++words % io::kRecordsPerCancelCheck == 0 && progress.isCancelled()) {
                return builder_.cancelled();
            }
            readWord(cursor);
        }
        dropOpenFacet(cursor.line());
        return builder_.finish();
    }

private:
    void readWord(io::TextCursor& cursor) {
        const std::string_view word = cursor.token();
        if (equalsIgnoringCase(word, "vertex")) {
            readVertex(cursor);
        } else if (equalsIgnoringCase(word, "endloop")) {
            builder_.endFace(cursor.line());
        } else if (equalsIgnoringCase(word, "facet")) {
            dropOpenFacet(cursor.line());
        } else if (equalsIgnoringCase(word, "solid") || equalsIgnoringCase(word, "endsolid")) {
            cursor.nextLine();  // the name may hold any word
        }
    }

    void readVertex(io::TextCursor& cursor) {
        const std::string_view text = cursor.restOfLine();
        Eigen::Vector3d position;
        if (cursor.readDoubles(position.data(), 3)) {
            addCorner(position, cursor.line());
        } else {
            soup_.corners.push_back(static_cast<int>(soup_.positions.size()));
            builder_.addUnreadablePosition(text, cursor.line());
        }
    }

    void addCorner(const Eigen::Vector3d& position, int place) {
        const auto [index, isNew] = index_.insert(position);
        soup_.corners.push_back(index);
        if (isNew) {
            builder_.noteNonFinite(position, place);
        }
    }

    /// Drops a facet that was begun and not ended.
    void dropOpenFacet(int line) {
        if (static_cast<int>(soup_.corners.size()) > soup_.faceStart.back()) {
            builder_.dropUnreadableFace(line);
        }
    }

    std::shared_ptr<const std::string> file_;
    const std::string& bytes_;
    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    geometry::PointIndex index_;
};

}  // namespace

Result<PolygonSoup> readStl(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress) {
    return isBinary(*text) ? StlReader(std::move(text), name, "facet").readBinary(progress)
                           : StlReader(std::move(text), name, "line").readAscii(progress);
}

}  // namespace toile
