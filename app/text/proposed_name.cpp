// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/proposed_name.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace toile::app {

namespace {

/// The core's names of tailors' cuts, without numbers.
constexpr const char* kProposedNames[] = {QT_TRANSLATE_NOOP("ProposedCut", "left side"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right side"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "left underarm"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right underarm"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "left armhole"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right armhole"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "left shoulder"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right shoulder"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "left inseam"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right inseam"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "centre"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "waist"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "style line"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "left style line"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "right style line"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "band"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "ridge"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "dart"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "opening")};

/// The core's names of parts, without their position.
constexpr const char* kPartNames[] = {QT_TRANSLATE_NOOP("ProposedPart", "body"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "front"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "back"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "sleeve"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "leg"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "skirt"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "bodice"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "neck band"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "waistband"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "hem band"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "cuff"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "armhole band")};
/// Words before and after a part's name.
constexpr const char* kPartSides[] = {QT_TRANSLATE_NOOP("ProposedPart", "left %1"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "right %1")};
constexpr const char* kPartFaces[] = {QT_TRANSLATE_NOOP("ProposedPart", "%1 front"),
                                      QT_TRANSLATE_NOOP("ProposedPart", "%1 back")};

QString wordOfPart(const char* word) {
    return QCoreApplication::translate("ProposedPart", word);
}

}  // namespace

std::string proposedName(const std::string& name) {
    for (const char* known : kProposedNames) {
        const std::string stem = known;
        if (name == stem || name.starts_with(stem + ' ')) {
            return QCoreApplication::translate("ProposedCut", known).toStdString() +
                   name.substr(stem.size());
        }
    }
    return name;
}

std::string proposedPartName(const std::string& name) {
    QString part = QString::fromStdString(name), side = QStringLiteral("%1"), face = side;
    for (const char* pattern : kPartSides) {
        const QString before = QString(pattern).section('%', 0, 0);
        if (part.startsWith(before)) {
            part.remove(0, before.size());
            side = wordOfPart(pattern);
        }
    }
    for (const char* pattern : kPartFaces) {
        const QString after = QString(pattern).mid(2);
        if (part.endsWith(after)) {
            part.chop(after.size());
            face = wordOfPart(pattern);
        }
    }
    const auto known = std::ranges::find_if(
        kPartNames, [&part](const char* word) { return part == QLatin1String(word); });
    return known == std::end(kPartNames) ? name
                                         : side.arg(face.arg(wordOfPart(*known))).toStdString();
}

}  // namespace toile::app
