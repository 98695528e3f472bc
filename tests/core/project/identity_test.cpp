// SPDX-License-Identifier: GPL-3.0-or-later
// What a person has said of a piece or a seam stays with it, whatever else is done.
#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "core/project/piece_settings.h"
#include "core/project/project_file.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// An OBJ file whose vertices, and whose faces within each object, come in another order. Names
/// go: pieces are told apart by where they are.
std::string renumbered(const std::string& obj, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::string> positions;
    std::vector<std::vector<std::string>> blocks(1);
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("v ")) {
            positions.push_back(line);
        } else if (line.starts_with("o ")) {
            blocks.emplace_back();
        } else if (line.starts_with("f ")) {
            blocks.back().push_back(line);
        }
    }
    std::vector<std::size_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::shuffle(order, random);
    std::vector<std::size_t> newIndex(order.size());
    std::string text;
    for (std::size_t k = 0; k < order.size(); ++k) {
        newIndex[order[k]] = k + 1;
        text += positions[order[k]] + '\n';
    }
    std::ranges::shuffle(blocks, random);
    int object = 0;
    for (auto& block : blocks) {
        std::ranges::shuffle(block, random);
        text += "o part" + std::to_string(++object) + '\n';
        for (const std::string& line : block) {
            std::istringstream corners(line.substr(2));
            text += 'f';
            for (std::string corner; corners >> corner;) {
                text += ' ' + std::to_string(newIndex[std::stoul(corner) - 1]);
            }
            text += '\n';
        }
    }
    return text;
}

/// An ease that was typed, and where: the line in space, and the pieces of the division beside it.
struct Typed {
    Points3 line;
    std::set<PieceId> uncut;
    PieceId left;
    double ease = 0;
    std::vector<CutId> cuts;  ///< two may lie in one place
};

/// All that undo brings back.
struct State {
    Garment garment;
    LoadOptions loading;
    std::vector<PieceSettings> settings;
    PieceLabels labels;
    std::vector<Typed> typed;
    std::map<PieceId, std::string> names;  ///< likewise typed
};

double distanceTo(const Points3& line, const Eigen::RowVector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const Eigen::RowVector3d a = line.row(i - 1), b = line.row(i);
        least = std::min(least, geometry::distanceToSegment(point, a, b));
    }
    return least;
}

double lengthOf(const Points3& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1))
        .rowwise()
        .norm()
        .sum();
}

class Editor {
public:
    Editor(std::string obj, unsigned seed)
        : obj_(std::move(obj)), random_(seed), reloads_(seed % 2 == 0) {
        path_ = folder_.write("a.obj", obj_);
        state_.loading.unit = LengthUnit::Millimetre;
        Progress progress;
        state_.garment = *loadGarment({path_}, state_.loading, progress);
        state_.settings.resize(state_.garment.pieces.size());
        state_.labels = withColours({}, nullptr, state_.garment);
        for (std::size_t i = 0; i < state_.settings.size(); ++i) {
            PieceSettings& said = state_.settings[i];
            said.quantity = 10 + static_cast<int>(i);
            said.grain = 0.1 * static_cast<double>(i);
            said.placement = Placement{{1000.0 * static_cast<double>(i), 0}, 0.3};
            said.placedByHand = true;
            said_[state_.garment.pieces[i]->id] = said;
            colours_[state_.garment.pieces[i]->id] = static_cast<int>(i);
        }
        for (int k = 0; k < 3; ++k) {
            typeEase();
        }
    }

    void edit() {
        switch (upTo(8)) {
            case 0:
                return removeCut();
            case 1:
                return undo();
            case 2:
                return closeAndOpen();
            case 3:
                return reloads_ ? reload() : rename();
            case 4:
                return rename();
            case 5:
                return typeEase();
            default:
                return cut();
        }
    }

    const std::string& lastEdit() const { return last_; }
    std::size_t cuts() const { return state_.loading.seams.cuts.size(); }

