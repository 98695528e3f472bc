// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/io/text_cursor.h"
#include "tests/core/readers/mesh_file.h"

namespace toile {
namespace {

using GlbJson = nlohmann::json;

constexpr double kMillimetresPerMetre = 1000;

Error malformedGlb(const char* what) {
    return {ErrorCode::MalformedFile, {}, what};
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    return io::readBytes<std::uint32_t>(bytes.data() + at, std::endian::little);
}

/// The two chunks; none where the frame is wrong.
struct Chunks {
    std::string_view json, binary;
};

std::optional<Chunks> chunksOf(std::string_view bytes) {
    constexpr std::size_t kHead = 12, kChunkHead = 8;
    if (bytes.size() < kHead || bytes.substr(0, 4) != "glTF" || wordAt(bytes, 4) != 2 ||
        wordAt(bytes, 8) != bytes.size()) {
        return {};
    }
    Chunks found;
    for (std::size_t at = kHead; at < bytes.size();) {
        if (bytes.size() - at < kChunkHead) {
            return {};
        }
        const std::size_t length = wordAt(bytes, at);
        const std::string_view kind = bytes.substr(at + 4, 4);
        at += kChunkHead;
        if (length > bytes.size() - at) {
            return {};
        }
        (kind == "JSON" ? found.json : found.binary) = bytes.substr(at, length);
        at += length;
    }
    return found;
}

/// A whole number at a key, within bounds.
std::optional<std::size_t> countAt(const GlbJson& json, const char* key, std::size_t most) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (!json.is_object() || found == json.end() || !found->is_number_unsigned()) {
        return {};
    }
    const auto value = found->get<std::size_t>();
    return value <= most ? std::optional(value) : std::nullopt;
}

const GlbJson* elementAt(const GlbJson& root, const char* list, const GlbJson& owner,
                         const char* key) {
    const auto found = root.find(list);
    if (found == root.end() || !found->is_array()) {
        return nullptr;
    }
    const auto index = countAt(owner, key, found->size());
    return index && *index < found->size() ? &(*found)[*index] : nullptr;
}

class GlbReader {
public:
    GlbReader(const GlbJson& root, std::string_view binary) : root_(root), binary_(binary) {}

    /// Rows of k numbers of 4 bytes each. @param type  the component's
    std::optional<std::vector<std::uint32_t>> words(const GlbJson& owner, const char* key, int type,
                                                    std::size_t perRow) {
        const GlbJson* accessor = elementAt(root_, "accessors", owner, key);
        const GlbJson* view =
            accessor ? elementAt(root_, "bufferViews", *accessor, "bufferView") : nullptr;
        if (!view || accessor->value("componentType", 0) != type) {
            return {};
        }
        const auto count = countAt(*accessor, "count", binary_.size());
        const auto offset = countAt(*view, "byteOffset", binary_.size());
        const auto length = countAt(*view, "byteLength", binary_.size());
        if (!count || !offset || !length || *length > binary_.size() - *offset ||
            *length != *count * perRow * sizeof(std::uint32_t)) {
            return {};
        }
        // Several may refer to the same bytes; not so many that they are a multiple of the file.
        taken_ += *length;
        if (taken_ > binary_.size()) {
            return {};
        }
        std::vector<std::uint32_t> made(*count * perRow);
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k] = wordAt(binary_, *offset + sizeof(std::uint32_t) * k);
        }
        return made;
    }

    template <int columns>
    std::optional<Eigen::Matrix<double, Eigen::Dynamic, columns, Eigen::RowMajor>> reals(
        const GlbJson& owner, const char* key) {
        constexpr int kFloats = 5126;
        const auto read = words(owner, key, kFloats, columns);
        if (!read) {
            return {};
        }
        Eigen::Matrix<double, Eigen::Dynamic, columns, Eigen::RowMajor> rows(
            static_cast<Eigen::Index>(read->size()) / columns, columns);
        for (std::size_t k = 0; k < read->size(); ++k) {
            rows.data()[k] = static_cast<double>(std::bit_cast<float>((*read)[k]));
        }
        return rows.allFinite() ? std::optional(rows) : std::nullopt;
    }

    std::optional<FileMesh> mesh(const GlbJson& json) {
        const auto primitives = json.find("primitives");
        if (primitives == json.end() || !primitives->is_array() || primitives->size() != 1) {
            return {};
        }
        const GlbJson& primitive = primitives->front();
        const auto attributes = primitive.find("attributes");
        if (attributes == primitive.end()) {
            return {};
        }
        constexpr int kIndices = 5125;
        const auto points = reals<3>(*attributes, "POSITION");
        const auto corners = words(primitive, "indices", kIndices, 1);
        if (!points || !corners || corners->size() % 3 != 0) {
            return {};
        }
        FileMesh made;
        made.name = json.value("name", "");
        if (made.name.size() > kLongestMeshName) {
            return {};
        }
        made.V = kMillimetresPerMetre * *points;
        made.F.resize(static_cast<Eigen::Index>(corners->size()) / 3, 3);
        for (std::size_t k = 0; k < corners->size(); ++k) {
            if ((*corners)[k] >= static_cast<std::size_t>(made.V.rows())) {
                return {};
            }
            made.F(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) =
                static_cast<int>((*corners)[k]);
        }
        if (attributes->contains("TEXCOORD_0")) {
            const auto uv = reals<2>(*attributes, "TEXCOORD_0");
            if (!uv || uv->rows() != made.V.rows()) {
                return {};
            }
            made.uv = kMillimetresPerMetre * *uv;
            made.uv.col(1) = kMillimetresPerMetre - made.uv.col(1).array();
        }
        return made;
    }

