// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/garment_summary.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "app/actions/workspace.h"
#include "app/base/text.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre,
                                 LengthUnit::Inch};
/// From here on metres are easier to read.
constexpr double kMetresFrom = 10000;

QString symbolOf(LengthUnit unit) {
    return QString::fromUtf8(symbol(unit));
}

QString wordOf(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Millimetre:
            return tr("millimetres");
        case LengthUnit::Centimetre:
            return tr("centimetres");
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
            return tr("by parts");
        case SplitMode::Objects:
            return tr("by objects");
        case SplitMode::Groups:
            return tr("by groups");
        case SplitMode::Materials:
            return tr("by materials");
        case SplitMode::Uv:
            return tr("by UV");
        case SplitMode::Seams:
            return tr("by cuts");
    }
    return {};
}

/// "15 mm", "1225 mm", "48 1/4 in"; "14.8 m" whatever the unit, since no garment is meant then.
QString heightText(double millimetres) {
    const QLocale locale;
    if (millimetres >= kMetresFrom) {
        return tr("%1 m").arg(locale.toString(millimetres / 1000, 'f', 1));
    }
    if (lengthUnit() == "mm" && millimetres >= 10) {  // a tenth is beyond what a height is told for
        return QString("%1 mm").arg(qRound(millimetres));
    }
    return lengthWithUnit(millimetres);
}

/// Box of the pieces of one file, mm.
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
        tr("The garment measures %1 in height, read as %2 (largest extent %3). Is that right?")
            .arg(lengthWithUnit(extents.y()), wordOf(file.unit),
                 QLocale().toString(extents.maxCoeff() / perUnit, 'g', 4))};
    for (const LengthUnit unit : kUnits) {
        const QString height = heightText(extents.y() / perUnit * millimetresPer(unit));
        question.choices.push_back({QString("%1: %2").arg(symbolOf(unit), height),
                                    unit == file.unit,
                                    [&workspace, unit] { workspace.setUnit(unit); }});
    }
    return question;
}

CardQuestion askUpAxis(const SourceFile& file, Workspace& workspace) {
    const bool isY = file.up == UpAxis::Y;
    return {isY ? tr("The garment was read as standing along y, but it may stand "
                     "along z. Which axis points up?")
                : tr("The garment was read as standing along z, but it may stand "
                     "along y. Which axis points up?"),
            {{tr("y up"), isY, [&workspace] { workspace.setUpAxis(UpAxis::Y); }},
             {tr("z up"), !isY, [&workspace] { workspace.setUpAxis(UpAxis::Z); }}}};
}

}  // namespace

QString garmentSummary(const Document& document) {
    if (!document.garment() || !document.scene()) {
        return {};
    }
    QStringList units, divisions;
    for (const auto& file : document.garment()->files) {
        const QString unit = symbolOf(file->unit);
        units << (file->unitReason.empty() ? unit : tr("%1 (guessed)").arg(unit));
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
        add(tr("Unit"), file->unitReason, tr("%1, as stated").arg(wordOf(file->unit)));
        add(tr("Up axis"), file->upReason,
            file->up == UpAxis::Y ? tr("y, as stated") : tr("z, as stated"));
        add(tr("Pieces"), file->split.reason,
            tr("%1, as stated").arg(divisionWord(file->split.mode)));
    }
    return lines.join('\n');
}

GarmentQuestions garmentQuestions(Workspace& workspace) {
    const Document& document = workspace.document();
    GarmentQuestions questions;
    if (!document.garment() || !document.scene()) {
        return questions;
    }
    int index = 0;
    for (const auto& file : document.garment()->files) {
        if (file->unitInDoubt && questions.unit.choices.empty()) {
            questions.unit = askUnit(*file, extentsOf(document, index), workspace);
        }
        if (file->upInDoubt && questions.up.choices.empty()) {
            questions.up = askUpAxis(*file, workspace);
        }
        ++index;
    }
    return questions;
}

}  // namespace toile::app
