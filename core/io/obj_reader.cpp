// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Geometry>

#include "core/base/text.h"
#include "core/io/soup.h"
#include "core/io/soup_builder.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

/// Converts an index that counts from 1, or back from the end if negative, to a position in a list
/// that has `count` entries so far; `none` if there can be no such entry.
int fromZero(int index, std::size_t count, int none) {
    const int resolved = index > 0 ? index - 1 : static_cast<int>(count) + index;
    return index == 0 || resolved < 0 ? none : resolved;
}

/// Millimetres in the unit that a lower-case comment states: "1 unit = 8ft", "units: millimetres";
/// 0 if it does not state one.
double unitOfComment(const std::string& text) {
    constexpr std::pair<std::string_view, double> kWords[] = {
        {"mm", 1},       {"millimet", 1},  {"cm", 10},   {"centimet", 10},
        {"dm", 100},     {"decimet", 100}, {"in", 25.4}, {"ft", 304.8},
        {"feet", 304.8}, {"foot", 304.8},  {"m", 1000}};
    const auto skip = [&text](std::size_t at, const char* skipped) {
        return std::min(text.find_first_not_of(skipped, at), text.size());
    };
    const std::size_t unit = text.find("unit");
    std::size_t at = unit == std::string::npos ? text.size() : skip(unit + 4, "s \t");
    if (at == text.size() || (text[at] != '=' && text[at] != ':')) {
        return 0;
    }
    at = skip(at + 1, " \t");
    double number = 1;
    const char* const start = text.data();
    at = skip(static_cast<std::size_t>(
                  std::from_chars(start + at, start + text.size(), number).ptr - start),
              " \t");
    const auto* const word = std::ranges::find_if(kWords, [&](const auto& known) {
        return text.compare(at, known.first.size(), known.first) == 0;
    });
    return word != std::end(kWords) && FileUnit::ofMillimetres(number * word->second)
               ? number * word->second
               : 0;
}

class ObjReader {
public:
    ObjReader(std::shared_ptr<const std::string> text, const std::string& name)
        : builder_(name, "line"), soup_(builder_.soup()), cursor_(*text) {
        soup_.text = std::move(text);
    }

    Result<PolygonSoup> read(const Progress& progress) {
        for (int lines = 1; !cursor_.atEnd(); ++lines) {
            if (lines % io::kRecordsPerCancelCheck == 0 && progress.isCancelled()) {
                return builder_.cancelled();
            }
            cursor_.skipBlanks();
            readLine();
            cursor_.nextLine();
        }
        if (!soup_.uvs.empty()) {
            soup_.cornerUvs.resize(soup_.corners.size(), io::kNoUv);
        }
        Result<PolygonSoup> soup = builder_.finish();
        if (soup && isOfMakeHuman_ && !soup->statedUnit) {
            noteMakeHuman(*soup);
        }
        if (soup) {
            soup->problems.insert(soup->problems.end(), notes_.begin(), notes_.end());
        }
        return soup;
    }

private:
    void readLine() {
        const std::string_view keyword = cursor_.token();
        if (keyword == "v") {
            readPosition();
        } else if (keyword == "vt") {
            readUv();
        } else if (keyword == "f") {
            readFace();
        } else if (keyword == "o") {
            objects_.change(cursor_.restOfLine(), soup_.faceCount());
        } else if (keyword == "g") {
            groups_.change(cursor_.restOfLine(), soup_.faceCount());
        } else if (keyword == "usemtl") {
            materials_.change(cursor_.restOfLine(), soup_.faceCount());
        } else if (keyword.starts_with('#') && soup_.positions.empty() && !soup_.statedUnit) {
            std::string text = std::string(keyword) + " " + std::string(cursor_.restOfLine());
            std::ranges::transform(text, text.begin(), [](char c) { return lowered(c); });
            isOfMakeHuman_ = isOfMakeHuman_ || text.find("makehuman") != std::string::npos;
            noteUnit(unitOfComment(text));
        }
    }

    /// A unit without a name is left to the user, since positions keep the file's digits.
    void noteUnit(double millimetres) {
        const auto unit = FileUnit::ofMillimetres(millimetres);
        if (unit && unit->named()) {
            soup_.statedUnit =
                StatedUnit{*unit->named(), toile::worded("stated in a comment of the file")};
        } else if (unit && notes_.empty()) {
            notes_.push_back({ErrorCode::UnitGuessed, Subject::file(builder_.name()),
                              toile::worded("a comment in the file states a unit of %1, which "
                                            "Toile does not use; set it with --unit",
                                            {Wording(unitText(*unit))})});
        }
    }

