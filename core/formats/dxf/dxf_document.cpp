// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/formats/dxf/dxf_text.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

constexpr double kFarthestFactor = 1e9;            // of an INSERT
constexpr std::size_t kMaxInserted = 50000;        // copies of entities and blocks
constexpr int kMaxLevels = 16, kMaxRepeats = 500;  // nesting of blocks; rows, columns
constexpr long kFrameVertex = 16;                  // flag of a spline's control point
constexpr long kExternal = 4 | 8;                  // flags of a block: a reference, an overlay
constexpr double kUpright = 1e-6;  // largest tilt of an extrusion direction from the z axis

std::optional<double> parsedNumber(std::string_view text) {
    text.remove_prefix(!text.empty() && text.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Reads the pairs of code and value of a file in order.
class Groups {
public:
    explicit Groups(std::string_view bytes) : rest_(bytes) {}

    /// The next pair; none at the end or at a malformed pair (`fault`).
    std::optional<DxfGroup> next() {
        if (rest_.empty() || fault_) {
            return {};
        }
        const std::string_view code = line();
        DxfGroup group;
        const auto [end, error] =
            std::from_chars(code.data(), code.data() + code.size(), group.code);
        if (error != std::errc() || end != code.data() + code.size() || code.empty()) {
            fault_ = !code.empty() || !trimmed(rest_).empty();  // blank lines may end a file
            return {};
        }
        group.value = line();
        return group;
    }

    bool fault() const { return fault_; }
    int lineNumber() const { return line_; }

private:
    std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_;
        return trimmed(text);
    }

    std::string_view rest_;
    int line_ = 0;
    bool fault_ = false;
};

/// Builds the document pair by pair: an entity lasts until the next pair of code 0.
class DocumentBuilder {
public:
    /// @param decoded  stores values that differ from the bytes in the file
    explicit DocumentBuilder(std::shared_ptr<std::deque<std::string>> decoded) {
        document_.decoded = std::move(decoded);
    }

    void take(DxfGroup group) {
        if (group.code > 0 && group.code < 9 && hasDxfEscapes(group.value)) {
            group.value = document_.decoded->emplace_back(withoutDxfEscapes(group.value));
        }
        if (group.code >= 10 && group.code < 60 && io::hasDecimalComma(group.value)) {
            document_.decimalComma = group.value;
        }
        if (group.code == 0) {
            finish();
            begin(group.value);
        } else if (isSectionName_ && group.code == 2) {
            section_ = group.value;
            isSectionName_ = false;
        } else if (section_ == "HEADER" && group.code == 9) {
            variable_ = group.value;
            document_.header[variable_];
        } else if (section_ == "HEADER") {
            if (!variable_.empty()) {
                document_.header[variable_].push_back(group);
            }
        } else {
            entity_.groups.push_back(group);
        }
    }

    DxfDocument taken() {
        finish();
        if (isInPolyline_) {
            endPolyline(*place());
        }
        return std::move(document_);
    }

private:
    void begin(std::string_view kind) {
        if (isInPolyline_ && kind != "VERTEX") {
            endPolyline(*place());  // before a new section or block changes place()
        }
        entity_ = {};
        entity_.kind = kind;
        isSectionName_ = kind == "SECTION";
        document_.hasEnd |= kind == "EOF";
        if (kind == "ENDSEC") {
            section_ = variable_ = {};
        }
    }

    /// The list that receives entities; null outside of blocks and entities.
    std::vector<DxfEntity>* place() {
        if (section_ == "ENTITIES") {
            return &document_.entities;
        }
        return section_ == "BLOCKS" && isInBlock_ ? &document_.blocks.back().entities : nullptr;
    }

    void finish() {
        const std::string_view kind = entity_.kind;
        if (kind == "MTEXT") {
            for (DxfGroup& group : entity_.groups) {
                if (group.code == 1 && group.value.find_first_of("\\{}") != std::string::npos) {
                    group.value = document_.decoded->emplace_back(plainMText(group.value));
                }
            }
        }
        entity_.layer = entity_.text(8);
        if (section_ == "TABLES" && kind == "LAYER" && !entity_.text(2).empty()) {
            const double colour = entity_.number(62).value_or(7);
            document_.layers[entity_.text(2)] =
                static_cast<int>(std::clamp(std::abs(colour), 0.0, 256.0));
        } else if (section_ == "BLOCKS" && kind == "BLOCK") {
            document_.blocks.push_back(
                {entity_.text(2), entity_.point().value_or(Eigen::Vector2d(0, 0)), {}});
            isInBlock_ = true;
            isExternal_ = (flagsOf(entity_) & kExternal) != 0;
        } else if (section_ == "BLOCKS" && kind == "ENDBLK") {
            isInBlock_ = false;
            if (isExternal_ && !document_.blocks.empty() &&
                document_.blocks.back().entities.empty()) {
                document_.blocks.pop_back();  // its entities are in another file
            }
            isExternal_ = false;
        } else if (std::vector<DxfEntity>* const there = place(); there && kind != "SECTION") {
            add(*there);
        }
        entity_ = {};
    }

    void add(std::vector<DxfEntity>& there) {
        if (entity_.kind == "VERTEX" && isInPolyline_) {
            const auto vertex = entity_.point();
            if (vertex && (flagsOf(entity_) & kFrameVertex) != 0) {
                frame_.push_back(*vertex);
            } else if (vertex) {
                addVertex(*vertex, entity_.number(42).value_or(0));
            }
            return;
        }
        if (entity_.kind == "SEQEND" || entity_.kind.empty()) {
            return;
        }
        isInPolyline_ = entity_.kind == "POLYLINE";
        if (entity_.kind == "LWPOLYLINE") {
            readLightVertices();
        }
        entity_.closed =
            (isInPolyline_ || entity_.kind == "LWPOLYLINE") && (flagsOf(entity_) & 1) != 0;
        readPlane();
        there.push_back(std::move(entity_));
        if (there.back().kind == "LWPOLYLINE") {
            endPolyline(there);
        }
    }

    static long flagsOf(const DxfEntity& entity) {
        return static_cast<long>(std::clamp(entity.number(70).value_or(0), 0.0, 65535.0));
    }

    /// Sets the map of planar entities by the arbitrary axis algorithm of the DXF reference: for an
    /// upside-down plane the x axis is reversed.
    void readPlane() {
        static constexpr std::string_view kPlanar[] = {"POLYLINE", "LWPOLYLINE", "ARC",    "CIRCLE",
                                                       "INSERT",   "TEXT",       "ELLIPSE"};
        if (std::ranges::find(kPlanar, entity_.kind) == std::end(kPlanar)) {
            return;
        }
        const Eigen::Vector3d normal(entity_.number(210).value_or(0),
                                     entity_.number(220).value_or(0),
                                     entity_.number(230).value_or(1));
        if (normal.head<2>().norm() > kUpright * std::abs(normal.z())) {
            entity_.map.linear().setZero();
        } else if (normal.z() < 0 && entity_.kind != "ELLIPSE") {  // it uses world axes
            entity_.map.linear()(0, 0) = -1;
        }
    }

    void addVertex(const Eigen::Vector2d& vertex, double bulge) {
        vertices_.push_back(vertex);
        bulges_.push_back(bulge);
    }

    void readLightVertices() {
        double x = std::nan("");
        bool isVertex = false;  // the last point was a vertex; a bulge belongs to it
        for (const DxfGroup& group : entity_.groups) {
            if (group.code == 10) {
                x = group.number().value_or(std::nan(""));
            } else if (group.code == 20) {
                const auto y = group.number();
                isVertex = y && std::isfinite(x);
                if (isVertex) {
                    addVertex(Eigen::Vector2d(x, *y), 0);
                }
                x = std::nan("");
            } else if (group.code == 42 && isVertex) {
                bulges_.back() = group.number().value_or(0);
            }
        }
    }

    static Points2 taken(std::vector<Eigen::Vector2d>& vertices) {
        Points2 points(static_cast<Eigen::Index>(vertices.size()), 2);
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            points.row(static_cast<Eigen::Index>(k)) = vertices[k].transpose();
        }
        vertices.clear();
        return points;
    }

    /// Completes the polyline, once all its vertices are read.
    void endPolyline(std::vector<DxfEntity>& there) {
        isInPolyline_ = false;
        there.back().points = taken(vertices_);
        there.back().frame = taken(frame_);
        there.back().bulges = std::exchange(bulges_, {});
    }

    DxfDocument document_;
    DxfEntity entity_{};
    std::vector<Eigen::Vector2d> vertices_, frame_;
    std::vector<double> bulges_;
    std::string_view section_, variable_;
    bool isSectionName_ = false, isInBlock_ = false, isInPolyline_ = false, isExternal_ = false;
};

