// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/zip_reader.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <zip.h>

#include "core/base/characters.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace toile {
namespace {

// These texts are in namespace `toile`, where the window looks up their translations.
constexpr const char* kTooMany = translatable("it contains %1 files; unpack it and open the mesh");
constexpr const char* kNoneIn = translatable("none of its %1 files ends in %2");
constexpr const char* kEncrypted =
    translatable("%1 in it is encrypted; unpack it and open the mesh");
constexpr const char* kTooLarge = translatable(
    "it is too large: its meshes are %1 MB unpacked, too much for an archive of %2 MB; unpack it "
    "and open the mesh");
constexpr const char* kNotUnpacked = translatable("%1 in it cannot be unpacked: %2");
constexpr const char* kDamaged = translatable("the archive is damaged");
constexpr const char* kNoArchive = translatable("it is not a .zip archive: %1");

}  // namespace
}  // namespace toile

namespace toile::io {
namespace {

constexpr std::size_t kChunk = 1 << 20;  // so that a false size allocates little memory

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};

struct Close {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

using Archive = std::unique_ptr<zip_t, Discard>;

struct Entry {
    zip_uint64_t index;
    std::string name;
    long long size;
    bool encrypted;
};

class ZipReader {
public:
    ZipReader(std::string_view bytes, const std::string& name)
        : name_(name), packed_(static_cast<long long>(bytes.size())) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
        archive_.reset(source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr);
        if (!archive_) {
            zip_source_free(source);
            why_ = zip_error_strerror(&error);
        }
        zip_error_fini(&error);
    }

    Result<std::vector<UnzippedFile>> read(std::span<const std::string_view> endings,
                                           const Progress& progress) const {
        if (!archive_) {
            return malformed();
        }
        const long long count = zip_get_num_entries(archive_.get(), 0);
        if (count > kMaxZipEntries) {
            return refused(worded(kTooMany, {figure(static_cast<double>(count))}));
        }
        std::vector<Entry> meshes;
        std::string listed;
        for (const std::string_view ending : endings) {
            listed += (listed.empty() ? "" : ", ") + std::string(ending);
            if (meshes.empty()) {
                meshes = entriesWith(count, ending);
            }
        }
        if (meshes.empty()) {
            return Error{ErrorCode::NoGeometry, Subject::file(name_),
                         worded(kNoneIn, {figure(static_cast<double>(count)), Wording(listed)})};
        }
        // Limits the whole archive: many small entries, or entries with the same bytes, add up.
        const long long most =
            std::min(kMaxUnzippedBytes, kSmallUnzippedBytes + kMaxUnpackingRatio * packed_);
        std::vector<UnzippedFile> files;
        long long bytes = 0;
        for (const Entry& mesh : meshes) {
            bytes += std::min(mesh.size, kMaxUnzippedBytes);
        }
        if (bytes > most) {
            return refused(worded(kTooLarge, {figure(static_cast<double>(bytes) / 1e6, 1),
                                              figure(static_cast<double>(packed_) / 1e6, 1)}));
        }
        for (const Entry& mesh : meshes) {
            auto file = unpacked(mesh, progress);
            if (!file) {
                return file.error();
            }
            files.push_back(*std::move(file));
        }
        return files;
    }

    /// The first bytes of the first file with this ending; empty if none can be read.
    std::string startOf(std::string_view ending) const {
        const auto found = archive_ ? entriesWith(zip_get_num_entries(archive_.get(), 0), ending)
                                    : std::vector<Entry>();
        const std::unique_ptr<zip_file_t, Close> file(
            found.empty() ? nullptr : zip_fopen_index(archive_.get(), found.front().index, 0));
        constexpr std::size_t kLooked = 1 << 16;
        std::string bytes(kLooked, '\0');
        const zip_int64_t count = file ? zip_fread(file.get(), bytes.data(), kLooked) : 0;
        bytes.resize(static_cast<std::size_t>(std::max<zip_int64_t>(count, 0)));
        return bytes;
    }

private:
    static bool hasEnding(std::string_view name, std::string_view ending) {
        return name.size() > ending.size() &&
               equalsIgnoringCase(name.substr(name.size() - ending.size()), ending);
    }

    static bool isHidden(std::string_view name) {
        return name.starts_with("__MACOSX/") || name.substr(name.rfind('/') + 1).starts_with('.');
    }

    std::vector<Entry> entriesWith(long long count, std::string_view ending) const {
        std::vector<Entry> found;
        for (long long i = 0; i < count; ++i) {
            zip_stat_t stat;
            zip_stat_init(&stat);
            const auto index = static_cast<zip_uint64_t>(i);
            constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE;
            if (zip_stat_index(archive_.get(), index, ZIP_FL_ENC_GUESS, &stat) != 0 ||
                (stat.valid & kNeeded) != kNeeded || isHidden(stat.name)) {
                continue;
            }
            if (hasEnding(stat.name, ending)) {
                const bool encrypted = (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 &&
                                       stat.encryption_method != ZIP_EM_NONE;
                constexpr zip_uint64_t kMost = std::numeric_limits<long long>::max();
                found.push_back({index, stat.name,
                                 static_cast<long long>(std::min(stat.size, kMost)), encrypted});
            }
        }
        return found;
    }

    Result<UnzippedFile> unpacked(const Entry& entry, const Progress& progress) const {
        const Wording called(readableName(entry.name));
        if (entry.encrypted) {
            return refused(worded(kEncrypted, {called}));
        }
        const std::unique_ptr<zip_file_t, Close> file(
            zip_fopen_index(archive_.get(), entry.index, 0));
        if (!file) {
            return refused(worded(kNotUnpacked, {called, Wording(zip_strerror(archive_.get()))}));
        }
        auto bytes = std::make_shared<std::string>();
        const auto size = static_cast<std::size_t>(entry.size);
        for (zip_int64_t more = 1; more > 0;) {
            if (progress.isCancelled()) {
                return Error{ErrorCode::Cancelled, Subject::file(name_)};
            }
            const std::size_t at = bytes->size();
            const std::size_t chunk = std::min(kChunk, size - at + 1);  // one more: too long?
            bytes->resize(at + chunk);
            more = zip_fread(file.get(), bytes->data() + at, chunk);
            bytes->resize(at + static_cast<std::size_t>(std::max<zip_int64_t>(more, 0)));
            if (more < 0 || bytes->size() > size) {
                return malformed();
            }
        }
        return bytes->size() == size ? Result<UnzippedFile>(UnzippedFile{entry.name, bytes})
                                     : malformed();
    }

    Error malformed() const {
        return {ErrorCode::MalformedFile, Subject::file(name_),
                why_.empty() ? worded(kDamaged) : worded(kNoArchive, {Wording(why_)})};
    }

    Error refused(Wording detail) const {
        return {ErrorCode::FileUnreadable, Subject::file(name_), std::move(detail)};
    }

    std::string name_;
    long long packed_;  ///< bytes of the archive
    Archive archive_;
    std::string why_;  ///< why it could not be opened
};

}  // namespace

std::string startOfZipEntry(std::string_view archive, std::string_view ending) {
    return ZipReader(archive, {}).startOf(ending);
}

Result<std::vector<UnzippedFile>> meshesInZip(std::string_view archive, const std::string& name,
                                              std::span<const std::string_view> endings,
                                              const Progress& progress) {
    return ZipReader(archive, name).read(endings, progress);
}

}  // namespace toile::io
