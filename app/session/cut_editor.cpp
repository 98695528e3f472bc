// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/cut_editor.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
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

/// "cut 3": the first name that no entry has.
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
    std::string stem;  ///< of its name
};

CutWords wordsOf(UserCut::Kind kind) {
    switch (kind) {
        case UserCut::Kind::Dart:
            return {CutEditor::tr("Cut dart"), CutEditor::tr("Cut dart in %1"),
                    CutEditor::tr("dart").toStdString()};
        case UserCut::Kind::Loop:
            return {CutEditor::tr("Cut closed loop"), CutEditor::tr("Cut closed loop in %1"),
                    CutEditor::tr("loop").toStdString()};
        case UserCut::Kind::Path:
            break;
    }
    return {CutEditor::tr("Cut"), CutEditor::tr("Cut %1"), CutEditor::tr("cut").toStdString()};
}

/// Names the first of these cuts: the others are its mirror images, or lie on one line with it.
QString textOfRemoval(const SeamsFile& seams, const std::vector<CutId>& ids) {
    const auto cut = std::ranges::find_if(seams.cuts, [&ids](const UserCut& known) {
        return std::ranges::find(ids, known.id) != ids.end();
    });
    return cut == seams.cuts.end()
               ? CutEditor::tr("Remove cut")
               : CutEditor::tr("Remove %1").arg(QString::fromStdString(cut->name));
}

/// With fewer triangles, cuts are found within some milliseconds.
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

/// Without cuts there are no seams to divide by.
void divideByWhatIsThere(LoadOptions& loading) {
    if (loading.seams.cuts.empty() && loading.split == SplitMode::Seams) {
        loading.split = SplitMode::Auto;
    }
}

}  // namespace

CutEditor::CutEditor(Workspace& workspace)
    : workspace_(workspace), document_(workspace.document()) {
    connect(&document_, &Document::opened, this, [this] {
        pending_.clear();
        searches_.cancel();
    });
    connect(&document_, &Document::changed, this, [this] {
        if (document_.isCurrent()) {
            pending_.clear();
        }
    });
}

std::shared_ptr<const Garment> CutEditor::openGarment() const {
    return workspace_.isOpening() ? nullptr : document_.garment();
}

