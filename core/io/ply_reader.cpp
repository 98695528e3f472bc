// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/geometry/point_index.h"
#include "core/io/soup.h"
#include "core/io/soup_builder.h"
#include "core/io/text_cursor.h"

namespace toile::io {
namespace {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> countType;  ///< set if it is a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

/// The contents that a PLY file declares.
struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyOffset = 0;  ///< of the first byte after the header
    int bodyLine = 1;            ///< line number there
};

/// The body of a PLY file as consecutive numbers, as text or as bytes; both classes have the same
/// interface. Every type's values are exact in a double.

class PlyTextNumbers {
public:
    PlyTextNumbers(std::string_view bytes, const PlyHeader& header)
        : cursor_(bytes.substr(header.bodyOffset)),
          bodyOffset_(header.bodyOffset),
          bodyLine_(header.bodyLine) {}

    /// The next number; NaN for a word that is not a number. False at the end of the file.
    bool next(PlyType, double& value) {
        cursor_.skipSpace();
        first_ = bodyOffset_ + cursor_.offset();
        if (cursor_.atEnd()) {
            return false;
        }
        if (!cursor_.readDouble(value)) {
            value = std::numeric_limits<double>::quiet_NaN();
            unreadable_ = cursor_.token();
        }
        return true;
    }

    /// Position of the last number for messages: its line, from 1.
    int place(std::size_t) const { return bodyLine_ + cursor_.line() - 1; }

    /// Offset in the file of the last number's first byte, and of the byte after it.
    std::size_t first() const { return first_; }

    std::size_t last() const { return bodyOffset_ + cursor_.offset(); }

    /// The last word that was not a number; empty if there was none since the last call.
    std::string_view takeUnreadable() { return std::exchange(unreadable_, {}); }

private:
    TextCursor cursor_;
    std::size_t bodyOffset_;
    int bodyLine_;
    std::size_t first_ = 0;
    std::string_view unreadable_;
};

constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};  // in the order of the types

/// Bytes of a number in a binary file: 1, 2, 4 or 8.
std::size_t sizeOf(PlyType type) {
    return kSizes[static_cast<std::size_t>(type)];
}

class PlyByteNumbers {
public:
    PlyByteNumbers(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes.substr(header.bodyOffset)),
          order_(header.format == PlyFormat::BigEndian ? std::endian::big : std::endian::little) {}

    bool next(PlyType type, double& value) {
        const std::size_t size = sizeOf(type);
        if (bytes_.size() < size) {
            return false;
        }
        value = number(type);
        bytes_.remove_prefix(size);
        return true;
    }

    /// Position of the last number for messages: its record, from 1.
    int place(std::size_t record) const { return static_cast<int>(record) + 1; }

    /// Numbers in bytes have no text.
    std::size_t first() const { return 0; }

    std::size_t last() const { return 0; }

    std::string_view takeUnreadable() { return {}; }

private:
    double number(PlyType type) const {
        const char* at = bytes_.data();
        switch (type) {
            case PlyType::Int8:
                return readBytes<std::int8_t>(at, order_);
            case PlyType::UInt8:
                return readBytes<std::uint8_t>(at, order_);
            case PlyType::Int16:
                return readBytes<std::int16_t>(at, order_);
            case PlyType::UInt16:
                return readBytes<std::uint16_t>(at, order_);
            case PlyType::Int32:
                return readBytes<std::int32_t>(at, order_);
            case PlyType::UInt32:
                return readBytes<std::uint32_t>(at, order_);
            case PlyType::Float32:
                return static_cast<double>(readBytes<float>(at, order_));
            case PlyType::Float64:
                return readBytes<double>(at, order_);
        }
        return 0;
    }

    std::string_view bytes_;
    std::endian order_;
};

constexpr Word<PlyType> kTypes[] = {
    {PlyType::Int8, "char"},      {PlyType::Int8, "int8"},       {PlyType::UInt8, "uchar"},
    {PlyType::UInt8, "uint8"},    {PlyType::Int16, "short"},     {PlyType::Int16, "int16"},
    {PlyType::UInt16, "ushort"},  {PlyType::UInt16, "uint16"},   {PlyType::Int32, "int"},
    {PlyType::Int32, "int32"},    {PlyType::UInt32, "uint"},     {PlyType::UInt32, "uint32"},
    {PlyType::Float32, "float"},  {PlyType::Float32, "float32"}, {PlyType::Float64, "double"},
    {PlyType::Float64, "float64"}};
constexpr Word<PlyFormat> kFormats[] = {{PlyFormat::Ascii, "ascii"},
                                        {PlyFormat::LittleEndian, "binary_little_endian"},
                                        {PlyFormat::BigEndian, "binary_big_endian"}};