    /// MakeHuman works in decimetres and lets its users export in other units: assume decimetres
    /// only if the size then fits clothes.
    static void noteMakeHuman(PolygonSoup& soup) {
        constexpr double kSmallest = 2, kLargest = 25;
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& position : soup.positions) {
            box.extend(position);
        }
        const double extent = box.sizes().maxCoeff();
        if (extent >= kSmallest && extent <= kLargest) {
            soup.statedUnit =
                StatedUnit{LengthUnit::Decimetre, toile::worded("MakeHuman works in decimetres")};
        }
    }

    void readPosition() {
        const int line = cursor_.line();
        const std::string_view text = cursor_.restOfLine();
        Eigen::Vector3d position;
        if (cursor_.readDoubles(position.data(), 3)) {
            builder_.addPosition(position, line);
            soup_.positionText.push_back(spanOf(text, line));
        } else {
            builder_.addUnreadablePosition(text, line);
            soup_.positionText.push_back({});
        }
    }

    /// The span of a position's text, without a comment; empty if the line is joined with the next,
    /// since an export repeats single lines.
    TextSpan spanOf(std::string_view text, int line) const {
        if (cursor_.line() != line || text.ends_with('\\')) {
            return {};
        }
        const std::size_t comment = text.find(" #");
        const std::size_t last = text.find_last_not_of(" \t\v\f", comment);
        return {static_cast<std::uint64_t>(text.data() - soup_.text->data()),
                static_cast<std::uint32_t>(last + 1)};
    }

    /// One, two or three numbers; the first two are used.
    void readUv() {
        const int line = cursor_.line();
        Eigen::Vector2d uv(0, 0);
        if (!cursor_.readDoubles(uv.data(), 1)) {
            uv.setConstant(std::numeric_limits<double>::quiet_NaN());
            builder_.counter().add(ErrorCode::NonFinitePosition, "texture coordinate",
                                   toile::translatable("not readable"), line);
        } else {
            cursor_.readDoubles(&uv[1], 1);
        }
        soup_.uvs.push_back(uv);
    }

    void readFace() {
        const int line = cursor_.line();
        cursor_.skipBlanks();
        while (!cursor_.atLineEnd() && !cursor_.at('#')) {
            if (!readCorner()) {
                builder_.dropUnreadableFace(line);
                return;
            }
            cursor_.skipBlanks();
        }
        if (builder_.endFace(line)) {
            objects_.addFace();
            groups_.addFace();
            materials_.addFace();
        }
    }

    /// "a", "a/b", "a//c", "a/b/c"; empty parts after a slash are tolerated.
    bool readCorner() {
        int position = io::kNoSuchPosition, uv = io::kNoUv, normal = 0;
        if (!readIndex(soup_.positions.size(), io::kNoSuchPosition, position)) {
            return false;
        }
        if (cursor_.skip('/') && !cursor_.at('/') && !cursor_.atTokenEnd() &&
            !readIndex(soup_.uvs.size(), io::kNoSuchUv, uv)) {
            return false;
        }
        if (cursor_.skip('/') && !cursor_.atTokenEnd() && !readIndex(0, 0, normal)) {
            return false;
        }
        if (uv != io::kNoUv &&
            soup_.cornerUvs.empty()) {  // most files have none: nothing is stored
            soup_.cornerUvs.resize(soup_.corners.size(), io::kNoUv);
        }
        if (uv != io::kNoUv || !soup_.cornerUvs.empty()) {
            soup_.cornerUvs.push_back(uv);
        }
        soup_.corners.push_back(position);
        return cursor_.atTokenEnd();
    }

    bool readIndex(std::size_t countSoFar, int none, int& index) {
        using Status = io::TextCursor::IntStatus;
        const Status status = cursor_.readInt(index);
        index = status == Status::Ok ? fromZero(index, countSoFar, none) : none;
        return status != Status::NotANumber;
    }

    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    Problems notes_;
    bool isOfMakeHuman_ = false;
    io::TextCursor cursor_;
    io::FaceNames objects_{soup_.objects, soup_.faceObject};
    io::FaceNames groups_{soup_.groups, soup_.faceGroup};
    io::FaceNames materials_{soup_.materials, soup_.faceMaterial};
};

}  // namespace

Result<PolygonSoup> readObj(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress) {
    return ObjReader(std::move(text), name).read(progress);
}

}  // namespace toile
