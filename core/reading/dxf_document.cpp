// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/dxf_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/text.h"

namespace toile {
namespace {

std::optional<double> parsedNumber(std::string_view text) {
    text.remove_prefix(!text.empty() && text.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The pairs of a file, one after the other.
class Groups {
public:
    explicit Groups(std::string_view bytes) : rest_(bytes) {}

    /// The next pair; none at the end, or where there is none (`fault`).
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
    void take(const DxfGroup& group) {
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
            endPolyline(*place());  // before a section or a block leads elsewhere
        }
        entity_ = {};
        entity_.kind = kind;
        isSectionName_ = kind == "SECTION";
        document_.hasEnd |= kind == "EOF";
        if (kind == "ENDSEC") {
            section_ = variable_ = {};
        }
    }

    /// Where entities go now; null outside of blocks and entities.
    std::vector<DxfEntity>* place() {
        if (section_ == "ENTITIES") {
            return &document_.entities;
        }
        return section_ == "BLOCKS" && isInBlock_ ? &document_.blocks.back().entities : nullptr;
    }

    void finish() {
        const std::string_view kind = entity_.kind;
        entity_.layer = entity_.text(8);
        if (section_ == "TABLES" && kind == "LAYER" && !entity_.text(2).empty()) {
            const double colour = entity_.number(62).value_or(7);
            document_.layers[entity_.text(2)] =
                static_cast<int>(std::clamp(std::abs(colour), 0.0, 256.0));
        } else if (section_ == "BLOCKS" && kind == "BLOCK") {
            document_.blocks.push_back(
                {entity_.text(2), entity_.point().value_or(Eigen::Vector2d(0, 0)), {}});
            isInBlock_ = true;
        } else if (section_ == "BLOCKS" && kind == "ENDBLK") {
            isInBlock_ = false;
        } else if (std::vector<DxfEntity>* const there = place(); there && kind != "SECTION") {
            add(*there);
        }
        entity_ = {};
    }

    void add(std::vector<DxfEntity>& there) {
        if (entity_.kind == "VERTEX" && isInPolyline_) {
            addVertex(entity_.point());
            return;
        }
        if (entity_.kind == "SEQEND" || entity_.kind.empty()) {
            return;
        }
        const auto flags =
            static_cast<long>(std::clamp(entity_.number(70).value_or(0), 0.0, 65535.0));
        isInPolyline_ = entity_.kind == "POLYLINE";
        if (entity_.kind == "LWPOLYLINE") {
            readLightVertices();
        }
        entity_.closed = (isInPolyline_ || entity_.kind == "LWPOLYLINE") && (flags & 1) != 0;
        there.push_back(std::move(entity_));
        if (there.back().kind == "LWPOLYLINE") {
            endPolyline(there);
        }
    }

    void addVertex(const std::optional<Eigen::Vector2d>& vertex) {
        if (vertex) {
            vertices_.push_back(*vertex);
        }
    }

    void readLightVertices() {
        double x = std::nan("");
        for (const DxfGroup& group : entity_.groups) {
            if (group.code == 10) {
                x = group.number().value_or(std::nan(""));
            } else if (group.code == 20 && std::isfinite(x)) {
                if (const auto y = group.number()) {
                    addVertex(Eigen::Vector2d(x, *y));
                }
                x = std::nan("");
            }
        }
    }

    /// The polyline before has all its vertices.
    void endPolyline(std::vector<DxfEntity>& there) {
        isInPolyline_ = false;
        Points2& points = there.back().points;
        points.resize(static_cast<Eigen::Index>(vertices_.size()), 2);
        for (std::size_t k = 0; k < vertices_.size(); ++k) {
            points.row(static_cast<Eigen::Index>(k)) = vertices_[k].transpose();
        }
        vertices_.clear();
    }

    DxfDocument document_;
    DxfEntity entity_{};
    std::vector<Eigen::Vector2d> vertices_;
    std::string_view section_, variable_;
    bool isSectionName_ = false, isInBlock_ = false, isInPolyline_ = false;
};

Error malformedDxf(const std::string& what) {
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

Result<DxfDocument> readDxfDocument(std::string_view bytes) {
    constexpr std::string_view kBinary = "AutoCAD Binary DXF";
    if (bytes.starts_with(kBinary)) {
        return malformedDxf("it is a binary DXF file; save it as ASCII");
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrderMark)) {
        bytes.remove_prefix(kByteOrderMark.size());
    }
    Groups groups(bytes);
    DocumentBuilder builder;
    bool hasSections = false;
    while (const auto group = groups.next()) {
        hasSections |= group->code == 0 && group->value == "SECTION";
        builder.take(*group);
    }
    if (groups.fault() || !hasSections) {
        return malformedDxf("line " + std::to_string(groups.lineNumber()) +
                            (groups.fault() ? " is no group code" : ": it has no sections"));
    }
    DxfDocument document = builder.taken();
    if (document.blocks.empty() && document.entities.empty()) {
        return malformedDxf("it has neither blocks nor entities");
    }
    return document;
}

}  // namespace toile
