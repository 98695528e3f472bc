// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/garment_summary.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <vector>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/session/cut_proposals.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "core/assemble/cut_pieces.h"
#include "core/project/layer_materials.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

namespace {

/// Heights from here on exceed any garment and are shown in metres; mm.
constexpr double kMetresFrom = 10000;

QString symbolOf(const FileUnit& unit) {
    const auto named = unit.named();
    return named ? QString::fromUtf8(symbol(*named))
                 : tr("1 = %1 mm").arg(QLocale().toString(unit.millimetres(), 'g', 4));
}

QString wordOf(const FileUnit& unit) {
    if (!unit.named()) {
        return tr("units of %1 mm").arg(QLocale().toString(unit.millimetres(), 'g', 4));
    }
    switch (*unit.named()) {
        case LengthUnit::Millimetre:
            return tr("millimetres");
        case LengthUnit::Centimetre:
            return tr("centimetres");
        case LengthUnit::Decimetre:
            return tr("decimetres");
        case LengthUnit::Metre:
            return tr("metres");
        case LengthUnit::Inch:
            return tr("inches");
    }
    return {};
}

QString divisionWord(SplitMode mode) {
    switch (mode) {
        case SplitMode::Auto:
        case SplitMode::Components:
            return tr("by connected parts");
        case SplitMode::Objects:
            return tr("by objects");
        case SplitMode::Groups:
            return tr("by groups");
        case SplitMode::Materials:
            return tr("by materials");
        case SplitMode::Uv:
            return tr("by UV islands");
        case SplitMode::Seams:
            return tr("by cuts");
    }
    return {};
}

/// A height as text: "1.48 m", "58.3 in"; "14.8 m" from `kMetresFrom`, whatever the unit.
QString heightText(double millimetres) {
    return millimetres >= kMetresFrom
               ? tr("%1 m").arg(QLocale().toString(millimetres / 1000, 'f', 1))
               : saidLength(millimetres);
}

/// Size of the bounding box of a file's pieces, mm.
Eigen::Vector3d extentsOf(const Document& document, int file) {
    Eigen::AlignedBox3d box;
    const auto& pieces = document.garment()->pieces;
    const auto& drawn = document.scene()->pieces;
    for (std::size_t i = 0; i < std::min(pieces.size(), drawn.size()); ++i) {
        if (pieces[i]->file == file) {
            box.extend(drawn[i].box);
        }
    }
    return box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.sizes());
}

CardQuestion askUnit(const SourceFile& file, const Eigen::Vector3d& extents, Workspace& workspace) {
    const double perUnit = millimetresPer(file.unit);
    CardQuestion question{
        tr("The garment is %1 tall if the file is in %2 (largest extent %3). Is that right?")
            .arg(heightText(extents.y()), wordOf(file.unit),
                 QLocale().toString(extents.maxCoeff() / perUnit, 'g', 4))};
    for (const LengthUnit unit : kLengthUnits) {
        const QString height = heightText(extents.y() / perUnit * millimetresPer(unit));
        question.choices.push_back({QString("%1: %2").arg(symbolOf(unit), height),
                                    unit == file.unit,
                                    [&workspace, unit] { workspace.setUnit(unit); }});
    }
    if (extents.y() > 0) {
        const double height = extents.y() / perUnit;
        question.other = {tr("or the garment is"), tr("tall"), extents.y(),
                          [&workspace, height](double typed) {
                              if (const auto unit = FileUnit::ofMillimetres(typed / height)) {
                                  workspace.setUnit(unit);
                              }
                          }};
    }
    return question;
}

CardQuestion askUpAxis(const SourceFile& file, Workspace& workspace) {
    const bool isY = file.up == UpAxis::Y;
    const QString sentence =
        !file.upInDoubt ? tr("Which of the file's axes points up?")
        : isY ? tr("Toile assumes that y points up, but it may be z. Which axis points up?")
              : tr("Toile assumes that z points up, but it may be y. Which axis points up?");
    return {sentence,
            {{tr("y up"), isY, [&workspace] { workspace.setUpAxis(UpAxis::Y); }},
             {tr("z up"), !isY, [&workspace] { workspace.setUpAxis(UpAxis::Z); }}}};
}

