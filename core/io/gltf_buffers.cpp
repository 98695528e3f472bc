// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf_buffers.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/json_fields.h"
#include "core/base/wording.h"

namespace toile {
namespace {

constexpr const char* kBufferElsewhere = translatable(
    "its buffer \"%1\" is not in its folder; export it again with its files in the same folder, or "
    "as .glb");
constexpr const char* kBufferNoFile =
    translatable("its buffer \"%1\" is a folder, pipe or device; put the file itself there");
constexpr const char* kBuffersTooLong =
    translatable("its buffers up to \"%1\" are longer than 2 GiB; export fewer or coarser meshes");

}  // namespace
}  // namespace toile

namespace toile::io {
namespace fs = std::filesystem;

namespace {

/// Checks the text of the path alone, as the file may not exist.
bool staysBelow(const fs::path& path) {
    return !path.has_root_path() && std::ranges::find(path, "..") == path.end();
}

}  // namespace

std::optional<fs::path> pathBelow(const fs::path& folder, const fs::path& path) {
    std::error_code unknown, missing;
    const fs::path top = fs::canonical(folder.empty() ? "." : folder, unknown);
    const fs::path found = fs::canonical(path, missing);
    if (unknown || missing ||
        std::mismatch(top.begin(), top.end(), found.begin(), found.end()).first != top.end()) {
        return std::nullopt;
    }
    return found;
}

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

Result<std::uint64_t> hashWithBuffers(const fs::path& path, std::string_view text,
                                      const Progress& progress) {
    std::uint64_t hash = contentHash(text);
    const Result<JsonDocument> root = parseJson(text, {}, ErrorCode::MalformedFile);
    if (!root || !root->is_object() || !root->contains("buffers")) {
        return hash;
    }
    const std::string name = readableName(pathText(path.filename()));
    const auto refused = [&name](const char* why, const std::string& buffer) {
        return Error{ErrorCode::FileUnreadable, Subject::file(name),
                     worded(why, {shownText(buffer)})};
    };
    std::uintmax_t sum = 0;
    for (const JsonDocument& buffer : (*root)["buffers"]) {
        const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
        if (uri == buffer.end() || !uri->is_string() ||
            uri->get_ref<const std::string&>().starts_with("data:")) {
            continue;
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, Subject::file(name)};
        }
        const auto& written = uri->get_ref<const std::string&>();
        if (!staysBelow(written) || !staysBelow(withoutEscapes(written))) {
            return refused(kBufferElsewhere, written);
        }
        std::error_code unknown;
        const fs::path beside = path.parent_path() / written;
        const fs::path at =
            fs::exists(beside, unknown) ? beside : path.parent_path() / withoutEscapes(written);
        if (!fs::exists(at, unknown)) {
            continue;  // assimp reports it
        }
        if (!pathBelow(path.parent_path(), at)) {
            return refused(kBufferElsewhere, written);
        }
        if (!fs::is_regular_file(at, unknown)) {
            return refused(kBufferNoFile, written);
        }
        const std::uintmax_t size = fs::file_size(at, unknown);
        if (unknown || size > kMaxBufferBytes - sum) {
            return refused(kBuffersTooLong, written);
        }
        sum += size;
        const Result<std::string> bytes = readFile(at);
        if (!bytes) {
            return bytes.error();
        }
        hash = hashOf({hash, contentHash(*bytes)});
    }
    return hash;
}

}  // namespace toile::io