    void expectAllIsKept() {
        const Garment& garment = state_.garment;
        std::set<PieceId> ids;
        std::set<std::string> names;
        std::set<int> colours;
        const std::vector<int> colourOf = coloursOf(state_.labels, garment);
        for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
            const Piece& piece = *garment.pieces[i];
            EXPECT_TRUE(ids.insert(piece.id).second) << piece.name;
            ASSERT_EQ(piece.lineage.uncut.size(), 1U);
            const auto said = said_.find(piece.lineage.uncut.front());
            ASSERT_NE(said, said_.end()) << piece.name;
            const PieceSettings& now = state_.settings[i];
            EXPECT_EQ(now.quantity, said->second.quantity) << piece.name;
            EXPECT_EQ(now.grain, said->second.grain) << piece.name;
            EXPECT_EQ(now.placement, said->second.placement) << piece.name;
            EXPECT_EQ(now.placedByHand, said->second.placedByHand) << piece.name;
            EXPECT_TRUE(colours.insert(colourOf[i]).second) << piece.name;
            if (piece.lineage.sides.empty()) {
                EXPECT_EQ(colourOf[i], colours_.at(piece.id)) << piece.name;
            }
            EXPECT_TRUE(names.insert(nameOf(state_.labels, piece)).second)
                << "two are called " << nameOf(state_.labels, piece);
            const auto name = state_.names.find(piece.id);
            EXPECT_TRUE(name == state_.names.end() ? isInherited(piece)
                                                   : nameOf(state_.labels, piece) == name->second)
                << piece.name << " is called " << nameOf(state_.labels, piece);
        }
        std::set<SeamId> seamIds;
        for (const Seam& seam : garment.seams.seams) {
            EXPECT_TRUE(seamIds.insert(seam.id).second) << seam.name;
            // Of one that grew when a cut was taken back, less than all may have been said.
            if (seam.kind != SeamKind::Free && !hasGrown(seam)) {
                const auto expected = expectedEase(seam);
                ASSERT_EQ(seam.ease.has_value(), expected.has_value()) << seam.name;
                EXPECT_NEAR(seam.ease.value_or(0), expected.value_or(0), 1e-12) << seam.name;
            }
        }
    }

