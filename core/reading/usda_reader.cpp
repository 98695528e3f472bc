// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/reading/mesh_file.h"

namespace toile {
namespace {

constexpr int kDeepest = 16;  // prims within prims
constexpr double kMillimetresPerSt = 1000;
constexpr double kFarthestNumber = 1e12;  // of any number

/// A prim: what it is called, its attributes as text, and what is in it.
struct Prim {
    std::string type{}, name{};
    std::map<std::string, std::string, std::less<>> attributes{};
    std::vector<Prim> children{};

    const std::string* find(std::string_view attribute) const {
        const auto found = attributes.find(attribute);
        return found == attributes.end() ? nullptr : &found->second;
    }
    const Prim* child(std::string_view called) const {
        for (const Prim& prim : children) {
            if (prim.name == called) {
                return &prim;
            }
        }
        return nullptr;
    }
};

/// Reads words, strings and what stands in brackets.
class UsdText {
public:
    explicit UsdText(std::string_view text) : text_(text) {}

    bool atEnd() {
        skipBlanks();
        return at_ >= text_.size();
    }
    char peek() {
        skipBlanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char wanted) {
        if (peek() != wanted) {
            return false;
        }
        ++at_;
        return true;
    }
    /// A run of characters that are none of USD's own marks.
    std::string word() {
        skipBlanks();
        const std::size_t from = at_;
        while (at_ < text_.size() && !isMark(text_[at_])) {
            ++at_;
        }
        return std::string(text_.substr(from, at_ - from));
    }
    std::optional<std::string> quoted() {
        if (!take('"')) {
            return {};
        }
        std::string out;
        for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            at_ += text_[at_] == '\\' && at_ + 1 < text_.size() ? 1 : 0;
            out += text_[at_];
        }
        return at_ < text_.size() ? (++at_, std::optional(out)) : std::nullopt;
    }
    /// From a bracket to the one that closes it, both included; strings may hold brackets.
    std::optional<std::string> bracketed(char open, char close) {
        if (peek() != open) {
            return {};
        }
        const std::size_t from = at_;
        int depth = 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"') {
                if (!quoted()) {
                    return {};
                }
                continue;
            }
            depth += c == open ? 1 : c == close ? -1 : 0;
            ++at_;
            if (depth == 0) {
                return std::string(text_.substr(from, at_ - from));
            }
        }
        return {};
    }
    int line() const {
        return static_cast<int>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n')) +
               1;
    }

private:
    static bool isMark(char c) {
        return std::string_view(" \t\r\n\"=(){}<>,#").find(c) != std::string_view::npos;
    }
    void skipBlanks() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) {
                ++at_;
            } else {
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// A value as text: strings without their quotes.
std::optional<std::string> valueOf(UsdText& text) {
    switch (text.peek()) {
        case '"':
            return text.quoted();
        case '[':
            return text.bracketed('[', ']');
        case '(':
            return text.bracketed('(', ')');
        case '<':
            return text.bracketed('<', '>');
        default:
            return text.word();
    }
}

bool readPrim(UsdText& text, Prim& prim, int depth);

/// What stands between the braces of a prim.
bool readContent(UsdText& text, Prim& prim, int depth) {
    while (!text.take('}')) {
        std::string word = text.word();
        if (word == "def") {
            if (!readPrim(text, prim.children.emplace_back(), depth + 1)) {
                return false;
            }
            continue;
        }
        std::string name;  // the last word before '=': types stand before it
        while (!word.empty()) {
            name = std::move(word);
            word = text.peek() == '=' ? std::string() : text.word();
        }
        if (name.empty() || !text.take('=')) {
            return false;
        }
        auto value = valueOf(text);
        if (!value) {
            return false;
        }
        prim.attributes[name] = std::move(*value);
        if (text.peek() == '(' && !text.bracketed('(', ')')) {
            return false;
        }
    }
    return true;
}

/// After "def".
bool readPrim(UsdText& text, Prim& prim, int depth) {
    if (depth > kDeepest) {
        return false;
    }
    prim.type = text.word();
    const auto name = text.quoted();
    if (!name || !text.take('{')) {
        return false;
    }
    prim.name = *name;
    return readContent(text, prim, depth);
}

/// All numbers of a text, whatever stands between them; none where one is out of all bounds.
std::optional<std::vector<double>> allNumbers(const std::string* text) {
    if (!text) {
        return {};
    }
    std::vector<double> numbers;
    const char *at = text->data(), *const end = at + text->size();
    while (at < end) {
        if (std::string_view("[](), \t\r\n").find(*at) != std::string_view::npos) {
            ++at;
            continue;
        }
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !(std::abs(value) < kFarthestNumber)) {
            return {};
        }
        numbers.push_back(value);
        at = next;
    }
    return numbers;
}