QString kindText(const FileReading& reading) {
    switch (reading.kind) {
        case FileKind::Sheet:
            return tr("a plain sheet");
        case FileKind::Shell:
            return tr("a thick shell");
        case FileKind::Scan:
            return tr("a scan");
        case FileKind::Layers:
            return tr("layers of cloth");
        case FileKind::Solid:
            return tr("a solid");
        case FileKind::Soup:
            return tr("loose triangles, joined");
    }
    return {};
}

/// The pieces of a file that cuts can open.
std::vector<int> openableOf(const Garment& garment, int file) {
    std::vector<int> found;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        if (garment.pieces[i]->file == file && isOpenable(*garment.pieces[i])) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

/// Empty if no piece needs cutting open any more.
CardQuestion askSolid(const Garment& garment, int index, Workspace& workspace) {
    const std::vector<int> pieces = openableOf(garment, index);
    if (pieces.empty()) {
        return {};
    }
    Preparation asIs = workspace.loading().preparing;
    asIs.as = FileKind::Solid;
    return {tr("The file is a closed shape: %1. It needs cuts before it can lie flat.")
                .arg(wordingText(garment.files[static_cast<std::size_t>(index)]->reading.evidence)),
            {{tr("Propose cuts…"), false,
              [&workspace, pieces] {
                  workspace.document().setSelection({pieces.begin(), pieces.end()});
                  workspace.proposals().open();
              }},
             {tr("Cut open"), false, [&workspace, pieces] { workspace.cuts().openPieces(pieces); }},
             {tr("Leave unchanged"), false, [&workspace, asIs] { workspace.setPreparing(asIs); }}}};
}

/// Empty if the file is not half a garment, or was completed.
CardQuestion askHalf(const SourceFile& file, Workspace& workspace) {
    const auto& half = file.reading.half;
    if (!half || half->isCompleted) {
        return {};
    }
    Preparation completed = workspace.loading().preparing;
    completed.isHalf = true;
    return {
        tr("This looks like half a garment: %1 of its rims lie in one plane. Add the mirror image?")
            .arg(saidLength(half->length)),
        {{tr("Complete"), false, [&workspace, completed] { workspace.setPreparing(completed); }},
         {tr("Leave unchanged"), true}}};
}

/// Asks which layers of a file to cut.
CardQuestion askLayers(const FileReading& reading, Workspace& workspace) {
    constexpr int kListed = 4;
    const int count = layerCount(reading);
    CardQuestion question{
        count == 1
            ? tr("The file may contain layers of cloth: %1. Which is it?")
                  .arg(wordingText(reading.evidence))
            : tr("The file contains %1 layers of cloth: %2. Which layers do you want to cut?")
                  .arg(count)
                  .arg(wordingText(reading.evidence))};
    const auto add = [&](const QString& text, bool present, FileKind kind, int only = 0) {
        Preparation preparing = workspace.loading().preparing;
        preparing.as = kind;
        preparing.onlyLayer = only;
        question.choices.push_back(
            {text, present, [&workspace, preparing] { workspace.setPreparing(preparing); }});
    };
    if (count == 1) {
        add(tr("Layers"), false, FileKind::Layers);
    } else {
        add(tr("All"), true, FileKind::Layers);
    }
    for (int layer = 1; count > 1 && layer <= std::min(count, kListed); ++layer) {
        const QString text = layer == 1   ? tr("Outer only")
                             : count == 2 ? tr("Inner only")
                                          : tr("Layer %1 only").arg(layer);
        add(text, false, FileKind::Layers, layer);
    }
    add(count == 1 ? tr("Leave unchanged") : tr("No layers"), false, FileKind::Sheet);
    return question;
}

/// Empty if the file is a plain sheet or the user has set how to read it.
CardQuestion askReading(const SourceFile& file, Workspace& workspace,
                        const std::function<void()>& prepareScan) {
    const FileReading& reading = file.reading;
    const auto choice = [&workspace](const QString& text, bool present, FileKind kind,
                                     ShellSurface surface = ShellSurface::Outer) {
        Preparation preparing = workspace.loading().preparing;
        preparing.as = kind;
        preparing.surface = surface;
        preparing.onlyLayer = 0;
        return CardChoice{text, present,
                          [&workspace, preparing] { workspace.setPreparing(preparing); }};
    };
    if (reading.isStated) {
        return {};
    }
    const QString evidence = wordingText(reading.evidence);
    if (reading.kind == FileKind::Shell) {
        CardQuestion question{
            tr("The file is cloth with a thickness: %1. Which side is the pattern for?")
                .arg(evidence)};
        for (const auto& [surface, text] : {std::pair(ShellSurface::Outer, tr("Outer")),
                                            std::pair(ShellSurface::Inner, tr("Inner")),
                                            std::pair(ShellSurface::Middle, tr("Middle"))}) {
            question.choices.push_back(choice(
                text, surface == workspace.loading().preparing.surface, FileKind::Shell, surface));
        }
        question.choices.push_back(choice(tr("Leave unchanged"), false, FileKind::Sheet));
        return question;
    }
    if (reading.kind == FileKind::Layers) {
        return askLayers(reading, workspace);
    }
    if (reading.kind == FileKind::Scan) {
        return {tr("The file looks like a scan: %1. Prepare it to remove debris, close small holes "
                   "and smooth noise.")
                    .arg(evidence),
                {{tr("Prepare the scan…"), false, prepareScan},
                 choice(tr("Leave unchanged"), false, FileKind::Sheet)}};
    }
    return {};
}

QString divideBy(SplitMode mode) {
    switch (mode) {
        case SplitMode::Objects:
            return tr("Split by objects");
        case SplitMode::Groups:
            return tr("Split by groups");
        case SplitMode::Materials:
            return tr("Split by materials");
        case SplitMode::Uv:
            return tr("Split by UV islands");
        default:
            return tr("Split by connected parts");
    }
}

/// Empty if all pieces can lie flat, or the better division would not make more of them flat.
CardQuestion askDivision(const Garment& garment, int index, Workspace& workspace) {
    const SourceFile& file = *garment.files[index];
    int pieces = 0, flat = 0;
    for (const auto& piece : garment.pieces) {
        pieces += piece->file == index;
        flat += piece->file == index && !piece->defect;
    }
    const DivisionCount& better = *file.betterSplit;
    if (pieces == flat || flat >= better.flat) {
        return {};
    }
    return {tr("Split %1, only %2 of %3 pieces can lie flat. Split %4, %5 of %6 could.")
                .arg(divisionWord(file.split.mode))
                .arg(flat)
                .arg(pieces)
                .arg(divisionWord(better.mode))
                .arg(better.flat)
                .arg(better.pieces),
            {{divideBy(better.mode), false,
              [&workspace, mode = better.mode] { workspace.setSplit(mode); }}}};
}

}  // namespace

