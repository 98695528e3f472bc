// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup_builder.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/characters.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/io/text_cursor.h"

namespace toile::io {
namespace {

bool inRange(int index, std::size_t count) {
    return static_cast<std::size_t>(static_cast<unsigned>(index)) < count;
}

bool allInRange(const int* first, const int* last, std::size_t count) {
    return std::all_of(first, last, [count](int index) { return inRange(index, count); });
}

struct PlaceWords {
    std::string_view word;
    const char* pattern;
};

constexpr PlaceWords kPlaces[] = {{"face", toile::translatable("face %1")},
                                  {"facet", toile::translatable("facet %1")},
                                  {"line", toile::translatable("line %1")},
                                  {"record", toile::translatable("record %1")}};

}  // namespace

SoupBuilder::SoupBuilder(std::string name, std::string_view placeWord)
    : name_(std::move(name)), counter_(placeWord) {}

void SoupBuilder::addUnreadablePosition(std::string_view text, int place) {
    const char* what = hasDecimalComma(text)
                           ? toile::translatable("with decimal commas; numbers need decimal points")
                           : toile::translatable("not readable");
    counter_.add(ErrorCode::NonFinitePosition, "vertex", what, place);
    soup_.positions.push_back(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

bool SoupBuilder::endFace(int place) {
    const std::size_t first = static_cast<std::size_t>(soup_.faceStart.back());
    if (soup_.corners.size() - first < 3) {
        takeBackCorners();
        counter_.add(ErrorCode::DegenerateFaceRecord, "face",
                     toile::translatable("left out: fewer than three corners"), place);
        return false;
    }
    soup_.faceStart.push_back(static_cast<int>(soup_.corners.size()));
    facePlaces_.push_back(place);
    return true;
}

void SoupBuilder::dropUnreadableFace(int place) {
    takeBackCorners();
    counter_.add(ErrorCode::DegenerateFaceRecord, "face",
                 toile::translatable("left out: not readable"), place);
}

void SoupBuilder::takeBackCorners() {
    const std::size_t first = static_cast<std::size_t>(soup_.faceStart.back());
    soup_.corners.resize(first);
    soup_.cornerUvs.resize(std::min(first, soup_.cornerUvs.size()));
}

Error SoupBuilder::malformed(std::string detail) const {
    return {ErrorCode::MalformedFile, Subject::file(name_), std::move(detail)};
}

void SoupBuilder::leaveOutFacesOutOfRange() {
    PolygonSoup& s = soup_;
    const std::size_t count = s.positions.size();
    if (allInRange(s.corners.data(), s.corners.data() + s.corners.size(), count)) {
        return;
    }
    int kept = 0, corner = 0;
    for (int face = 0, first = 0; face < s.faceCount(); ++face) {
        const int last = s.faceStart[face + 1];
        const bool keep = allInRange(s.corners.data() + first, s.corners.data() + last, count);
        if (!keep) {
            counter_.add(ErrorCode::IndexOutOfRange, "face",
                         toile::translatable("left out: a corner's index is out of range"),
                         facePlaces_[face]);
        }
        for (; keep && first < last; ++first, ++corner) {
            s.corners[corner] = s.corners[first];
            if (!s.cornerUvs.empty()) {
                s.cornerUvs[corner] = s.cornerUvs[first];
            }
        }
        if (keep) {
            for (std::vector<int>* perFace : {&s.faceObject, &s.faceGroup, &s.faceMaterial}) {
                if (!perFace->empty()) {
                    (*perFace)[kept] = (*perFace)[face];
                }
            }
            facePlaces_[kept] = facePlaces_[face];
            s.faceStart[++kept] = corner;
        }
        first = last;
    }
    s.faceStart.resize(kept + 1);
    s.corners.resize(corner);
    s.cornerUvs.resize(s.cornerUvs.empty() ? 0 : corner);
    for (std::vector<int>* perFace : {&s.faceObject, &s.faceGroup, &s.faceMaterial}) {
        perFace->resize(perFace->empty() ? 0 : kept);
    }
}

void SoupBuilder::clearUvsOutOfRange() {
    PolygonSoup& s = soup_;
    if (s.cornerUvs.empty()) {
        return;
    }
    for (int face = 0; face < s.faceCount(); ++face) {
        for (int corner = s.faceStart[face]; corner < s.faceStart[face + 1]; ++corner) {
            int& uv = s.cornerUvs[corner];
            if (uv != kNoUv && !inRange(uv, s.uvs.size())) {
                uv = kNoUv;
                counter_.add(
                    ErrorCode::IndexOutOfRange, "corner",
                    toile::translatable("without texture coordinate: its index is out of range"),
                    facePlaces_[face]);
            }
        }
    }
    if (s.uvs.empty()) {
        s.cornerUvs = {};
    }
}

Result<PolygonSoup> SoupBuilder::finish() {
    leaveOutFacesOutOfRange();
    clearUvsOutOfRange();
    if (soup_.faceCount() == 0) {
        const auto vertices = static_cast<long long>(soup_.positions.size());
        const Wording none = toile::worded("%1, no faces", {countWording(vertices, "vertex")});
        return Error{ErrorCode::NoGeometry, Subject::file(name_),
                     counter_.empty() ? none : toile::worded("%1; %2", {none, counter_.summary()})};
    }
    soup_.problems = counter_.problems(name_);
    return std::move(soup_);
}

void FaceNames::change(std::string_view text, int faceCount) {
    if (text.empty()) {
        current_ = -1;
        return;
    }
    if (names_.empty()) {
        perFace_.assign(static_cast<std::size_t>(faceCount), -1);
    }
    std::string name = readableName(text);
    const auto [found, isNew] = index_.try_emplace(name, static_cast<int>(names_.size()));
    if (isNew) {
        names_.push_back(std::move(name));
    }
    current_ = found->second;
}

void ProblemCounter::add(ErrorCode code, std::string_view noun, const char* what, int place) {
    for (Entry& entry : entries_) {
        if (entry.code == code && entry.noun == noun && std::string_view(entry.what) == what) {
            ++entry.count;
            entry.firstPlace = std::min(entry.firstPlace, place);
            return;
        }
    }
    entries_.push_back({code, noun, what, place, 1});
}

Wording ProblemCounter::inWords(const Entry& entry) const {
    const Wording place(std::to_string(entry.firstPlace));
    const auto* known = std::ranges::find(kPlaces, placeWord_, &PlaceWords::word);
    const Wording where = known == std::end(kPlaces)
                              ? Wording(std::string(placeWord_) + " " + place)
                              : worded(known->pattern, {place});
    const std::vector<Wording> words{countWording(entry.count, entry.noun), worded(entry.what),
                                     where};
    return entry.count == 1 ? Wording("%1 %2, %3", words)
                            : toile::worded("%1 %2, first at %3", words);
}

Wording ProblemCounter::summary() const {
    Wording text;
    for (const Entry& entry : entries_) {
        text += text.empty() ? "" : "; ";
        text += inWords(entry);
    }
    return text;
}

Problems ProblemCounter::problems(const std::string& file) const {
    Problems problems;
    for (const Entry& entry : entries_) {
        const auto same = std::find_if(problems.begin(), problems.end(),
                                       [&](const Error& e) { return e.code == entry.code; });
        if (same == problems.end()) {
            problems.push_back({entry.code, Subject::file(file), inWords(entry)});
        } else {
            same->detail += "; ";
            same->detail += inWords(entry);
        }
    }
    return problems;
}

}  // namespace toile::io

namespace toile {
namespace {

/// Names face by face, like a file with a line for each change.
class ArrayFaceNames {
public:
    ArrayFaceNames(const ArrayNames& given, std::vector<std::string>& names,
                   std::vector<int>& perFace)
        : given_(given), taken_(names, perFace) {}

    /// Sets the name of a face, before it is added as number `faceCount`.
    void change(std::size_t face, int faceCount) {
        const int index = given_.ofFace.empty() ? -1 : given_.ofFace[face];
        if (index != current_) {
            const auto at = static_cast<std::size_t>(index);
            taken_.change(index >= 0 && at < given_.names.size() ? given_.names[at] : "",
                          faceCount);
            current_ = index;
        }
    }
    void addFace() { taken_.addFace(); }

private:
    const ArrayNames& given_;
    io::FaceNames taken_;
    int current_ = -1;
};

/// Writes the positions as text, as in a file.
void giveText(PolygonSoup& soup, int decimals) {
    auto text = std::make_shared<std::string>();
    for (const Eigen::Vector3d& position : soup.positions) {
        TextSpan span{text->size(), 0};
        if (position.allFinite()) {
            for (int axis = 0; axis < 3; ++axis) {
                *text += axis == 0 ? "" : " ";
                appendFixed(*text, position[axis], decimals);
            }
            span.length = static_cast<std::uint32_t>(text->size() - span.offset);
        }
        soup.positionText.push_back(span);
    }
    soup.text = std::move(text);
}

template <class Number>
std::string_view bytesOf(std::span<const Number> numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

/// Identifies a mesh, like the hash of a file's bytes.
std::uint64_t hashOfArrays(const MeshInArrays& mesh) {
    const std::array hashes{
        contentHash(bytesOf(mesh.positions)),     contentHash(bytesOf(mesh.uvs)),
        contentHash(bytesOf(mesh.faceStart)),     contentHash(bytesOf(mesh.corners)),
        contentHash(bytesOf(mesh.cornerUvs)),     contentHash(bytesOf(mesh.objects.ofFace)),
        contentHash(bytesOf(mesh.groups.ofFace)), contentHash(bytesOf(mesh.materials.ofFace))};
    return contentHash(bytesOf(std::span<const std::uint64_t>(hashes)));
}

}  // namespace

Result<PolygonSoup> soupOfArrays(const MeshInArrays& mesh, const std::string& name) {
    io::SoupBuilder builder(name, "row");
    PolygonSoup& soup = builder.soup();
    soup.positions.reserve(mesh.positions.size() / 3);
    for (std::size_t k = 0; k + 2 < mesh.positions.size(); k += 3) {
        builder.addPosition({mesh.positions[k], mesh.positions[k + 1], mesh.positions[k + 2]},
                            static_cast<int>(k / 3));
    }
    for (std::size_t k = 0; k + 1 < mesh.uvs.size(); k += 2) {
        soup.uvs.emplace_back(mesh.uvs[k], mesh.uvs[k + 1]);
    }
    ArrayFaceNames objects(mesh.objects, soup.objects, soup.faceObject);
    ArrayFaceNames groups(mesh.groups, soup.groups, soup.faceGroup);
    ArrayFaceNames materials(mesh.materials, soup.materials, soup.faceMaterial);
    const std::array<ArrayFaceNames*, 3> kinds{&objects, &groups, &materials};
    for (std::size_t face = 0; face + 1 < mesh.faceStart.size(); ++face) {
        for (ArrayFaceNames* kind : kinds) {
            kind->change(face, soup.faceCount());
        }
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            soup.corners.push_back(mesh.corners[corner]);
            if (!mesh.cornerUvs.empty()) {
                const int uv = mesh.cornerUvs[corner];
                soup.cornerUvs.push_back(uv < io::kNoUv ? io::kNoSuchUv : uv);
            }
        }
        if (builder.endFace(static_cast<int>(face))) {
            for (ArrayFaceNames* kind : kinds) {
                kind->addFace();
            }
        }
    }
    if (mesh.decimals >= 0) {
        giveText(soup, mesh.decimals);
    }
    Result<PolygonSoup> made = builder.finish();
    if (made) {
        made->contentHash = hashOfArrays(mesh);
    }
    return made;
}

}  // namespace toile