private:
    /// Its own name; or the one that the piece it was cut from was given, and a number of each cut.
    bool isInherited(const Piece& piece) const {
        const std::string& shown = nameOf(state_.labels, piece);
        for (int k = 1; k <= count_; ++k) {
            const std::string given = "name " + std::to_string(k);
            if (shown.starts_with(given) &&
                shown.find_first_not_of(" 0123456789", given.size()) == std::string::npos) {
                return true;
            }
        }
        return shown == piece.name;
    }

    int upTo(std::size_t count) { return static_cast<int>(random_() % count); }

    PieceId uncutOf(const SeamSide& side) const {
        return state_.garment.pieces[static_cast<std::size_t>(side.piece)]->lineage.uncut.front();
    }

    Points3 lineOf(const Seam& seam) const {
        return spaceLine(seam.left,
                         *state_.garment.pieces[static_cast<std::size_t>(seam.left.piece)]);
    }

    /// By where the middle of the seam lies, which no edit moves.
    std::optional<double> expectedEase(const Seam& seam) const {
        const Points3 line = lineOf(seam);
        const Eigen::Index k = line.rows() / 2;  // within an edge: vertices may be shared
        const Eigen::RowVector3d middle = 0.5 * (line.row(k - 1) + line.row(k));
        std::optional<double> ease;
        for (const Typed& typed : state_.typed) {
            const std::set<PieceId> uncut{uncutOf(seam.left), uncutOf(seam.right)};
            if (typed.uncut == uncut && typed.cuts == seam.cuts &&
                distanceTo(typed.line, middle) < 1e-6) {
                const bool turned =
                    uncut.size() > 1 ? uncutOf(seam.left) != typed.left : seam.ease.value_or(0) < 0;
                ease = turned ? 1 / (1 + typed.ease) - 1 : typed.ease;
            }
        }
        return ease;
    }

    bool hasGrown(const Seam& seam) const {
        return std::ranges::any_of(state_.typed, [&](const Typed& typed) {
            const Points3 line = lineOf(seam);
            const Eigen::RowVector3d middle = typed.line.row(typed.line.rows() / 2);
            return distanceTo(line, middle) < 1e-6 && lengthOf(line) > lengthOf(typed.line) + 1e-6;
        });
    }

    void become(Garment garment, const LoadOptions& loading) {
        const auto from = carriedFrom(state_.garment, state_.settings, {}, garment);
        past_.push_back(state_);
        state_.settings = carriedSettings(from, state_.settings);
        state_.labels = withColours(state_.labels, &state_.garment, garment);
        state_.loading = resolveNames(loading, garment);
        state_.garment = std::move(garment);
    }

    void recut(const LoadOptions& loading) {
        Progress progress;
        become(*cutGarment(state_.garment, loading, progress), loading);
    }

    void cut() {
        last_ = "cut";
        const Piece& piece =
            *state_.garment.pieces[static_cast<std::size_t>(upTo(state_.garment.pieces.size()))];
        LoadOptions loading = state_.loading;
        UserCut& cut = loading.seams.cuts.emplace_back();
        cut.name = "cut " + std::to_string(++count_);
        const auto place = [&](int vertex) {
            cut.points.emplace_back(piece.mesh.V.row(vertex).transpose());
        };
        const bool parts = upTo(3) > 0;
        place(piece.boundary[static_cast<std::size_t>(upTo(piece.boundary.size()))]);
        place(parts ? piece.boundary[static_cast<std::size_t>(upTo(piece.boundary.size()))]
                    : upTo(static_cast<std::size_t>(piece.mesh.V.rows())));
        recut(loading);
    }

    void removeCut() {
        last_ = "remove cut";
        LoadOptions loading = state_.loading;
        if (!loading.seams.cuts.empty()) {
            loading.seams.cuts.erase(loading.seams.cuts.begin() + upTo(loading.seams.cuts.size()));
            recut(loading);
        }
    }

    void undo() {
        last_ = "undo";
        if (!past_.empty()) {
            state_ = past_.back();
            past_.pop_back();
        }
    }

    void closeAndOpen() {
        last_ = "close and open";
        Project project;
        project.files = meshReferences(state_.garment);
        project.loading = state_.loading;
        project.loading.known = knownPieces(state_.garment);
        project.pieces = projectPieces(state_.garment, state_.settings, {});
        project.labels = state_.labels;
        const auto read = parseProject(projectText(project, "/"), "a.toile", "/");
        ASSERT_TRUE(read);
        Progress progress;
        auto garment = loadGarment({path_}, read->project.loading, progress);
        ASSERT_TRUE(garment);
        past_.push_back(state_);
        state_.settings = settingsFor(read->project, *garment);
        state_.labels = withColours(read->project.labels, nullptr, *garment);
        state_.loading = resolveNames(read->project.loading, *garment);
        state_.garment = std::move(*garment);
    }

    void reload() {
        last_ = "reload with other numbers";
        path_ = folder_.write("a.obj", renumbered(obj_, static_cast<unsigned>(random_())));
        LoadOptions loading = state_.loading;
        loading.known = knownPieces(state_.garment);
        Progress progress;
        auto garment =
            makeGarment({*readFiles({path_}, progress), loading}, progress, {}, &state_.garment);
        ASSERT_TRUE(garment);
        become(std::move(*garment), loading);
        past_.clear();  // the file is not what it was
    }

    void rename() {
        last_ = "rename";
        past_.push_back(state_);
        const auto& piece =
            state_.garment.pieces[static_cast<std::size_t>(upTo(state_.settings.size()))];
        const std::string name = "name " + std::to_string(++count_);
        state_.labels[piece->id].name = name;
        state_.names[piece->id] = name;
    }

    void typeEase() {
        last_ = "type ease";
        std::vector<int> sewn;
        for (std::size_t s = 0; s < state_.garment.seams.seams.size(); ++s) {
            const Seam& seam = state_.garment.seams.seams[s];
            // With other numbers a cut may go another way that is as short.
            if (seam.kind == SeamKind::Seam && !seam.stacked && !seam.ease &&
                (seam.cuts.empty() || !reloads_)) {
                sewn.push_back(static_cast<int>(s));
            }
        }
        if (sewn.empty()) {
            return;
        }
        past_.push_back(state_);
        Seam& seam =
            state_.garment.seams
                .seams[static_cast<std::size_t>(sewn[static_cast<std::size_t>(upTo(sewn.size()))])];
        const double ease = 0.01 * ++count_;
        state_.loading.seamSettings = withEase(state_.loading.seamSettings, seam, ease);
        state_.typed.push_back({lineOf(seam),
                                {uncutOf(seam.left), uncutOf(seam.right)},
                                uncutOf(seam.left),
                                ease,
                                seam.cuts});
        seam.ease = ease;
    }

    const std::string obj_;
    test::TemporaryFolder folder_;
    std::filesystem::path path_;
    std::mt19937 random_;
    const bool reloads_;
    State state_;
    std::vector<State> past_;
    std::map<PieceId, PieceSettings> said_;  ///< per piece of the division
    std::map<PieceId, int> colours_;
    int count_ = 0;
    std::string last_;
};

class Identity : public testing::TestWithParam<unsigned> {};

TEST_P(Identity, WhatWasSaidStaysThroughRandomEdits) {
    std::ifstream file(test::dataFile("samples/tshirt.obj"));
    std::ostringstream obj;
    obj << file.rdbuf();
    Editor editor(renumbered(obj.str(), 0), GetParam());
    std::string edits;
    for (int k = 0; k < 40 && !HasFailure(); ++k) {
        if (editor.cuts() < 8) {
            editor.edit();
        }
        edits += editor.lastEdit() + ", ";
        SCOPED_TRACE(edits);
        editor.expectAllIsKept();
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Identity, testing::Range(1U, 13U));

}  // namespace
}  // namespace toile