QString garmentSummary(const Document& document) {
    if (!document.garment() || !document.scene()) {
        return {};
    }
    QStringList units, divisions;
    for (const auto& file : document.garment()->files) {
        const QString unit = symbolOf(file->unit);
        units << (file->unitReason.empty() ? unit
                  : file->soup->statedUnit ? tr("%1 (from the file)").arg(unit)
                                           : tr("%1 (guessed)").arg(unit));
        divisions << divisionWord(file->split.mode);
    }
    units.removeDuplicates();
    divisions.removeDuplicates();
    const int count = document.pieceCount();
    const double height = document.scene()->box.isEmpty() ? 0 : document.scene()->box.sizes().y();
    return tr("height %1 · %2 · %3 %4")
        .arg(heightText(height), units.join(", "),
             count == 1 ? tr("1 piece") : tr("%1 pieces").arg(count), divisions.join(", "));
}

QString garmentReasons(const Document& document) {
    if (!document.garment()) {
        return {};
    }
    QStringList lines;
    const auto& files = document.garment()->files;
    for (const auto& file : files) {
        if (files.size() > 1) {
            lines << textOf(file->path.filename());
        }
        const auto add = [&lines](const QString& what, const Wording& reason,
                                  const QString& stated) {
            lines << tr("%1: %2").arg(what, reason.empty() ? stated : wordingText(reason));
        };
        add(tr("Unit"), file->unitReason, tr("%1, set by you").arg(wordOf(file->unit)));
        add(tr("Up axis"), file->upReason,
            file->up == UpAxis::Y ? tr("y, set by you") : tr("z, set by you"));
        if (file->reading.kind != FileKind::Sheet || file->reading.isStated) {
            const Wording& evidence = file->reading.evidence;
            lines << tr("%1: %2").arg(tr("Treated as"),
                                      evidence.empty() ? kindText(file->reading)
                                                       : tr("%1: %2").arg(kindText(file->reading),
                                                                          wordingText(evidence)));
        }
        if (file->reading.half && file->reading.half->isCompleted) {
            lines << tr("Half a garment: Toile added the mirror image");
        }
        add(tr("Pieces"), file->split.reason,
            tr("%1, set by you").arg(divisionWord(file->split.mode)));
    }
    return lines.join('\n');
}