Error malformedDxf(const Wording& what) {
    return {ErrorCode::MalformedFile, {}, what};
}

}  // namespace

std::optional<double> DxfGroup::number() const {
    return parsedNumber(value);
}

std::optional<double> DxfEntity::number(int code) const {
    const auto found = std::ranges::find(groups, code, &DxfGroup::code);
    return found == groups.end() ? std::nullopt : found->number();
}

std::string_view DxfEntity::text(int code) const {
    const auto found = std::ranges::find(groups, code, &DxfGroup::code);
    return found == groups.end() ? std::string_view() : found->value;
}

std::optional<Eigen::Vector2d> DxfEntity::point(int first) const {
    const auto x = number(first), y = number(first + 10);
    return x && y ? std::optional(Eigen::Vector2d(*x, *y)) : std::nullopt;
}

Eigen::Affine2d insertionOf(const DxfBlock& block, const DxfEntity& insert) {
    const auto factor = [&insert](int code) {
        const double value = insert.number(code).value_or(1);
        return value != 0 && std::abs(value) < kFarthestFactor ? value : 1;
    };
    const double turn = std::fmod(insert.number(50).value_or(0), 360.0) * kDegree;
    return insert.map * Eigen::Translation2d(insert.point().value_or(Eigen::Vector2d(0, 0))) *
           Eigen::Rotation2Dd(turn) * Eigen::Scaling(factor(41), factor(42)) *
           Eigen::Translation2d(-block.base);
}

