// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/identify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <Eigen/Geometry>

namespace toile {
namespace {

/// Two pieces differ if they are farther apart than this part of their size, or differ in area by
/// more than this logarithm; with equal names, by more than this many times as much.
constexpr double kSamePlace = 0.25, kSameArea = 0.25, kByName = 4;

KnownPiece knownBy(const Piece& piece, const SourceFile& file) {
    KnownPiece known{piece.id, piece.file, piece.name};
    const MeshArrays& mesh = piece.mesh;
    Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();
    double area = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3d a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
                                 c = mesh.V.row(mesh.F(f, 2));
        const double one = 0.5 * (b - a).cross(c - a).norm();
        moment += one / 3 * (a + b + c);
        area += one;
    }
    const double unit = millimetresPer(file.unit);
    if (std::isfinite(area) && area > 0 && moment.allFinite()) {
        known.centre = asInFile(file.up, moment / area).transpose() / unit;
        known.area = area / (unit * unit);
    }
    return known;
}

/// Dissimilarity of two pieces; nothing if they cannot be the same.
std::optional<double> unlikeness(const KnownPiece& a, const KnownPiece& b) {
    const bool sameName = a.name == b.name;
    if (!(a.area > 0) || !(b.area > 0)) {
        return sameName ? std::optional(0.0) : std::nullopt;
    }
    const double away = (a.centre - b.centre).norm() / std::sqrt(std::max(a.area, b.area));
    const double grown = std::abs(std::log(a.area / b.area));
    const double allowed = sameName ? kByName : 1;
    return away <= allowed * kSamePlace && grown <= allowed * kSameArea
               ? std::optional(away + grown)
               : std::nullopt;
}

class Identifier {
public:
    Identifier(std::vector<std::shared_ptr<Piece>>& uncut,
               const std::vector<std::shared_ptr<const SourceFile>>& files,
               const std::vector<KnownPiece>& known)
        : uncut_(uncut), files_(files), known_(known), isFree_(known.size(), 1) {
        for (std::size_t k = 0; k < known.size(); ++k) {
            isFree_[k] = known[k].id && byId_.emplace(known[k].id, k).second ? 1 : 0;
        }
    }

    void run() {
        proposeIds();
        std::vector<std::size_t> unknown;
        for (std::size_t i = 0; i < uncut_.size(); ++i) {
            if (!takeProposed(i)) {
                unknown.push_back(i);
            }
        }
        matchOthers(unknown);
        for (const std::size_t i : unknown) {
            if (!uncut_[i]->id) {  // a new piece
                PieceId id = proposed_[i];
                while (!taken_.insert(id).second) {
                    id.value = hashOf({id.value});
                }
                uncut_[i]->id = id;
            }
        }
        for (const auto& piece : uncut_) {
            piece->lineage = {{piece->id}, {}};
            piece->origins = rimOrigins(*piece, files_[static_cast<std::size_t>(piece->file)]->up);
        }
    }

private:
    void proposeIds() {
        const std::vector<FileId> ofFile = fileIds(files_);
        std::map<std::uint64_t, std::uint64_t> alike;  // parts of one face of the file
        for (const auto& piece : uncut_) {
            const int face = piece->sourceFace.empty() ? -1 : piece->sourceFace.front();
            const std::uint64_t hash =
                hashOf({ofFile[static_cast<std::size_t>(piece->file)].value,
                        static_cast<std::uint64_t>(face), piece->sourceFace.size()});
            proposed_.push_back({hashOf({hash, alike[hash]++})});
        }
    }

    bool takeProposed(std::size_t i) {
        const auto found = byId_.find(proposed_[i]);
        if (found == byId_.end()) {
            return false;
        }
        take(i, found->second);
        return true;
    }

    void take(std::size_t i, std::size_t k) {
        uncut_[i]->id = known_[k].id;
        taken_.insert(known_[k].id);
        isFree_[k] = 0;
    }

    void matchOthers(const std::vector<std::size_t>& unknown) {
        std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
        for (const std::size_t i : unknown) {
            const KnownPiece now =
                knownBy(*uncut_[i], *files_[static_cast<std::size_t>(uncut_[i]->file)]);
            for (std::size_t k = 0; k < known_.size(); ++k) {
                if (isFree_[k] != 0 && known_[k].file == now.file) {
                    if (const auto cost = unlikeness(known_[k], now)) {
                        pairs.emplace_back(*cost, i, k);
                    }
                }
            }
        }
        std::ranges::sort(pairs);
        for (const auto& [cost, i, k] : pairs) {
            if (!uncut_[i]->id && isFree_[k] != 0) {
                take(i, k);
            }
        }
    }

    std::vector<std::shared_ptr<Piece>>& uncut_;
    const std::vector<std::shared_ptr<const SourceFile>>& files_;
    const std::vector<KnownPiece>& known_;
    std::map<PieceId, std::size_t> byId_;  ///< known ones
    std::vector<char> isFree_;             ///< likewise
    std::vector<PieceId> proposed_;
    std::set<PieceId> taken_;
};

}  // namespace

std::vector<FileId> fileIds(const std::vector<std::shared_ptr<const SourceFile>>& files) {
    std::map<std::uint64_t, std::uint64_t> times;
    std::vector<FileId> ids;
    for (const auto& file : files) {
        const std::uint64_t content = file->soup->contentHash.value_or(0);
        ids.push_back({hashOf({content, times[content]++})});
    }
    return ids;
}

std::vector<KnownPiece> knownPieces(const Garment& garment) {
    std::vector<KnownPiece> known;
    for (const auto& piece : garment.uncut) {
        const auto file = static_cast<std::size_t>(piece->file);
        if (file < garment.files.size()) {
            known.push_back(knownBy(*piece, *garment.files[file]));
        }
    }
    return known;
}

void identify(std::vector<std::shared_ptr<Piece>>& uncut,
              const std::vector<std::shared_ptr<const SourceFile>>& files,
              const std::vector<KnownPiece>& known) {
    Identifier(uncut, files, known).run();
}

void nameSubjects(const std::vector<std::shared_ptr<SourceFile>>& files,
                  const std::vector<std::shared_ptr<Piece>>& uncut) {
    std::map<std::string_view, PieceId> byName;  // of one division: names are unique
    for (const auto& piece : uncut) {
        byName.emplace(piece->name, piece->id);
        nameDefect(*piece);
    }
    const std::vector<FileId> ids = fileIds({files.begin(), files.end()});
    for (std::size_t f = 0; f < files.size(); ++f) {
        for (auto& [code, subject, detail] : files[f]->problems) {
            if (subject.kind == Subject::Kind::File) {
                subject.id = ids[f].value;
            } else if (const auto found = byName.find(subject.name); found != byName.end()) {
                subject.id = found->second.value;
            }
        }
    }
}

}  // namespace toile
