// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/io/soup.h"
#include "core/io/soup_builder.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

/// True for OFF and its variants with texture coordinates, colours and normals per vertex: each
/// puts the position first on the line. False for other dimensions (4OFF, nOFF).
bool isOffKeyword(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"}) {
        if (word.starts_with(prefix)) {
            word.remove_prefix(prefix.size());
        }
    }
    return word == "OFF";
}

class OffReader {
public:
    OffReader(std::shared_ptr<const std::string> text, const std::string& name)
        : builder_(name, "line"), soup_(builder_.soup()), cursor_(*text) {
        soup_.text = std::move(text);
    }

    Result<PolygonSoup> read(const Progress& progress) {
        int vertexCount = 0, faceCount = 0;
        if (const Result<void> header = readHeader(vertexCount, faceCount); !header) {
            return header.error();
        }
        soup_.positions.reserve(static_cast<std::size_t>(vertexCount));
        soup_.positionText.reserve(static_cast<std::size_t>(vertexCount));
        const long long records = static_cast<long long>(vertexCount) + faceCount;
        for (long long i = 0; i < records; ++i) {
            cursor_.skipSpaceAndComments();
            if (cursor_.atEnd()) {
                return truncated(i, vertexCount, faceCount);
            }
            if (i % io::kRecordsPerCancelCheck == 0 && progress.isCancelled()) {
                return builder_.cancelled();
            }
            i < vertexCount ? readVertex() : readFace();
            cursor_.nextLine();
        }
        return builder_.finish();
    }

private:
    Result<void> readHeader(int& vertexCount, int& faceCount) {
        cursor_.skipSpaceAndComments();
        if (!isOffKeyword(cursor_.token())) {
            return malformed("the file does not begin with OFF, COFF, NOFF or STOFF");
        }
        cursor_.skipSpaceAndComments();
        if (!readCount(vertexCount) || !readCount(faceCount)) {
            return malformed("the counts of vertices and faces are missing");
        }
        cursor_.nextLine();
        // A vertex needs at least 5 bytes ("0 0 0"), a face one.
        const std::size_t vertices = static_cast<std::size_t>(vertexCount);
        if (vertices > cursor_.bytesLeft() / 5 + 1 ||
            static_cast<std::size_t>(faceCount) > cursor_.bytesLeft()) {
            return malformed(promised(vertexCount, faceCount) +
                             ", but the file is too short for them");
        }
        return {};
    }

    bool readCount(int& count) {
        cursor_.skipBlanks();
        return cursor_.readInt(count) == io::TextCursor::IntStatus::Ok && count >= 0 &&
               cursor_.atTokenEnd();
    }

    void readVertex() {
        const std::string_view text = cursor_.restOfLine();
        Eigen::Vector3d position;
        const std::size_t first = cursor_.offset();
        if (cursor_.readDoubles(position.data(), 3)) {
            builder_.addPosition(position, cursor_.line());
            soup_.positionText.push_back(
                {first, static_cast<std::uint32_t>(cursor_.offset() - first)});
        } else {
            builder_.addUnreadablePosition(text, cursor_.line());
            soup_.positionText.push_back({});
        }
    }

    void readFace() {
        const int line = cursor_.line();
        int cornerCount = 0;
        bool readable = readCount(cornerCount);
        for (int i = 0; readable && i < cornerCount; ++i) {
            int index = io::kNoSuchPosition;
            cursor_.skipBlanks();
            const io::TextCursor::IntStatus status = cursor_.readInt(index);
            readable = status != io::TextCursor::IntStatus::NotANumber && cursor_.atTokenEnd();
            soup_.corners.push_back(status == io::TextCursor::IntStatus::Ok ? index
                                                                            : io::kNoSuchPosition);
        }
        readable ? static_cast<void>(builder_.endFace(line)) : builder_.dropUnreadableFace(line);
    }

    static std::string promised(int vertexCount, int faceCount) {
        return "the header promises " + counted(vertexCount, "vertex") + " and " +
               counted(faceCount, "face");
    }

    Error truncated(long long records, int vertexCount, int faceCount) const {
        const long long vertices = std::min<long long>(records, vertexCount);
        return builder_.malformed(promised(vertexCount, faceCount) + ", but the file ends after " +
                                  counted(vertices, "vertex") + " and " +
                                  counted(records - vertices, "face"));
    }

    Error malformed(const std::string& what) const {
        return builder_.malformed("line " + std::to_string(cursor_.line()) + ": " + what);
    }

    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    io::TextCursor cursor_;
};

}  // namespace

Result<PolygonSoup> readOff(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress) {
    return OffReader(std::move(text), name).read(progress);
}

}  // namespace toile
