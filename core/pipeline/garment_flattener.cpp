// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/garment_flattener.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/garment/garment.h"
#include "core/pipeline/piece_work.h"

namespace toile {
namespace {

std::filesystem::path pathOf(const Garment& garment, const Piece& piece) {
    const auto file = static_cast<std::size_t>(piece.file);
    return piece.file >= 0 && file < garment.files.size() ? garment.files[file]->path
                                                          : std::filesystem::path();
}

/// For each face of the files, which of the pieces has it; of several the first.
class FaceOwners {
public:
    void add(const Piece& piece, const std::filesystem::path& path, int index) {
        std::vector<int>& owner = ownerOf_[{path, piece.file}];
        for (const int face : piece.sourceFace) {
            if (face < 0) {
                continue;
            }
            if (static_cast<std::size_t>(face) >= owner.size()) {
                owner.resize(static_cast<std::size_t>(face) + 1, -1);
            }
            owner[face] = owner[face] < 0 ? index : owner[face];
        }
    }

    /// The one that has most of the piece's faces, or -1.
    int find(const Piece& piece, const std::filesystem::path& path) const {
        const auto file = ownerOf_.find({path, piece.file});
        if (file == ownerOf_.end()) {
            return -1;
        }
        const std::vector<int>& owner = file->second;
        std::map<int, int> votes;
        for (const int face : piece.sourceFace) {
            if (face >= 0 && static_cast<std::size_t>(face) < owner.size() && owner[face] >= 0) {
                ++votes[owner[face]];
            }
        }
        int best = -1;
        int most = 0;
        for (const auto& [index, count] : votes) {
            if (count > most) {
                best = index;
                most = count;
            }
        }
        return best;
    }

private:
    std::map<std::pair<std::filesystem::path, int>, std::vector<int>> ownerOf_;  ///< by file
};

/// False for errors that the same piece need not have another time.
bool isLasting(const PieceResult& result) {
    return !result.error || (result.error->code != ErrorCode::Cancelled &&
                             result.error->code != ErrorCode::OutOfMemory);
}

}  // namespace

std::vector<std::shared_ptr<const GarmentFlattener::Kept>> GarmentFlattener::snapshot() const {
    const std::lock_guard lock(mutex_);
    return kept_;
}

void GarmentFlattener::forget() {
    const std::lock_guard lock(mutex_);
    kept_.clear();
}

std::size_t GarmentFlattener::keptBytes() const {
    std::size_t bytes = 0;
    for (const auto& kept : snapshot()) {
        bytes += kept->flattener.keptBytes();
    }
    return bytes;
}

PieceResults GarmentFlattener::flatten(const Garment& garment, const FlattenOptions& options,
                                       Progress& progress, int threads) {
    using KeptPointer = std::shared_ptr<const Kept>;
    const std::vector<KeptPointer> before = snapshot();
    std::map<const Piece*, KeptPointer> byPiece;
    std::map<std::string, KeptPointer> byName;
    for (const KeptPointer& kept : before) {
        byPiece.emplace(kept->result->piece.get(), kept);
        byName.emplace(kept->result->piece->name, kept);
    }
    std::optional<FaceOwners> owners;  // made for the first piece that has changed
    const auto ancestorOf = [&](const Piece& piece,
                                const std::filesystem::path& path) -> KeptPointer {
        if (!owners) {
            owners.emplace();
            for (std::size_t k = 0; k < before.size(); ++k) {
                owners->add(*before[k]->result->piece, before[k]->path, static_cast<int>(k));
            }
        }
        const int found = owners->find(piece, path);
        return found < 0 ? nullptr : before[static_cast<std::size_t>(found)];
    };

    PieceResults results(garment.pieces.size());
    std::vector<KeptPointer> kept(garment.pieces.size());
    std::vector<PieceTask> tasks;
    std::vector<std::size_t> place;  // of each task
    std::vector<char> isWithin(garment.pieces.size(), 0);
    std::size_t bytes = 0;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const std::shared_ptr<const Piece>& piece = garment.pieces[p];
        const std::filesystem::path path = pathOf(garment, *piece);
        if (const std::size_t more = PieceFlattener::expectedBytes(*piece);
            more <= mostBytes_ - bytes) {
            isWithin[p] = 1;
            bytes += more;
        }
        const auto same = byPiece.find(piece.get());
        kept[p] = same != byPiece.end() ? same->second : nullptr;
        if (!kept[p]) {
            const auto named = byName.find(piece->name);
            if (named != byName.end() && named->second->path == path &&
                isSamePiece(*named->second->result->piece, *piece)) {
                auto result = std::make_shared<PieceResult>(*named->second->result);
                result->piece = piece;
                kept[p] = std::make_shared<const Kept>(
                    Kept{std::move(result), named->second->flattener, path});
            }
        }
        if (kept[p] && kept[p]->result->options == options) {
            results[p] = kept[p]->result;
            continue;
        }
        if (!kept[p]) {
            kept[p] = ancestorOf(*piece, path);
        }
        PieceTask task{piece};
        if (isWithin[p] != 0) {
            task.flattener = kept[p] ? kept[p]->flattener : PieceFlattener();
        }
        tasks.push_back(std::move(task));
        place.push_back(p);
    }

    std::vector<DoneTask> done = workOn(std::move(tasks), options, progress, threads);
    for (std::size_t t = 0; t < done.size(); ++t) {
        const std::size_t p = place[t];
        results[p] = done[t].result;
        if (isLasting(*done[t].result)) {
            kept[p] = std::make_shared<const Kept>(
                Kept{done[t].result, done[t].flattener.value_or(PieceFlattener()),
                     pathOf(garment, *garment.pieces[p])});
        }
    }
    for (std::size_t p = 0; p < kept.size(); ++p) {
        if (kept[p] && isWithin[p] == 0) {
            kept[p] = std::make_shared<const Kept>(Kept{kept[p]->result, {}, kept[p]->path});
        }
    }
    std::erase(kept, nullptr);
    const std::lock_guard lock(mutex_);
    kept_ = std::move(kept);
    return results;
}

}  // namespace toile