bool isWhole(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& name)
        : bytes_(bytes), name_(name), cursor_(bytes) {}

    Result<PlyHeader> read() {
        if (word() != "ply") {
            return malformed("the file does not begin with \"ply\"");
        }
        bool hasFormat = false;
        for (cursor_.nextLine(); !cursor_.atEnd(); cursor_.nextLine()) {
            const std::string_view keyword = word();
            if (keyword == "end_header") {
                if (!hasFormat) {
                    return malformed("the header states no format");
                }
                return finish();
            }
            Result<void> line;
            if (keyword == "format") {
                line = readFormat();
                hasFormat = true;
            } else if (keyword == "element") {
                line = readElement();
            } else if (keyword == "property") {
                line = readProperty();
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                line = malformed("an unknown keyword in the header");
            }
            if (!line) {
                return line.error();
            }
        }
        return malformed("the end of the header is missing");
    }

private:
    std::string_view word() {
        cursor_.skipBlanks();
        return cursor_.token();
    }

    Result<void> readFormat() {
        const auto format = parseWord(kFormats, word());
        if (!format) {
            return malformed("an unknown format");
        }
        header_.format = *format;
        return {};
    }

    Result<void> readElement() {
        PlyElement element;
        element.name = word();
        const std::string_view count = word();
        const char* end = count.data() + count.size();
        const auto [last, status] = std::from_chars(count.data(), end, element.count);
        if (count.empty() || status != std::errc() || last != end) {
            return malformed("an element has no count");
        }
        header_.elements.push_back(std::move(element));
        return {};
    }

    Result<void> readProperty() {
        std::optional<PlyType> countType;
        std::string_view type = word();
        if (type == "list") {
            countType = parseWord(kTypes, word());
            if (!countType || !isWhole(*countType)) {
                return malformed("the count of a list has no integer type");
            }
            type = word();
        }
        const std::optional<PlyType> known = parseWord(kTypes, type);
        const std::string_view name = word();
        if (!known || name.empty() || header_.elements.empty()) {
            return malformed("a property cannot be read");
        }
        header_.elements.back().properties.push_back({std::string(name), *known, countType});
        return {};
    }

    Result<PlyHeader> finish() {
        skipLastLineEnd();
        header_.bodyOffset = cursor_.offset();
        header_.bodyLine = cursor_.line();
        for (const PlyElement& element : header_.elements) {
            const std::size_t least = leastBytes(element);
            if (least > 0 && element.count > (cursor_.bytesLeft() + 1) / least) {
                return malformed("the header promises " + std::to_string(element.count) + " x \"" +
                                 element.name + "\", " + std::to_string(cursor_.bytesLeft()) +
                                 " bytes follow");
            }
        }
        return std::move(header_);
    }

    /// If lines end in CR alone, a byte 10 after the last one is data.
    void skipLastLineEnd() {
        const std::size_t firstEnd = bytes_.find_first_of("\r\n");
        const bool crAlone =
            bytes_[firstEnd] == '\r' && bytes_.substr(firstEnd + 1, 1) != std::string_view("\n");
        if (crAlone && cursor_.at('\r')) {
            cursor_.skip('\r');
        } else {
            cursor_.nextLine();
        }
    }

    /// Minimum size of one record: the bytes of its numbers, or a digit and a blank for each.
    std::size_t leastBytes(const PlyElement& element) const {
        std::size_t bytes = 0;
        for (const PlyProperty& property : element.properties) {
            bytes += header_.format == PlyFormat::Ascii
                         ? 2
                         : sizeOf(property.countType.value_or(property.type));
        }
        return bytes;
    }

    Error malformed(const std::string& what) const {
        return {ErrorCode::MalformedFile, Subject::file(name_),
                "line " + std::to_string(cursor_.line()) + ": " + what};
    }

    std::string_view bytes_;
    const std::string& name_;
    TextCursor cursor_;
    PlyHeader header_;
};

/// Reads the header. Every count is limited to the bytes after the header, so that callers can
/// reserve memory for it. `name` is the file, for messages.
/// Errors: MalformedFile, with the line.
Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace

}  // namespace toile::io

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