namespace {

/// Offers to make mirrored pieces equal if they differ too much to do so automatically.
CardQuestion askSymmetry(Workspace& workspace) {
    Document& document = workspace.document();
    const Symmetry* symmetry = document.derived().symmetry.get();
    if (document.state().lines.mirror != Mirror::Close || !symmetry || symmetry->unequal.empty()) {
        return {};
    }
    const auto& unequal = symmetry->unequal;
    const auto& worst = *std::ranges::max_element(unequal, {}, &UnequalPieces::difference);
    const std::size_t others = unequal.size() - 1;
    const QString seams =
        GarmentCard::tr("%1 and %2 differ by %3 (tolerance %4).")
            .arg(seamName(document, worst.seam), seamName(document, worst.mirrored),
                 lengthWithUnit(worst.difference), lengthWithUnit(worst.tolerance));
    const QString pieces =
        worst.piece == worst.counterpart
            ? GarmentCard::tr("The two halves of %1 are not equal.")
                  .arg(pieceName(document, worst.piece))
            : GarmentCard::tr("%1 and %2 are not equal.")
                  .arg(pieceName(document, worst.piece), pieceName(document, worst.counterpart));
    QStringList sentences{pieces, seams};
    if (others > 0) {
        sentences << (others == 1
                          ? GarmentCard::tr("One more piece or pair differs by less.")
                          : GarmentCard::tr("%1 more pieces or pairs differ by less.").arg(others));
    }
    const auto makeEqual = [&document] {
        LineSettings lines = document.state().lines;
        lines.mirror = Mirror::Mean;
        document.setLines(std::move(lines), GarmentCard::tr("Make mirrored pieces equal"));
    };
    return {sentences.join(' '),
            {{GarmentCard::tr("Make equal"), false, makeEqual},
             {GarmentCard::tr("Keep as in the file"), true, {}}}};
}

}  // namespace

GarmentQuestions garmentQuestions(Workspace& workspace, const std::function<void()>& prepareScan,
                                  Asked asked) {
    const Document& document = workspace.document();
    GarmentQuestions questions;
    if (!document.garment() || !document.scene()) {
        return questions;
    }
    const bool always = asked == Asked::Always;
    int index = 0;
    for (const auto& file : document.garment()->files) {
        if (questions.reading.choices.empty()) {
            questions.reading = file->reading.kind == FileKind::Solid && !file->reading.isStated
                                    ? askSolid(*document.garment(), index, workspace)
                                    : askReading(*file, workspace, prepareScan);
        }
        if (questions.half.choices.empty()) {
            questions.half = askHalf(*file, workspace);
        }
        if ((file->unitInDoubt || always) && questions.unit.choices.empty()) {
            questions.unit = askUnit(*file, extentsOf(document, index), workspace);
        }
        if ((file->upInDoubt || always) && questions.up.choices.empty()) {
            questions.up = askUpAxis(*file, workspace);
        }
        if (file->betterSplit && questions.division.choices.empty()) {
            questions.division = askDivision(*document.garment(), index, workspace);
        }
        ++index;
    }
    questions.symmetry = askSymmetry(workspace);
    return questions;
}

}  // namespace toile::app
