// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/proposed_name.h"

#include <QCoreApplication>

namespace toile::app {

namespace {

/// What tailors' cuts are called, but for a number, in the words of the core.
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
                                          QT_TRANSLATE_NOOP("ProposedCut", "ridge"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "dart"),
                                          QT_TRANSLATE_NOOP("ProposedCut", "opening")};

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

}  // namespace toile::app