/// Texture coordinates by corner: u, v of the first corner, then of the next.
int cornerUvList(const io::PlyElement& face) {
    return indexOf(face, true, {"texcoord", "texture_coordinates", "tex_coords"});
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
        const auto face = std::ranges::find(header_.elements, "face", &io::PlyElement::name);
        const auto vertex = std::ranges::find(header_.elements, "vertex", &io::PlyElement::name);
        hasCornerUvs_ = face != header_.elements.end() && cornerUvList(*face) >= 0 &&
                        !(vertex != header_.elements.end() && VertexLayout(*vertex).hasUv());
        bool hasVertices = false, hasFaces = false;
        for (const io::PlyElement& element : header_.elements) {
            Result<void> done;
            if (element.name == "vertex" && !std::exchange(hasVertices, true)) {
                done = readVertices(element);
            } else {
                const bool faces = element.name == "face" && !std::exchange(hasFaces, true);
                areStrips_ = element.name == "tristrips";
                done = readFaces(element, faces || areStrips_ ? cornerList(element) : -1);
            }
            if (!done) {
                return done.error();
            }
        }
        if (hasCornerUvs_) {
            soup_.cornerUvs.resize(soup_.corners.size(), io::kNoUv);
        } else if (!soup_.uvs.empty()) {
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
            return builder_.malformed("the header lacks x, y and z of the vertices");
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
        const int uvList = hasCornerUvs_ && !areStrips_ ? cornerUvList(element) : -1;
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            bool readable = true;
            double unused = 0;
            for (int k = 0; k < static_cast<int>(element.properties.size()); ++k) {
                const io::PlyProperty& property = element.properties[static_cast<std::size_t>(k)];
                const bool isRead = k == list     ? readCorners(property, readable)
                                    : k == uvList ? readList(property, faceUvs_)
                                                  : readProperty(property, unused);
                if (!isRead) {
                    return truncated(element, i);
                }
            }
            if (list >= 0 && readable && areStrips_) {
                divideStrips(numbers_.place(i));
            } else if (list >= 0 && readable) {
                addFaceUvs(numbers_.place(i));
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
        numbers_.takeUnreadable();  // words in the record's other properties: ignored
        const bool isComplete = readList(property, indices_);
        for (const double index : indices_) {
            soup_.corners.push_back(cornerIndex(index));
        }
        readable = numbers_.takeUnreadable().empty();
        return isComplete;
    }

    bool readList(const io::PlyProperty& property, std::vector<double>& values) {
        std::size_t count = 0;
        double value = 0;
        values.clear();
        if (!readCount(property, count)) {
            return false;
        }
        for (; count > 0 && numbers_.next(property.type, value); --count) {
            values.push_back(value);
        }
        return count == 0;
    }

    /// Merges equal texture coordinates of one position, so that islands are connected by index.
    void addFaceUvs(int place) {
        if (!hasCornerUvs_) {
            return;
        }
        const auto first = static_cast<std::size_t>(soup_.faceStart.back());
        soup_.cornerUvs.resize(first, io::kNoUv);
        if (faceUvs_.size() != 2 * (soup_.corners.size() - first)) {
            builder_.counter().add(
                ErrorCode::IndexOutOfRange, "face",
                toile::translatable("without texture coordinates: their number does not fit"),
                place);
            faceUvs_.clear();
        }
        for (std::size_t k = 0; 2 * k < faceUvs_.size(); ++k) {
            const double u = faceUvs_[2 * k], v = faceUvs_[2 * k + 1];
            const auto [uv, isNew] =
                uvIndex_.insert({static_cast<double>(soup_.corners[first + k]), u, v});
            soup_.cornerUvs.push_back(uv);
            if (isNew) {
                soup_.uvs.emplace_back(u, v);
            }
        }
        soup_.cornerUvs.resize(soup_.corners.size(), io::kNoUv);
        faceUvs_.clear();
    }

    /// Divides strips of triangles: each corner makes a triangle with the two before it, every
    /// second one reversed; an index below 0 begins the next strip.
    void divideStrips(int place) {
        const auto first = static_cast<std::size_t>(soup_.faceStart.back());
        const std::vector<int> strip(soup_.corners.begin() + soup_.faceStart.back(),
                                     soup_.corners.end());
        soup_.corners.resize(first);
        for (std::size_t k = 0, begin = 0; k < strip.size(); ++k) {
            if (indices_[k] < 0) {
                begin = k + 1;
                continue;
            }
            if (k < begin + 2) {
                continue;
            }
            const bool isReversed = (k - begin) % 2 == 1;
            const int a = strip[k - 2], b = strip[k - 1], c = strip[k];
            if (a != b && b != c && c != a) {
                soup_.corners.insert(soup_.corners.end(),
                                     {isReversed ? b : a, isReversed ? a : b, c});
                builder_.endFace(place);
            }
        }
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
                                  " is incomplete or has a list with a wrong count");
    }

    const io::PlyHeader& header_;
    io::SoupBuilder& builder_;
    PolygonSoup& soup_;
    const Progress& progress_;
    Numbers numbers_;
    bool hasCornerUvs_ = false;              ///< by corner alone, not by vertex
    bool areStrips_ = false;                 ///< the faces being read are strips of triangles
    std::vector<double> indices_, faceUvs_;  ///< of the current record
    std::vector<Eigen::Vector3d> uvs_;       ///< position index, u, v
    geometry::PointIndex uvIndex_{uvs_};
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
