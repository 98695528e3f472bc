// SPDX-License-Identifier: GPL-3.0-or-later
// What a person asks of cuts, joins and ease.
#include <algorithm>
#include <utility>

#include "app/document/mirrored_edits.h"
#include "app/document/names.h"
#include "app/jobs/job.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"
#include "core/assemble/cut_pieces.h"
#include "core/assemble/file_space.h"
#include "core/base/file.h"
#include "core/cut/loop_around.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/mirrored_edit.h"
#include "core/seam/seam_settings.h"

namespace toile::app {
namespace {

/// "cut 3": the first that no entry has.
template <class Entry>
std::string freeName(const std::vector<Entry>& entries, const std::string& stem, bool numbered) {
    std::string name = stem;
    for (int k = 1; numbered || std::ranges::find(entries, name, &Entry::name) != entries.end();
         ++k) {
        name = stem + " " + std::to_string(k);
        numbered = false;
    }
    return name;
}

struct CutWords {
    QString text;      ///< for the history
    QString ofPiece;   ///< with %1 for the piece
    std::string stem;  ///< of its name, which is the person's
};

CutWords wordsOf(UserCut::Kind kind) {
    switch (kind) {
        case UserCut::Kind::Dart:
            return {Workspace::tr("Cut dart"), Workspace::tr("Cut dart in %1"),
                    Workspace::tr("dart").toStdString()};
        case UserCut::Kind::Loop:
            return {Workspace::tr("Cut closed loop"), Workspace::tr("Cut closed loop in %1"),
                    Workspace::tr("loop").toStdString()};
        case UserCut::Kind::Path:
            break;
    }
    return {Workspace::tr("Cut"), Workspace::tr("Cut %1"), Workspace::tr("cut").toStdString()};
}

/// By the name of the first of these cuts: the others are its mirror images, or stood in one line.
QString textOfRemoval(const SeamsFile& seams, const std::vector<CutId>& ids) {
    const auto cut = std::ranges::find_if(seams.cuts, [&ids](const UserCut& known) {
        return std::ranges::find(ids, known.id) != ids.end();
    });
    return cut == seams.cuts.end()
               ? Workspace::tr("Remove cut")
               : Workspace::tr("Remove %1").arg(QString::fromStdString(cut->name));
}

/// Fewer triangles, and cuts are found within some milliseconds.
constexpr Eigen::Index kQuickTriangles = 2000;

/// Whether a mirror image is found at once: within some milliseconds.
bool isSmall(const Garment& garment) {
    constexpr Eigen::Index kTriangles = 20'000;
    Eigen::Index count = 0;
    for (const auto& piece : garment.pieces) {
        count += piece->mesh.F.rows();
    }
    return count <= kTriangles;
}

}  // namespace

void Workspace::divideByWhatIsThere(LoadOptions& loading) {
    if (loading.seams.cuts.empty() && loading.split == SplitMode::Seams) {
        loading.split = SplitMode::Auto;
    }
}

std::optional<Error> Workspace::objectionTo(const Garment& garment, DocumentState& rest) {
    const std::vector<Trial> tried = std::exchange(onTrial_, {});
    SeamsFile& seams = rest.inputs.loading.seams;
    std::optional<Error> objection;
    for (const Error& problem : garment.problems) {
        const bool isCut = problem.code == ErrorCode::CutImpossible;
        const auto trial = std::ranges::find_if(tried, [&problem](const Trial& one) {
            return one.name == problem.subject.name || one.image == problem.subject.name;
        });
        if (trial == tried.end() || !(isCut || problem.code == ErrorCode::JoinImpossible)) {
            continue;
        }
        if (isCut) {
            std::erase_if(seams.cuts, [trial](const UserCut& cut) {
                return cut.name == trial->name || cut.name == trial->image;
            });
        } else {
            std::erase_if(seams.joins,
                          [trial](const UserJoin& join) { return join.name == trial->name; });
        }
        objection = problem;
        isImageRefused_ = isCut && problem.subject.name == trial->image;
    }
    return objection;
}

void Workspace::sayRefused(const Error& why) {
    QString sentence = errorText(why);
    if (std::exchange(isImageRefused_, false)) {
        sentence += ' ' + tr("It is the mirror image of your cut. To cut one side only, switch off "
                             "Tools ▸ Mirror edits.");
    }
    emit refused(sentence);
}

void Workspace::changeSeams(const QString& text, std::function<void(SeamsFile&)> change,
                            int gesture) {
    changeLoading({text,
                   [change = std::move(change)](LoadOptions& options) {
                       change(options.seams);
                       giveIds(options.seams.cuts);
                       divideByWhatIsThere(options);
                   },
                   gesture});
}

Result<Problems> Workspace::readSeams(const std::filesystem::path& path) {
    Problems notes;
    auto read = readSeamsFile(path, &notes);
    if (!read) {
        return read.error();
    }
    changeLoading({tr("Load seams file"), [read = std::move(*read)](LoadOptions& options) {
                       options.seams = read;
                       options.seamSettings.clear();
                       giveIds(options.seams.cuts);
                       divideByWhatIsThere(options);
                   }});
    return notes;
}

Result<void> Workspace::writeSeams(const std::filesystem::path& path) const {
    SeamsFile seams = loading().seams;
    if (document_.garment()) {
        const auto stated = easeByName(document_.garment()->seams);
        seams.ease.insert(stated.begin(), stated.end());
    }
    return writeFile(path, writeSeamsFile(seams));
}

std::optional<UserCut> Workspace::DrawnCut::image(const Progress& progress) const {
    return symmetry ? mirroredCut(*garment, results, *symmetry, cut, progress) : std::nullopt;
}

void Workspace::addCut(UserCut cut, std::optional<int> piece, const QString& text) {
    if (!document_.garment() || opening_.isActive()) {
        return;  // it was drawn on what is about to go
    }
    DrawnCut drawn{std::move(cut), document_.garment(), loading().seams};
    drawn.isMirrored = mirrorsEdits(document_);
    const CutWords words = wordsOf(drawn.cut.kind);
    drawn.text =
        piece ? stepOf(document_, text.isEmpty() ? words.ofPiece : text, {*piece}) : words.text;
    if (editSymmetry(document_)) {
        drawn.results = document_.results();
        drawn.symmetry = document_.derived().symmetry;
    }
    if (!mirroring_.isBusy() && (!drawn.symmetry || isSmall(*drawn.garment))) {
        makeCut(drawn, drawn.image());
        return;
    }
    mirroring_.start(makeJob(
        tr("Finding the mirror image of a cut"),
        [drawn](Progress& progress) -> Result<std::optional<UserCut>> {
            return drawn.image(progress);
        },
        [this, drawn](std::optional<UserCut> image) { makeCut(drawn, std::move(image)); }));
}

void Workspace::makeCut(const DrawnCut& drawn, std::optional<UserCut> image) {
    if (opening_.isActive()) {
        return;
    }
    if (drawn.isMirrored && !image) {
        emit noted(
            drawn.symmetry
                ? tr("Cut on this side only: there is no mirror image, or a seam is there already.")
                : tr("Cut on this side only: no mirror plane was found."));
    }
    const std::string stem = wordsOf(drawn.cut.kind).stem;
    std::vector<UserCut> named = loading().seams.cuts;
    const auto finish = [&](UserCut& made) {
        made.name = freeName(named, stem, true);
        for (Eigen::Vector3d& point : made.points) {
            point = inFileSpace(point, drawn.seams, *drawn.garment);
        }
        named.push_back(made);
    };
    UserCut cut = drawn.cut;
    finish(cut);
    if (!image) {
        onTrial_.push_back({cut.name});
        changeSeams(drawn.text,
                    [cut = std::move(cut)](SeamsFile& seams) { seams.cuts.push_back(cut); });
        return;
    }
    finish(*image);
    onTrial_.push_back({cut.name, image->name});
    changeSeams(tr("%1 on both sides").arg(drawn.text),
                [cut = std::move(cut), image = std::move(*image)](SeamsFile& seams) {
                    addMirroredCuts(seams.cuts, cut, image);
                });
}

void Workspace::findCuts(const QString& text, bool isQuick,
                         std::function<Result<std::vector<UserCut>>(Progress&)> find,
                         std::function<void(std::vector<UserCut>)> found) {
    if (!isQuick || mirroring_.isBusy()) {
        mirroring_.start(makeJob(text, std::move(find), std::move(found)));
        return;
    }
    Progress progress;
    auto cuts = find(progress);
    if (cuts) {
        found(std::move(*cuts));
    } else {
        emit refused(errorText(cuts.error()));
    }
}

void Workspace::takeCuts(const QString& text, std::vector<UserCut> cuts) {
    std::vector<UserCut> named = loading().seams.cuts;
    for (UserCut& cut : cuts) {
        cut.name = freeName(named, wordsOf(cut.kind).stem, true);
        named.push_back(cut);
    }
    makeCuts(text, std::move(cuts));
}

void Workspace::makeCuts(const QString& text, std::vector<UserCut> cuts, int gesture) {
    if (!document_.garment() || opening_.isActive() || cuts.empty()) {
        return;
    }
    std::vector<UserCut> named = loading().seams.cuts;
    for (UserCut& cut : cuts) {
        cut.name = freeName(named, cut.name, false);
        onTrial_.push_back({cut.name});
        for (Eigen::Vector3d& point : cut.points) {
            point = inFileSpace(point, loading().seams, *document_.garment());
        }
        named.push_back(cut);
    }
    changeSeams(
        text,
        [cuts = std::move(cuts)](SeamsFile& seams) {
            seams.cuts.insert(seams.cuts.end(), cuts.begin(), cuts.end());
        },
        gesture);
}

void Workspace::sayOvertaken() {
    if (document_.garment()) {
        emit refused(tr("The garment changed before the cut was found. Cut again."));
    }
}

void Workspace::cutOpen(const std::vector<int>& pieces) {
    const auto garment = document_.garment();
    if (!garment || opening_.isActive() || pieces.empty()) {
        return;
    }
    std::vector<std::pair<std::shared_ptr<const Piece>, bool>> chosen;
    Eigen::Index triangles = 0;
    for (const int index : pieces) {
        const auto& piece = garment->pieces[static_cast<std::size_t>(index)];
        const bool isWhole = std::ranges::find(garment->uncut, piece) != garment->uncut.end();
        chosen.emplace_back(piece, isWhole);
        triangles += piece->mesh.F.rows();
    }
    const auto find = [chosen](Progress& progress) -> Result<std::vector<UserCut>> {
        std::vector<UserCut> all;
        std::optional<Error> failed;
        for (const auto& [piece, isWhole] : chosen) {
            if (const auto cuts = openingCuts(*piece, isWhole, progress)) {
                all.insert(all.end(), cuts->begin(), cuts->end());
            } else {
                failed = cuts.error();
            }
        }
        // Those that can be opened are, as their findings then tell of the others.
        if (failed && (all.empty() || progress.isCancelled())) {
            return *failed;
        }
        return all;
    };
    findCuts(tr("Finding cuts"), triangles <= kQuickTriangles, find,
             [this, garment](std::vector<UserCut> cuts) {
                 if (document_.garment() == garment && !opening_.isActive()) {
                     takeCuts(tr("Cut open"), std::move(cuts));
                 } else {
                     sayOvertaken();
                 }
             });
}

void Workspace::cutAround(int piece, const SurfacePoint& place) {
    const auto garment = document_.garment();
    if (!garment || opening_.isActive()) {
        return;
    }
    const auto of = garment->pieces[static_cast<std::size_t>(piece)];
    const bool isWhole = std::ranges::find(garment->uncut, of) != garment->uncut.end();
    const auto find = [of, isWhole, place](Progress& progress) -> Result<std::vector<UserCut>> {
        constexpr int kPlaces = 8, kPlacesBesideCuts = 64;  // a shortest way may run across those
        const SurfaceLinks links(of->mesh, of->table);
        const auto loop = loopAround(links, place, progress);
        if (!loop) {
            return loop.error();
        }
        return std::vector<UserCut>{
            {{},
             UserCut::Kind::Loop,
             placesAlong(of->mesh, *loop, isWhole ? kPlaces : kPlacesBesideCuts),
             false}};
    };
    findCuts(tr("Finding a closed loop"), of->mesh.F.rows() <= kQuickTriangles, find,
             [this, garment](std::vector<UserCut> cuts) {
                 if (document_.garment() == garment) {
                     addCut(std::move(cuts.front()));
                 } else {
                     sayOvertaken();
                 }
             });
}

void Workspace::dartToSeam(int seam) {
    const auto garment = document_.garment();
    if (!garment || opening_.isActive() || !document_.isCurrent()) {
        return;
    }
    if (auto cut = cutBeyondDart(*garment, document_.results(), seam)) {
        const int piece = garment->seams.seams[static_cast<std::size_t>(seam)].left.piece;
        addCut(std::move(*cut), piece, tr("Turn dart in %1 into seam"));
    } else {
        const Seam& dart = garment->seams.seams[static_cast<std::size_t>(seam)];
        emit refused(tr("%1 cannot become a seam: its tip points at no edge of its piece.")
                         .arg(QString::fromStdString(dart.name)));
    }
}

std::optional<CutId> Workspace::cutBeyond(int seam) const {
    const auto garment = document_.garment();
    return garment ? cutBeyondTip(*garment, seam) : std::nullopt;
}

bool Workspace::isSeamOfDart(int seam) const {
    return cutBeyond(seam).has_value();
}

void Workspace::seamToDart(int seam) {
    const auto cut = cutBeyond(seam);
    if (cut && !opening_.isActive()) {
        changeSeams(tr("Turn %1 into dart").arg(seamName(document_, seam)), removalOf({*cut}));
    }
}

std::function<void(SeamsFile&)> Workspace::removalOf(std::vector<CutId> cuts) const {
    return [cuts = std::move(cuts), both = mirrorsEdits(document_)](SeamsFile& seams) {
        const std::vector<CutId> gone = both ? withMirrorImages(seams.cuts, cuts) : cuts;
        std::erase_if(seams.cuts, [&gone](const UserCut& cut) {
            return std::ranges::find(gone, cut.id) != gone.end();
        });
    };
}

void Workspace::joinSeam(int seam) {
    const auto garment = document_.garment();
    if (!garment || opening_.isActive()) {
        return;
    }
    const Seam& chosen = garment->seams.seams[static_cast<std::size_t>(seam)];
    if (chosen.kind == SeamKind::Free) {
        emit refused(tr("%1 is a free edge, so it cannot be joined.")
                         .arg(QString::fromStdString(chosen.name)));
        return;
    }
    for (const AppliedCut& cut : garment->cuts) {
        if (std::ranges::find(chosen.cuts, cut.id) == chosen.cuts.end()) {
            continue;
        }
        if (cut.author == CutAuthor::Automatic) {
            emit refused(
                tr("%1 cannot be joined: Toile cut %2 open there so that it lies flat. Switch off "
                   "Garment ▸ Cut open automatically, or draw your own cut.")
                    .arg(QString::fromStdString(chosen.name), QString::fromStdString(cut.piece)));
            return;
        }
    }
    if (!chosen.cuts.empty()) {
        changeSeams(textOfRemoval(loading().seams, chosen.cuts), removalOf(chosen.cuts));
        return;
    }
    UserJoin join = joinAlong(chosen, garment->pieces);
    join.name = freeName(loading().seams.joins, join.name, false);
    for (Eigen::Vector3d& point : join.points) {
        point = inFileSpace(point, loading().seams, *garment);
    }
    onTrial_.push_back({join.name});
    changeSeams(tr("Join %1").arg(seamName(document_, seam)),
                [join = std::move(join)](SeamsFile& seams) { seams.joins.push_back(join); });
}

void Workspace::removeCut(CutId id) {
    if (opening_.isActive()) {
        return;  // what comes may be the same garment, cut in another way
    }
    changeSeams(textOfRemoval(loading().seams, {id}), removalOf({id}));
}

void Workspace::removeJoin(const std::string& name) {
    if (opening_.isActive()) {
        return;
    }
    changeSeams(tr("Remove join %1").arg(QString::fromStdString(name)), [name](SeamsFile& seams) {
        const auto join = std::ranges::find(seams.joins, name, &UserJoin::name);
        if (join != seams.joins.end()) {
            seams.joins.erase(join);
        }
    });
}

void Workspace::setEase(int seam, std::optional<double> ease) {
    document_.setSeamEase(seam, ease);
}

}  // namespace toile::app
