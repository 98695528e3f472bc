// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup_bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <utility>
#include <vector>

namespace toile::io {
namespace {

/// Writes lists of numbers to bytes, or reads them back in the same order.
class Stream {
public:
    Stream() : isWriting_(true) {}
    explicit Stream(std::string_view bytes) : isWriting_(false), rest_(bytes) {}

    /// A string, or a vector of numbers or points.
    template <class List>
    void list(List& items) {
        std::uint64_t count = items.size();
        raw(&count, sizeof count);
        if (!isWriting_) {
            failed_ = failed_ || count > rest_.size() / sizeof(items[0]);
            items.resize(failed_ ? 0 : count);
        }
        raw(items.data(), items.size() * sizeof(items[0]));
    }

    void texts(std::vector<std::string>& items) {
        std::vector<char> each(items.size());  // bounds the count by the bytes that follow
        list(each);
        items.resize(each.size());
        for (std::string& item : items) {
            list(item);
        }
    }

    bool isComplete() const { return !failed_ && rest_.empty(); }
    std::string take() { return std::move(out_); }

private:
    void raw(void* data, std::size_t size) {
        if (isWriting_) {
            out_.append(static_cast<const char*>(data), size);
        } else if (failed_ || size > rest_.size()) {
            failed_ = true;
        } else if (size > 0) {
            std::memcpy(data, rest_.data(), size);
            rest_.remove_prefix(size);
        }
    }

    bool isWriting_, failed_ = false;
    std::string out_;
    std::string_view rest_;
};

/// Exchanges a soup. The errors are its problems, or the one error instead of it.
void exchange(Stream& stream, PolygonSoup& soup, Problems& errors) {
    std::vector<int> codes, units, axes;
    if (soup.statedUnit) {
        units.push_back(static_cast<int>(soup.statedUnit->unit));
    }
    if (soup.statedUp) {
        axes.push_back(static_cast<int>(soup.statedUp->axis));
    }
    std::vector<std::string> texts;
    for (const Error& error : errors) {
        codes.push_back(static_cast<int>(error.code));
        texts.push_back(error.detail);
    }
    stream.list(soup.positions);
    stream.list(soup.uvs);
    for (auto* list : {&soup.faceStart, &soup.corners, &soup.cornerUvs, &soup.faceObject,
                       &soup.faceMaterial, &codes, &units, &axes}) {
        stream.list(*list);
    }
    for (auto* list : {&soup.objects, &soup.materials, &texts}) {
        stream.texts(*list);
    }
    if (units.size() == 1 && units[0] >= 0 &&
        units[0] < static_cast<int>(std::size(kLengthUnits))) {
        soup.statedUnit = StatedUnit{static_cast<LengthUnit>(units[0]), {}};
    }
    if (axes.size() == 1) {
        soup.statedUp =
            StatedUp{axes[0] == static_cast<int>(UpAxis::Z) ? UpAxis::Z : UpAxis::Y, {}};
    }
    errors.clear();
    for (std::size_t k = 0; k < std::min(codes.size(), texts.size()); ++k) {
        errors.push_back(
            {static_cast<ErrorCode>(std::clamp(codes[k], 0, kErrorCodeCount - 1)), {}, texts[k]});
    }
}

bool areIn(const std::vector<int>& indices, int least, std::size_t count) {
    return std::ranges::all_of(
        indices, [&](int index) { return index >= least && index < static_cast<int>(count); });
}

bool keepsPromises(const PolygonSoup& soup) {
    const auto isPerFace = [&soup](const std::vector<int>& list) {
        return list.empty() || std::ssize(list) == soup.faceCount();
    };
    return !soup.faceStart.empty() && soup.faceStart.front() == 0 &&
           std::ranges::is_sorted(soup.faceStart) &&
           soup.faceStart.back() == std::ssize(soup.corners) &&
           areIn(soup.corners, 0, soup.positions.size()) &&
           areIn(soup.cornerUvs, -1, soup.uvs.size()) &&
           (soup.cornerUvs.empty() || soup.cornerUvs.size() == soup.corners.size()) &&
           isPerFace(soup.faceObject) && isPerFace(soup.faceMaterial) &&
           areIn(soup.faceObject, -1, soup.objects.size()) &&
           areIn(soup.faceMaterial, -1, soup.materials.size());
}

}  // namespace

std::string packedSoup(Result<PolygonSoup> soup) {
    PolygonSoup none;
    none.faceStart.clear();
    Problems errors = soup ? soup->problems : Problems{soup.error()};
    Stream stream;
    exchange(stream, soup ? *soup : none, errors);
    return stream.take();
}

Result<PolygonSoup> unpackedSoup(std::string_view bytes, const std::string& name) {
    Stream stream(bytes);
    PolygonSoup soup;
    exchange(stream, soup, soup.problems);
    for (Error& problem : soup.problems) {
        problem.subject = Subject::file(name);
    }
    if (stream.isComplete() && soup.faceStart.empty() && !soup.problems.empty()) {
        return soup.problems.front();
    }
    if (!stream.isComplete() || !keepsPromises(soup)) {
        return Error{ErrorCode::MalformedFile, Subject::file(name)};
    }
    return soup;
}

}  // namespace toile::io