private:
    const GlbJson& root_;
    std::string_view binary_;
    std::size_t taken_ = 0;  ///< bytes, by all that refer to them
};

std::optional<FileSeam> glbSeam(const GlbJson& json, const std::vector<FileMesh>& meshes) {
    FileSeam seam;
    seam.name = json.value("name", "");
    constexpr const char* kSides[] = {"left", "right"};
    const auto of = json.find("meshes");
    for (std::size_t k = 0; k < 2; ++k) {
        const auto vertices = json.find(kSides[k]);
        if (of == json.end() || !of->is_array() || of->size() != 2 || vertices == json.end() ||
            !vertices->is_array() || !(*of)[k].is_number_unsigned() ||
            (*of)[k].get<std::size_t>() >= meshes.size()) {
            return {};
        }
        const FileMesh& mesh = meshes[(*of)[k].get<std::size_t>()];
        seam.mesh[k] = mesh.name;
        for (const GlbJson& vertex : *vertices) {
            if (!vertex.is_number_unsigned() ||
                vertex.get<std::size_t>() >= static_cast<std::size_t>(mesh.V.rows())) {
                return {};
            }
            seam.vertices[k].push_back(vertex.get<int>());
        }
    }
    return seam;
}

Result<MeshFile> meshesOf(const GlbJson& root, std::string_view binary) {
    GlbReader reader(root, binary);
    MeshFile made;
    // Never a copy of what may be nested deeper than a stack.
    static const GlbJson kNone = GlbJson::array();
    const auto meshes = root.find("meshes");
    for (const GlbJson& json : meshes == root.end() ? kNone : *meshes) {
        auto mesh = json.is_object() ? reader.mesh(json) : std::nullopt;
        if (!mesh) {
            return malformedGlb("a mesh cannot be read");
        }
        made.meshes.push_back(std::move(*mesh));
    }
    const GlbJson::json_pointer place("/scenes/0/extras/toile_seams");
    for (const GlbJson& json : root.contains(place) ? root[place] : kNone) {
        auto seam = json.is_object() ? glbSeam(json, made.meshes) : std::nullopt;
        if (!seam) {
            return malformedGlb("a seam cannot be read");
        }
        made.seams.push_back(std::move(*seam));
    }
    return made;
}

}  // namespace

Result<MeshFile> readGlb(std::string_view bytes) {
    const auto chunks = chunksOf(bytes);
    if (!chunks) {
        return malformedGlb("its frame is not that of a GLB file");
    }
    const GlbJson root = GlbJson::parse(chunks->json, nullptr, false);
    if (!root.is_object()) {
        return malformedGlb("its JSON cannot be read");
    }
    try {  // a field may be of any type, which the library says by an exception
        return meshesOf(root, chunks->binary);
    } catch (const GlbJson::exception&) {
        return malformedGlb("a field of its JSON is of another type");
    }
}

}  // namespace toile