template <class Matrix>
std::optional<Matrix> rowsFrom(const std::string* text) {
    constexpr int kColumns = Matrix::ColsAtCompileTime;
    const auto numbers = allNumbers(text);
    if (!numbers || numbers->size() % kColumns != 0) {
        return {};
    }
    Matrix rows(static_cast<Eigen::Index>(numbers->size()) / kColumns, kColumns);
    for (std::size_t k = 0; k < numbers->size(); ++k) {
        rows(static_cast<Eigen::Index>(k / kColumns), static_cast<Eigen::Index>(k % kColumns)) =
            static_cast<typename Matrix::Scalar>((*numbers)[k]);
    }
    return rows;
}

std::optional<FileMesh> usdMesh(const Prim& prim) {
    const auto points = rowsFrom<Points3>(prim.find("points"));
    // As they are read: not every number is an index.
    const auto corners = rowsFrom<Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
        prim.find("faceVertexIndices"));
    if (!points || !corners || (corners->array() < 0).any() ||
        (corners->array() >= static_cast<double>(points->rows())).any()) {
        return {};
    }
    FileMesh mesh;
    const std::string* name = prim.find("toile:name");
    mesh.name = name ? *name : prim.name;
    if (mesh.name.size() > kLongestMeshName) {
        return {};
    }
    mesh.V = *points;
    mesh.F = corners->cast<int>();
    if (const std::string* st = prim.find("primvars:st")) {
        const auto uv = rowsFrom<Points2>(st);
        if (!uv || uv->rows() != points->rows()) {
            return {};
        }
        mesh.uv = kMillimetresPerSt * *uv;
    }
    return mesh;
}

/// The garment's meshes by the names of their prims.
using MeshesByPrim = std::map<std::string_view, const FileMesh*>;

/// The mesh that a path names; null where there is none.
const FileMesh* meshAt(const MeshesByPrim& meshes, const std::string* path) {
    const std::size_t slash = path ? path->rfind('/') : std::string::npos;
    if (slash == std::string::npos || !path->ends_with('>')) {
        return nullptr;
    }
    const std::string_view prim = std::string_view(*path).substr(slash + 1);
    const auto found = meshes.find(prim.substr(0, prim.size() - 1));
    return found == meshes.end() ? nullptr : found->second;
}

std::optional<FileSeam> usdSeam(const Prim& prim, const MeshesByPrim& meshes) {
    FileSeam seam;
    const std::string* name = prim.find("toile:name");
    seam.name = name ? *name : "";
    constexpr const char* kSides[] = {"toile:left", "toile:right"};
    for (std::size_t k = 0; k < 2; ++k) {
        const FileMesh* mesh = meshAt(meshes, prim.find(kSides[k]));
        const auto numbers = allNumbers(prim.find(std::string(kSides[k]) + "Vertices"));
        if (!mesh || !numbers) {
            return {};
        }
        seam.mesh[k] = mesh->name;
        for (const double number : *numbers) {
            if (number < 0 || number >= static_cast<double>(mesh->V.rows()) ||
                number != std::floor(number)) {
                return {};
            }
            seam.vertices[k].push_back(static_cast<int>(number));
        }
    }
    return seam;
}

Error malformedUsd(const UsdText& text, const char* what) {
    return {ErrorCode::MalformedFile, {}, "line " + std::to_string(text.line()) + ": " + what};
}

}  // namespace

Result<MeshFile> readUsda(std::string_view bytes) {
    UsdText text(bytes);
    if (!bytes.starts_with("#usda 1.0")) {
        return malformedUsd(text, "it is no USD text");
    }
    Prim root;
    if ((text.peek() == '(' && !text.bracketed('(', ')')) || text.word() != "def" ||
        !readPrim(text, root, 0) || !text.atEnd()) {
        return malformedUsd(text, "it cannot be understood");
    }
    MeshFile made;
    const Prim *garment = root.child("garment"), *pattern = root.child("pattern"),
               *seams = root.child("seams");
    if (!garment || !pattern || !seams) {
        return malformedUsd(text, "it lacks the garment, the pattern or the seams");
    }
    for (const auto& [prims, list] :
         {std::pair(garment, &made.meshes), std::pair(pattern, &made.flat)}) {
        for (const Prim& prim : prims->children) {
            auto mesh = usdMesh(prim);
            if (!mesh) {
                return malformedUsd(text, "a mesh cannot be read");
            }
            list->push_back(std::move(*mesh));
        }
    }
    MeshesByPrim byPrim;
    for (std::size_t k = 0; k < made.meshes.size(); ++k) {
        byPrim.emplace(garment->children[k].name, &made.meshes[k]);
    }
    for (const Prim& prim : seams->children) {
        auto seam = usdSeam(prim, byPrim);
        if (!seam) {
            return malformedUsd(text, "a seam cannot be read");
        }
        made.seams.push_back(std::move(*seam));
    }
    return made;
}

}  // namespace toile
