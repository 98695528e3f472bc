// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "core/io/soup.h"
#include "core/io/soup_builder.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

/// Position in a list that has `count` entries so far of an index that counts from 1, or back from
/// the end where it is negative; `none` where there can be no such entry.
int fromZero(int index, std::size_t count, int none) {
    const int resolved = index > 0 ? index - 1 : static_cast<int>(count) + index;
    return index == 0 || resolved < 0 ? none : resolved;
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
        return builder_.finish();
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

    /// Where the text of a position lies, without a comment; empty where the line is joined with
    /// the next, as it could not be repeated as one.
    TextSpan spanOf(std::string_view text, int line) const {
        if (cursor_.line() != line || text.ends_with('\\')) {
            return {};
        }
        const std::size_t comment = text.find(" #");
        const std::size_t last = text.find_last_not_of(" \t\v\f", comment);
        return {static_cast<std::uint64_t>(text.data() - soup_.text->data()),
                static_cast<std::uint32_t>(last + 1)};
    }

    /// One, two or three numbers, of which the first two count.
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
            soup_.cornerUvs.empty()) {  // most files have none: nothing is kept then
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