DxfBlockInserter::DxfBlockInserter(const DxfDocument& document) {
    for (const DxfBlock& block : document.blocks) {
        blocks_.emplace(block.name, &block);
    }
}

std::vector<DxfEntity> DxfBlockInserter::replaced(const std::vector<DxfEntity>& entities) {
    placed_.clear();
    add(entities, Eigen::Affine2d::Identity(), {}, 0);
    return std::move(placed_);
}

void DxfBlockInserter::add(const std::vector<DxfEntity>& entities, const Eigen::Affine2d& map,
                           std::string_view layer, int level) {
    for (const DxfEntity& entity : entities) {
        const bool isInsert = entity.kind == "INSERT";
        const auto block = isInsert ? blocks_.find(entity.text(2)) : blocks_.end();
        const std::string_view own = entity.layer == "0" && !layer.empty() ? layer : entity.layer;
        const auto place = [&] {
            placed_.push_back(entity);
            placed_.back().map = map * entity.map;
            placed_.back().layer = own;
            copies_ += level > 0 ? 1 : 0;
        };
        if (block == blocks_.end() || level >= kMaxLevels || isFull()) {
            place();
            if (isInsert && block == blocks_.end()) {
                placed_.back().kind = kMissingBlock;
            }
            continue;
        }
        const Eigen::Affine2d inserted = insertionOf(*block->second, entity);
        const double turn = std::fmod(entity.number(50).value_or(0), 360.0) * kDegree;
        const auto repeats = [&entity](int code) {
            return std::clamp(entity.number(code).value_or(1), 1.0, 1.0 * kMaxRepeats);
        };
        for (int row = 0; row < repeats(71) && !isFull(); ++row) {
            for (int column = 0; column < repeats(70) && !isFull(); ++column) {
                ++copies_;
                const Eigen::Vector2d step(column * entity.number(44).value_or(0),
                                           row * entity.number(45).value_or(0));
                const Eigen::Vector2d moved =
                    entity.map.linear() * (Eigen::Rotation2Dd(turn) * step);
                add(block->second->entities, map * Eigen::Translation2d(moved) * inserted, own,
                    level + 1);
            }
        }
        if (isFull()) {
            place();  // its copies are incomplete
        }
    }
}

bool DxfBlockInserter::isFull() const {
    return copies_ >= kMaxInserted;
}

Result<DxfDocument> readDxfDocument(std::string_view bytes) {
    constexpr std::string_view kBinary = "AutoCAD Binary DXF";
    if (bytes.starts_with(kBinary)) {
        return malformedDxf("it is binary DXF; save it as ASCII");
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrderMark)) {
        bytes.remove_prefix(kByteOrderMark.size());
    }
    const auto decoded = std::make_shared<std::deque<std::string>>();
    std::vector<Wording> notes;
    if (auto text = decodedDxf(bytes, notes)) {
        bytes = decoded->emplace_back(std::move(*text));
    }
    Groups groups(bytes);
    DocumentBuilder builder(decoded);
    bool hasSections = false;
    while (const auto group = groups.next()) {
        hasSections |= group->code == 0 && group->value == "SECTION";
        builder.take(*group);
    }
    if (groups.fault() || !hasSections) {
        return malformedDxf("line " + std::to_string(groups.lineNumber()) +
                            (groups.fault() ? " is not a group code" : ": it has no sections"));
    }
    DxfDocument document = builder.taken();
    document.notes = std::move(notes);
    if (!document.decimalComma.empty()) {
        return malformedDxf(
            worded("a number has a decimal comma, \"%1\"; numbers need decimal points",
                   {readableName(document.decimalComma)}));
    }
    if (document.blocks.empty() && document.entities.empty()) {
        return malformedDxf("it has neither blocks nor entities");
    }
    return document;
}

