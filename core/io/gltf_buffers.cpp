// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf_buffers.h"

#include <charconv>
#include <string>
#include <system_error>

#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/json_fields.h"

namespace toile::io {

std::string withoutEscapes(std::string_view uri) {
    std::string path;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        unsigned char byte = 0;
        const char* const digits = uri.data() + k + 1;
        if (uri[k] == '%' && k + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            path += static_cast<char>(byte);
            k += 2;
        } else {
            path += uri[k];
        }
    }
    return path;
}

std::uint64_t hashWithBuffers(const std::filesystem::path& path, std::string_view text) {
    constexpr std::size_t kMostBuffers = 100;
    std::uint64_t hash = contentHash(text);
    const Result<JsonDocument> root = parseJson(text, {}, ErrorCode::MalformedFile);
    if (!root || !root->is_object() || !root->contains("buffers")) {
        return hash;
    }
    std::size_t count = 0;
    for (const JsonDocument& buffer : (*root)["buffers"]) {
        const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
        if (uri == buffer.end() || !uri->is_string() ||
            uri->get_ref<const std::string&>().starts_with("data:") || ++count > kMostBuffers) {
            continue;
        }
        const auto& name = uri->get_ref<const std::string&>();
        const auto beside = path.parent_path() / name;
        std::error_code unknown;
        const Result<std::string> bytes = readFile(std::filesystem::exists(beside, unknown)
                                                       ? beside
                                                       : path.parent_path() / withoutEscapes(name));
        if (bytes) {
            hash = hashOf({hash, contentHash(*bytes)});
        }
    }
    return hash;
}

}  // namespace toile::io
