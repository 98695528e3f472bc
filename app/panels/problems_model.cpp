// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/problems_model.h"

#include <QFont>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/panels/remedies.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"
#include "core/diagnose/finding.h"

namespace toile::app {
namespace {

QStandardItem* makeItem(const QString& text) {
    auto* item = new QStandardItem(text);
    item->setEditable(false);
    item->setToolTip(text);
    return item;
}

/// The best remedy, if there is one.
QStandardItem* makeHelp(const Finding& finding, const CutPlan& plan) {
    QStandardItem* item = makeItem({});
    if (const auto remedies = remediesFor(finding, plan); !remedies.empty()) {
        item->setText(remedyText(remedies.front()));
        item->setToolTip(remedyTip(remedies.front()));
        item->setData(static_cast<int>(remedies.front()), ProblemsModel::RemedyRole);
    }
    return item;
}

/// What to try, with reference to the button in the row.
QString adviceBeside(const Finding& finding, const CutPlan& plan) {
    if (finding.kind == FindingKind::NotFlat && isOfUnpreparedScan(finding, *plan.garment)) {
        return ProblemsModel::tr("Prepare the scan first: Garment > Treat file as > Scan");
    }
    const auto remedies = remediesFor(finding, plan);
    const bool hasCut = std::ranges::find(remedies, Remedy::CutOpen) != remedies.end();
    return hasCut ? ProblemsModel::tr("Cut it along a seam, or use Piece > Cut open")
                  : problemAdvice(finding);
}

/// Identifies a finding, even after the list is rebuilt.
QString keyOf(const Finding& finding) {
    const auto& [kind, id, name] = finding.subject;
    return QString("%1 %2 %3 ")
               .arg(static_cast<int>(finding.kind))
               .arg(finding.error ? static_cast<int>(finding.error->code) : -1)
               .arg(static_cast<int>(kind)) +
           QString::fromStdString(id != 0 ? idText(id) : name);
}

}  // namespace

ProblemsModel::ProblemsModel(QObject* parent) : QStandardItemModel(0, ColumnCount, parent) {}

void ProblemsModel::show(const Readiness& readiness, const CutPlan& plan,
                         const std::set<Severity>& shown) {
    clear();
    setHorizontalHeaderLabels({tr("Where"), tr("Problem"), tr("Remedy"), tr("Advice")});
    const auto& findings = readiness.findings;
    // Findings are sorted, so those of one severity and kind are adjacent.
    for (std::size_t i = 0; i < findings.size();) {
        std::vector<int> group;
        const Finding& first = findings[i];
        for (; i < findings.size() && findings[i].severity == first.severity &&
               findings[i].kind == first.kind;
             ++i) {
            group.push_back(static_cast<int>(i));
        }
        if (shown.contains(first.severity)) {
            addGroup(readiness, plan, group);
        }
    }
}

void ProblemsModel::addGroup(const Readiness& readiness, const CutPlan& plan,
                             const std::vector<int>& group) {
    const auto finding = [&readiness](int index) -> const Finding& {
        return readiness.findings[static_cast<std::size_t>(index)];
    };
    const Finding& first = finding(group.front());
    if (group.size() == 1 || first.kind == FindingKind::Message) {
        for (std::size_t k = 0; k < group.size() && k < kMaxRows; ++k) {
            appendRow(rowOf(finding(group[k]), plan, group[k]));
        }
        return;
    }
    const Row parent = rowOfGroup(first, plan, group);
    for (std::size_t k = 0; k < group.size(); ++k) {
        if (k == kMaxRows) {
            auto* rest =
                makeItem(tr("and %1 more")
                             .arg(QLocale().toString(static_cast<qlonglong>(group.size() - k))));
            rest->setFlags(Qt::NoItemFlags);
            parent.front()->appendRow(rest);
            break;
        }
        Row row = rowOf(finding(group[k]), plan, group[k]);
        row[Advice]->setText({});  // the group row has it
        parent.front()->appendRow(row);
    }
    appendRow(parent);
}

ProblemsModel::Row ProblemsModel::rowOf(const Finding& finding, const CutPlan& plan, int index) {
    const QString name = QString::fromStdString(finding.subject.name);
    Row row{makeItem(name.isEmpty() ? tr("Whole garment") : name), makeItem(problemText(finding)),
            makeHelp(finding, plan), makeItem(adviceBeside(finding, plan))};
    row[Where]->setIcon(severityMark(finding.severity));
    row[Where]->setData(QVariant::fromValue(QList<int>{index}), FindingsRole);
    row[Where]->setData(keyOf(finding), KeyRole);
    return row;
}

ProblemsModel::Row ProblemsModel::rowOfGroup(const Finding& first, const CutPlan& plan,
                                             const std::vector<int>& group) {
    const auto size = static_cast<qlonglong>(group.size());
    const QString where = QString::fromStdString(first.subject.name);
    Row row{makeItem(tr("%1 (%2)").arg(problemTitle(first.kind), QLocale().toString(size))),
            makeItem(first.figures.empty() ? problemText(first) : tr("Worst: %1").arg(where)),
            makeHelp(first, plan), makeItem(adviceBeside(first, plan))};
    row[Where]->setIcon(severityMark(first.severity));
    row[Where]->setData(QVariant::fromValue(QList<int>(group.begin(), group.end())), FindingsRole);
    row[Where]->setData(static_cast<int>(first.kind), KindRole);
    row[Where]->setData(QString::number(static_cast<int>(first.kind)), KeyRole);
    return row;
}

namespace {

QString withCapital(QString text) {
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString figureText(const Figure& figure) {
    constexpr double kPercent = 100, kFineUpTo = 10;
    switch (figure.unit) {
        case Figure::Unit::Length:
            return std::abs(figure.value) < kFineUpTo
                       ? fineLength(figure.value) + ' ' + lengthUnit()
                       : lengthWithUnit(figure.value);
        case Figure::Unit::Percent:
            return signedNumber(kPercent * figure.value, 1).remove('+') + tr(" %");
        case Figure::Unit::Strain:
            return signedNumber(kPercent * figure.value, 1) + tr(" %");
        case Figure::Unit::Angle:
            return angleWithUnit(figure.value);
        case Figure::Unit::Count:
            return QLocale().toString(figure.value, 'f', 0);
    }
    return {};
}

void paintNote(QPainter& painter) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(62, 120, 190));
    painter.drawEllipse(QRectF(3, 3, 26, 26));
    painter.setPen(QPen(Qt::white, 3.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(16, 15), QPointF(16, 22.5));
    painter.drawLine(QPointF(16, 9.4), QPointF(16, 9.9));
}

}  // namespace

QString problemText(const Finding& finding) {
    const char* pattern = patternOf(finding);
    if (*pattern == '\0' && finding.error) {
        return withCapital(errorDescription(*finding.error));
    }
    return withCapital(filledIn(tr(pattern), [&finding](int number) {
        const auto at = static_cast<std::size_t>(number);
        return number == 0                    ? wordingText(finding.reason)
               : at <= finding.figures.size() ? figureText(finding.figures[at - 1])
                                              : QString();
    }));
}

QString problemAdvice(const Finding& finding) {
    const char* words = findingWords(finding.kind).advice;
    return finding.error ? errorAdvice(*finding.error) : *words ? tr(words) : QString();
}

QString problemTitle(FindingKind kind) {
    return tr(findingWords(kind).title);
}

QString severityCount(Severity severity, int count) {
    switch (severity) {
        case Severity::Fault:
            return count == 0   ? tr("no errors")
                   : count == 1 ? tr("1 error")
                                : tr("%1 errors").arg(QLocale().toString(count));
        case Severity::Doubt:
            return count == 0   ? tr("no warnings")
                   : count == 1 ? tr("1 warning")
                                : tr("%1 warnings").arg(QLocale().toString(count));
        case Severity::Note:
            return count == 0   ? tr("no notes")
                   : count == 1 ? tr("1 note")
                                : tr("%1 notes").arg(QLocale().toString(count));
    }
    return {};
}

QString verdictLine(const Readiness& readiness) {
    const int faults = readiness.count(Severity::Fault), doubts = readiness.count(Severity::Doubt);
    const auto both = [](const QString& one, const QString& other) -> QString {
        return withCapital(tr("%1, %2").arg(one, other));
    };
    switch (readiness.verdict()) {
        case Verdict::NotFlattened:
            return tr("Not flattened yet");
        case Verdict::Faults:
            return doubts == 0 ? withCapital(severityCount(Severity::Fault, faults))
                               : both(severityCount(Severity::Fault, faults),
                                      severityCount(Severity::Doubt, doubts));
        case Verdict::Doubts:
            return both(severityCount(Severity::Fault, 0), severityCount(Severity::Doubt, doubts));
        case Verdict::Ready:
            break;
    }
    return tr("Ready to cut");
}

QIcon severityMark(Severity severity) {
    switch (severity) {
        case Severity::Fault:
            return fitMark(SeamFit::Differs);
        case Severity::Doubt:
            return fitMark(SeamFit::Nearly);
        case Severity::Note:
            return paintedMark(paintNote);
    }
    return {};
}

QIcon verdictMark(const Readiness& readiness) {
    switch (readiness.verdict()) {
        case Verdict::NotFlattened:
        case Verdict::Doubts:
            return severityMark(Severity::Doubt);
        case Verdict::Faults:
            return severityMark(Severity::Fault);
        case Verdict::Ready:
            break;
    }
    return fitMark(SeamFit::Matches);
}

}  // namespace toile::app
