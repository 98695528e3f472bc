// SPDX-License-Identifier: GPL-3.0-or-later
// What a person asks of cuts, joins and ease.
#include <algorithm>
#include <utility>

#include "app/actions/workspace.h"
#include "core/base/file.h"
#include "core/pipeline/file_space.h"
#include "core/seam/seam_origin.h"
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

}  // namespace

void Workspace::divideByWhatIsThere(LoadOptions& loading) {
    if (loading.seams.cuts.empty() && loading.split == SplitMode::Seams) {
        loading.split = SplitMode::Auto;
    }
}

std::optional<Error> Workspace::objectionTo(const Garment& garment, DocumentState& rest) {
    const std::vector<std::string> tried = std::exchange(onTrial_, {});
    const auto isTried = [&tried](const std::string& name) {
        return std::ranges::find(tried, name) != tried.end();
    };
    std::optional<Error> objection;
    for (const Error& problem : garment.problems) {
        SeamsFile& seams = rest.inputs.loading.seams;
        const bool isCut = problem.code == ErrorCode::CutImpossible;
        if ((isCut || problem.code == ErrorCode::JoinImpossible) && isTried(problem.subject.name)) {
            isCut ? std::erase_if(
                        seams.cuts,
                        [&](const UserCut& cut) { return cut.name == problem.subject.name; })
                  : std::erase_if(seams.joins, [&](const UserJoin& join) {
                        return join.name == problem.subject.name;
                    });
            objection = problem;
        }
    }
    return objection;
}

void Workspace::changeSeams(const QString& text, std::function<void(SeamsFile&)> change) {
    changeLoading({text, [change = std::move(change)](LoadOptions& options) {
                       change(options.seams);
                       giveIds(options.seams.cuts);
                       divideByWhatIsThere(options);
                   }});
}

Result<Problems> Workspace::readSeams(const std::filesystem::path& path) {
    Problems notes;
    auto read = readSeamsFile(path, &notes);
    if (!read) {
        return read.error();
    }
    changeLoading({tr("Seams from a file"), [read = std::move(*read)](LoadOptions& options) {
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

void Workspace::addCut(UserCut cut) {
    if (!document_.garment() || opening_.isActive()) {
        return;  // it was drawn on what is about to go
    }
    const auto [text, stem] = [&cut]() -> std::pair<QString, std::string> {
        switch (cut.kind) {
            case UserCut::Kind::Dart:
                return {tr("Dart"), "dart"};
            case UserCut::Kind::Loop:
                return {tr("Closed loop"), "loop"};
            case UserCut::Kind::Path:
                break;
        }
        return {tr("Cut"), "cut"};
    }();
    cut.name = freeName(loading().seams.cuts, stem, true);
    for (Eigen::Vector3d& point : cut.points) {
        point = inFileSpace(point, loading().seams, *document_.garment());
    }
    onTrial_.push_back(cut.name);
    changeSeams(text, [cut = std::move(cut)](SeamsFile& seams) { seams.cuts.push_back(cut); });
}

void Workspace::joinSeam(int seam) {
    const auto garment = document_.garment();
    if (!garment || opening_.isActive()) {
        return;
    }
    const Seam& chosen = garment->seams.seams[static_cast<std::size_t>(seam)];
    if (chosen.kind == SeamKind::Free) {
        emit refused(tr("%1 is sewn to nothing: there is nothing to join.")
                         .arg(QString::fromStdString(chosen.name)));
        return;
    }
    for (const AppliedCut& cut : garment->cuts) {
        if (std::ranges::find(chosen.cuts, cut.id) == chosen.cuts.end()) {
            continue;
        }
        if (cut.author == CutAuthor::Automatic) {
            emit refused(
                tr("%1 cannot be joined alone: Toile cut %2 open there because it could "
                   "not lie flat. Switch off Garment ▸ Cut open automatically, or draw a "
                   "cut of your own instead.")
                    .arg(QString::fromStdString(chosen.name), QString::fromStdString(cut.piece)));
            return;
        }
    }
    if (!chosen.cuts.empty()) {
        changeSeams(tr("Removal of a cut"), [cuts = chosen.cuts](SeamsFile& seams) {
            std::erase_if(seams.cuts, [&cuts](const UserCut& cut) {
                return std::ranges::find(cuts, cut.id) != cuts.end();
            });
        });
        return;
    }
    UserJoin join = joinAlong(chosen, garment->pieces);
    join.name = freeName(loading().seams.joins, join.name, false);
    for (Eigen::Vector3d& point : join.points) {
        point = inFileSpace(point, loading().seams, *garment);
    }
    onTrial_.push_back(join.name);
    changeSeams(tr("Join"),
                [join = std::move(join)](SeamsFile& seams) { seams.joins.push_back(join); });
}

void Workspace::removeCut(CutId id) {
    if (opening_.isActive()) {
        return;  // what comes may be the same garment, cut in another way
    }
    changeSeams(tr("Removal of a cut"), [id](SeamsFile& seams) {
        std::erase_if(seams.cuts, [id](const UserCut& cut) { return cut.id == id; });
    });
}

void Workspace::removeJoin(const std::string& name) {
    if (opening_.isActive()) {
        return;
    }
    changeSeams(tr("Removal of a join"), [name](SeamsFile& seams) {
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