namespace {

// Plausible sizes of the largest piece, mm: outside the outer limits it cannot be cut from cloth;
// between the inner two limits the size is usual.
constexpr double kTiny = 60, kSmall = 150, kLong = 2500, kHuge = 6000;

bool isPossible(LengthUnit unit, double extent) {
    const double size = extent * millimetresPer(unit);
    return extent == 0 || (size >= kTiny && size <= kHuge);
}

bool isUsual(LengthUnit unit, double extent) {
    const double size = extent * millimetresPer(unit);
    return extent == 0 || (size >= kSmall && size <= kLong);
}

/// The unit that gives a piece of this extent a usual size, or the nearest to it.
LengthUnit bySize(double extent) {
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre}) {
        if (isUsual(unit, extent)) {
            return unit;
        }
    }
    return extent > kLong ? LengthUnit::Millimetre : LengthUnit::Centimetre;
}

/// The unit that the file states, or if its size is impossible, the unit by size.
DxfUnit judged(LengthUnit stated, const Wording& source, double extent) {
    const auto length = [extent](LengthUnit unit) { return figure(extent * millimetresPer(unit)); };
    if (isPossible(stated, extent)) {
        if (isUsual(stated, extent)) {
            return {stated, source};
        }
        return {stated, worded("%1, so the largest piece is %2 mm", {source, length(stated)}),
                true};
    }
    const LengthUnit other = bySize(extent);
    return {other,
            worded("%1, but the largest piece would be %2 mm; in %3 it is %4 mm",
                   {source, length(stated), Wording(std::string(symbol(other))), length(other)}),
            true};
}

}  // namespace

std::optional<LengthUnit> headerUnit(const DxfDocument& document) {
    const auto variable = document.header.find("$INSUNITS");
    if (variable == document.header.end() || variable->second.empty()) {
        return {};
    }
    const double code = variable->second.front().number().value_or(0);
    return code == 1    ? std::optional(LengthUnit::Inch)
           : code == 4  ? std::optional(LengthUnit::Millimetre)
           : code == 5  ? std::optional(LengthUnit::Centimetre)
           : code == 6  ? std::optional(LengthUnit::Metre)
           : code == 14 ? std::optional(LengthUnit::Decimetre)
                        : std::nullopt;
}

DxfUnit dxfUnit(const DxfDocument& document, const std::string& units, double extent) {
    std::string word = units;
    std::ranges::transform(word, word.begin(), lowered);
    if (word.starts_with("english") || word.starts_with("imperial") || word.starts_with("inch")) {
        return judged(LengthUnit::Inch, worded("its text says Units: %1", {Wording(units)}),
                      extent);
    }
    for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre}) {
        if (word == symbol(unit)) {
            return judged(unit, worded("its text says Unit: %1", {Wording(units)}), extent);
        }
    }
    const auto header = headerUnit(document);
    if (word.starts_with("metric")) {
        // Some programs draw METRIC files in centimetres (two of CLO 2024, nests of Optitex).
        if (!header && !isUsual(LengthUnit::Millimetre, extent) &&
            isUsual(LengthUnit::Centimetre, extent)) {
            return {LengthUnit::Centimetre,
                    worded("its text says Units: %1, which some programs use for cm; in mm the "
                           "largest piece would be %2 mm",
                           {Wording(units), figure(extent)}),
                    true};
        }
        return judged(LengthUnit::Millimetre, worded("its text says Units: %1", {Wording(units)}),
                      extent);
    }
    if (header) {
        return judged(*header,
                      worded("$INSUNITS %1",
                             {Wording(std::string(document.header.at("$INSUNITS").front().value))}),
                      extent);
    }
    const LengthUnit unit = bySize(extent);
    return {unit,
            worded("the file states no unit; the largest piece is %1 mm",
                   {figure(extent * millimetresPer(unit))}),
            true};
}

}  // namespace toile
