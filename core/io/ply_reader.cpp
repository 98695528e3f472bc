// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/ply_header.h"
#include "core/io/soup.h"
#include "core/io/soup_builder.h"

namespace toile {
namespace {

/// Index of the first property with one of the names that is (or is not) a list, or -1.
int indexOf(const io::PlyElement& element, bool list,
            std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const io::PlyProperty& property = element.properties[i];
            if (property.name == name && property.countType.has_value() == list) {
                return static_cast<int>(i);
            }
        }
    }
    return -1;
}

/// The properties of a vertex that are its coordinates.
struct VertexLayout {
    explicit VertexLayout(const io::PlyElement& vertex)
        : x(indexOf(vertex, false, {"x"})),
          y(indexOf(vertex, false, {"y"})),
          z(indexOf(vertex, false, {"z"})),
          u(indexOf(vertex, false, {"s", "u", "texture_u"})),
          v(indexOf(vertex, false, {"t", "v", "texture_v"})) {}

    bool hasPosition() const { return x >= 0 && y >= 0 && z >= 0; }

    bool hasUv() const { return u >= 0 && v >= 0; }

    bool positionLeads() const { return x == 0 && y == 1 && z == 2; }

    int x, y, z, u, v;
};

int cornerList(const io::PlyElement& face) {
    return indexOf(face, true, {"vertex_indices", "vertex_index"});
}

bool isIndex(double value) {
    return value >= 0 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
}

int cornerIndex(double value) {
    return isIndex(value) ? static_cast<int>(value) : io::kNoSuchPosition;
}

template <class Numbers>
class PlyBodyReader {
public:
    PlyBodyReader(const io::PlyHeader& header, std::shared_ptr<const std::string> bytes,
                  io::SoupBuilder& builder, const Progress& progress)
        : header_(header),
          builder_(builder),
          soup_(builder.soup()),
          progress_(progress),
          numbers_(*bytes, header) {
        if (header.format == io::PlyFormat::Ascii) {
            soup_.text = std::move(bytes);
        }
    }

    Result<PolygonSoup> read() {
        bool hasVertices = false, hasFaces = false;
        for (const io::PlyElement& element : header_.elements) {
            Result<void> done;
            if (element.name == "vertex" && !std::exchange(hasVertices, true)) {
                done = readVertices(element);
            } else {
                const bool faces = element.name == "face" && !std::exchange(hasFaces, true);
                done = readFaces(element, faces ? cornerList(element) : -1);
            }
            if (!done) {
                return done.error();
            }
        }
        if (!soup_.uvs.empty()) {
            soup_.cornerUvs = soup_.corners;
        }
        if (soup_.positionText.empty()) {
            soup_.text.reset();
        }
        return builder_.finish();
    }

private:
    Result<void> readVertices(const io::PlyElement& element) {
        const VertexLayout layout(element);
        if (!layout.hasPosition()) {
            return builder_.malformed("the header gives vertices no x, y and z");
        }
        soup_.positions.reserve(element.count);
        const bool keepText = soup_.text && layout.positionLeads();
        std::vector<double> values(element.properties.size());
        for (std::size_t i = 0; i < element.count; ++i) {
            TextSpan span;
            int line = 0;
            for (std::size_t k = 0; k < values.size(); ++k) {
                if (!readProperty(element.properties[k], values[k])) {
                    return truncated(element, i);
                }
                line = k == 0 ? numbers_.place(i) : line;
                span.offset = k == 0 ? numbers_.first() : span.offset;
                if (k == 2 && numbers_.place(i) == line) {
                    span.length = static_cast<std::uint32_t>(numbers_.last() - span.offset);
                }
            }
            addVertex(layout, values, span, keepText, numbers_.place(i));
            if (isCancelled(i)) {
                return builder_.cancelled();
            }
        }
        return {};
    }

    void addVertex(const VertexLayout& layout, const std::vector<double>& values, TextSpan span,
                   bool keepText, int place) {
        const Eigen::Vector3d position(values[layout.x], values[layout.y], values[layout.z]);
        const std::string_view unreadable = numbers_.takeUnreadable();
        if (!unreadable.empty() && position.hasNaN()) {
            builder_.addUnreadablePosition(unreadable, place);
            span = {};
        } else {
            builder_.addPosition(position, place);
        }
        if (keepText) {
            soup_.positionText.push_back(span);
        }
        if (layout.hasUv()) {
            soup_.uvs.emplace_back(values[layout.u], values[layout.v]);
        }
    }

    /// Reads the faces whose corners the given property lists; skips the element if that is -1.
    /// Records without properties take no space, whatever their count.
    Result<void> readFaces(const io::PlyElement& element, int list) {
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            bool readable = true;
            double unused = 0;
            for (int k = 0; k < static_cast<int>(element.properties.size()); ++k) {
                const io::PlyProperty& property = element.properties[static_cast<std::size_t>(k)];
                if (k == list ? !readCorners(property, readable)
                              : !readProperty(property, unused)) {
                    return truncated(element, i);
                }
            }
            if (list >= 0 && readable) {
                builder_.endFace(numbers_.place(i));
            } else if (list >= 0) {
                builder_.dropUnreadableFace(numbers_.place(i));
            }
            if (isCancelled(i)) {
                return builder_.cancelled();
            }
        }
        return {};
    }

    bool readCorners(const io::PlyProperty& property, bool& readable) {
        std::size_t count = 0;
        double index = 0;
        numbers_.takeUnreadable();  // words in the record's other properties: ignored
        if (!readCount(property, count)) {
            return false;
        }
        for (; count > 0 && numbers_.next(property.type, index); --count) {
            soup_.corners.push_back(cornerIndex(index));
        }
        readable = numbers_.takeUnreadable().empty();
        return count == 0;
    }

    /// A plain number, or a list, which is skipped.
    bool readProperty(const io::PlyProperty& property, double& value) {
        if (!property.countType) {
            return numbers_.next(property.type, value);
        }
        std::size_t count = 0;
        if (!readCount(property, count)) {
            return false;
        }
        while (count > 0 && numbers_.next(property.type, value)) {
            --count;
        }
        return count == 0;
    }

    /// Number of entries of a list; false if it cannot be read, as the following data is then lost.
    bool readCount(const io::PlyProperty& property, std::size_t& count) {
        double value = 0;
        if (!numbers_.next(*property.countType, value) || !isIndex(value)) {
            return false;
        }
        count = static_cast<std::size_t>(value);
        return true;
    }

    bool isCancelled(std::size_t record) const {
        return record % io::kRecordsPerCancelCheck == 0 && progress_.isCancelled();
    }

    Error truncated(const io::PlyElement& element, std::size_t record) const {
        return builder_.malformed("\"" + element.name + "\" " + std::to_string(record + 1) +
                                  " of " + std::to_string(element.count) +
                                  " breaks off or has a list without a proper count");
    }

    const io::PlyHeader& header_;
    io::SoupBuilder& builder_;
    PolygonSoup& soup_;
    const Progress& progress_;
    Numbers numbers_;
};

}  // namespace

Result<PolygonSoup> readPly(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress) {
    const Result<io::PlyHeader> header = io::readPlyHeader(*text, name);
    if (!header) {
        return header.error();
    }
    const bool ascii = header->format == io::PlyFormat::Ascii;
    io::SoupBuilder builder(name, ascii ? "line" : "record");
    return ascii ? PlyBodyReader<io::PlyTextNumbers>(*header, std::move(text), builder, progress)
                       .read()
                 : PlyBodyReader<io::PlyByteNumbers>(*header, std::move(text), builder, progress)
                       .read();
}

}  // namespace toile