std::optional<Error> CutEditor::objectionTo(const Garment& garment, DocumentState& rest) {
    const std::vector<Pending> tried = std::exchange(pending_, {});
    SeamsFile& seams = rest.inputs.loading.seams;
    std::optional<Error> objection;
    for (const Error& problem : garment.problems) {
        const bool isCut = problem.code == ErrorCode::CutImpossible;
        const auto trial = std::ranges::find_if(tried, [&problem](const Pending& one) {
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

void CutEditor::refuse(const Error& why) {
    QString sentence = errorText(why);
    if (std::exchange(isImageRefused_, false)) {
        sentence += ' ' + tr("It is the mirror image of your cut. To cut one side only, switch off "
                             "Tools ▸ Mirror edits.");
    }
    emit refused(sentence);
}

void CutEditor::change(const QString& text, std::function<void(SeamsFile&)> edit, int gesture) {
    workspace_.changeLoading({text,
                              [edit = std::move(edit)](LoadOptions& options) {
                                  edit(options.seams);
                                  giveIds(options.seams.cuts);
                                  divideByWhatIsThere(options);
                              },
                              gesture});
}

Result<Problems> CutEditor::readSeams(const std::filesystem::path& path) {
    Problems notes;
    auto read = readSeamsFile(path, &notes);
    if (!read) {
        return read.error();
    }
    workspace_.changeLoading(
        {tr("Load seams file"), [read = std::move(*read)](LoadOptions& options) {
             options.seams = read;
             options.seamSettings.clear();
             giveIds(options.seams.cuts);
             divideByWhatIsThere(options);
         }});
    return notes;
}

Result<void> CutEditor::writeSeams(const std::filesystem::path& path) const {
    SeamsFile seams = workspace_.loading().seams;
    if (document_.garment()) {
        const auto stated = easeByName(document_.garment()->seams);
        seams.ease.insert(stated.begin(), stated.end());
    }
    return writeFile(path, writeSeamsFile(seams));
}

std::optional<UserCut> CutEditor::DrawnCut::image(const Progress& progress) const {
    return symmetry ? mirroredCut(*garment, results, *symmetry, cut, progress) : std::nullopt;
}

void CutEditor::add(UserCut cut, std::optional<int> piece, const QString& text) {
    if (!openGarment()) {
        return;  // it was drawn on a garment that is being replaced
    }
    DrawnCut drawn{std::move(cut), openGarment(), workspace_.loading().seams};
    drawn.isMirrored = mirrorsEdits(document_);
    const CutWords words = wordsOf(drawn.cut.kind);
    drawn.text =
        piece ? stepOf(document_, text.isEmpty() ? words.ofPiece : text, {*piece}) : words.text;
    if (editSymmetry(document_)) {
        drawn.results = document_.results();
        drawn.symmetry = document_.derived().symmetry;
    }
    if (!searches_.isBusy() && (!drawn.symmetry || isSmall(*drawn.garment))) {
        make(drawn, drawn.image());
        return;
    }
    searches_.start(makeJob(
        tr("Finding the mirror image of a cut"),
        [drawn](Progress& progress) -> Result<std::optional<UserCut>> {
            return drawn.image(progress);
        },
        [this, drawn](std::optional<UserCut> image) { make(drawn, std::move(image)); }));
}

void CutEditor::make(const DrawnCut& drawn, std::optional<UserCut> image) {
    if (!openGarment()) {
        return;
    }
    if (drawn.isMirrored && !image) {
        emit noted(
            drawn.symmetry
                ? tr("Cut on this side only: there is no mirror image, or a seam is there already.")
                : tr("Cut on this side only: no mirror plane was found."));
    }
    const std::string stem = wordsOf(drawn.cut.kind).stem;
    std::vector<UserCut> named = workspace_.loading().seams.cuts;
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
        pending_.push_back({cut.name});
        change(drawn.text, [cut = std::move(cut)](SeamsFile& seams) { seams.cuts.push_back(cut); });
        return;
    }
    finish(*image);
    pending_.push_back({cut.name, image->name});
    change(tr("%1 on both sides").arg(drawn.text),
           [cut = std::move(cut), image = std::move(*image)](SeamsFile& seams) {
               addMirroredCuts(seams.cuts, cut, image);
           });
}

void CutEditor::search(const QString& text, bool isQuick,
                       std::function<Result<std::vector<UserCut>>(Progress&)> find,
                       std::function<void(std::vector<UserCut>)> found) {
    if (!isQuick || searches_.isBusy()) {
        searches_.start(makeJob(text, std::move(find), std::move(found)));
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

void CutEditor::makeAll(const QString& text, std::vector<UserCut> cuts, int gesture) {
    if (!openGarment() || cuts.empty()) {
        return;
    }
    std::vector<UserCut> named = workspace_.loading().seams.cuts;
    for (UserCut& cut : cuts) {
        // Unnamed ones are called by their kind.
        cut.name =
            freeName(named, cut.name.empty() ? wordsOf(cut.kind).stem : cut.name, cut.name.empty());
        pending_.push_back({cut.name});
        for (Eigen::Vector3d& point : cut.points) {
            point = inFileSpace(point, workspace_.loading().seams, *document_.garment());
        }
        named.push_back(cut);
    }
    change(
        text,
        [cuts = std::move(cuts)](SeamsFile& seams) {
            seams.cuts.insert(seams.cuts.end(), cuts.begin(), cuts.end());
        },
        gesture);
}

void CutEditor::refuseStale() {
    if (document_.garment()) {
        emit refused(tr("The garment changed before the cut was found. Cut again."));
    }
}

void CutEditor::openPieces(const std::vector<int>& pieces) {
    const auto garment = openGarment();
    if (!garment || pieces.empty()) {
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
        // Open those that can be opened: findings tell about the others.
        if (failed && (all.empty() || progress.isCancelled())) {
            return *failed;
        }
        return all;
    };
    search(tr("Finding cuts"), triangles <= kQuickTriangles, find,
           [this, garment](std::vector<UserCut> cuts) {
               if (openGarment() == garment) {
                   makeAll(tr("Cut open"), std::move(cuts));
               } else {
                   refuseStale();
               }
           });
}

void CutEditor::cutAround(int piece, const SurfacePoint& place) {
    const auto garment = openGarment();
    if (!garment) {
        return;
    }
    const auto of = garment->pieces[static_cast<std::size_t>(piece)];
    const bool isWhole = std::ranges::find(garment->uncut, of) != garment->uncut.end();
    const auto find = [of, isWhole, place](Progress& progress) -> Result<std::vector<UserCut>> {
        constexpr int kPlaces = 8, kPlacesBesideCuts = 64;  // shortest paths may cross those
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
    search(tr("Finding a closed loop"), of->mesh.F.rows() <= kQuickTriangles, find,
           [this, garment](std::vector<UserCut> cuts) {
               if (document_.garment() == garment) {
                   add(std::move(cuts.front()));
               } else {
                   refuseStale();
               }
           });
}

void CutEditor::dartToSeam(int seam) {
    const auto garment = openGarment();
    if (!garment || !document_.isCurrent()) {
        return;
    }
    if (auto cut = cutBeyondDart(*garment, document_.results(), seam)) {
        const int piece = garment->seams.seams[static_cast<std::size_t>(seam)].left.piece;
        add(std::move(*cut), piece, tr("Turn dart in %1 into seam"));
    } else {
        const Seam& dart = garment->seams.seams[static_cast<std::size_t>(seam)];
        emit refused(tr("%1 cannot become a seam: its tip points at no edge of its piece.")
                         .arg(QString::fromStdString(dart.name)));
    }
}

std::optional<CutId> CutEditor::cutBeyond(int seam) const {
    const auto garment = document_.garment();
    return garment ? cutBeyondTip(*garment, seam) : std::nullopt;
}

void CutEditor::seamToDart(int seam) {
    const auto cut = cutBeyond(seam);
    if (cut && openGarment()) {
        change(tr("Turn %1 into dart").arg(seamName(document_, seam)), removalOf({*cut}));
    }
}

std::function<void(SeamsFile&)> CutEditor::removalOf(std::vector<CutId> cuts) const {
    return [cuts = std::move(cuts), both = mirrorsEdits(document_)](SeamsFile& seams) {
        const std::vector<CutId> gone = both ? withMirrorImages(seams.cuts, cuts) : cuts;
        std::erase_if(seams.cuts, [&gone](const UserCut& cut) {
            return std::ranges::find(gone, cut.id) != gone.end();
        });
    };
}

void CutEditor::joinSeam(int seam) {
    const auto garment = openGarment();
    if (!garment) {
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
        change(textOfRemoval(workspace_.loading().seams, chosen.cuts), removalOf(chosen.cuts));
        return;
    }
    UserJoin join = joinAlong(chosen, garment->pieces);
    join.name = freeName(workspace_.loading().seams.joins, join.name, false);
    for (Eigen::Vector3d& point : join.points) {
        point = inFileSpace(point, workspace_.loading().seams, *garment);
    }
    pending_.push_back({join.name});
    change(tr("Join %1").arg(seamName(document_, seam)),
           [join = std::move(join)](SeamsFile& seams) { seams.joins.push_back(join); });
}

void CutEditor::remove(CutId id) {
    if (workspace_.isOpening()) {
        return;  // the garment that comes may be the same one with other cuts
    }
    change(textOfRemoval(workspace_.loading().seams, {id}), removalOf({id}));
}

void CutEditor::removeJoin(const std::string& name) {
    if (workspace_.isOpening()) {
        return;
    }
    change(tr("Remove join %1").arg(QString::fromStdString(name)), [name](SeamsFile& seams) {
        const auto join = std::ranges::find(seams.joins, name, &UserJoin::name);
        if (join != seams.joins.end()) {
            seams.joins.erase(join);
        }
    });
}

}  // namespace toile::app
