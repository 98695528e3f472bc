// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/problems_model.h"

#include <QFont>
#include <QLocale>

#include "app/panels/problem_text.h"

namespace toile::app {

namespace {

QStandardItem* makeItem(const QString& text) {
    auto* item = new QStandardItem(text);
    item->setEditable(false);
    item->setToolTip(text);
    return item;
}

/// Tells what is found from all else, in the next list too.
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

void ProblemsModel::show(const Readiness& readiness, const std::set<Severity>& shown) {
    clear();
    setHorizontalHeaderLabels({tr("Where"), tr("Problem"), tr("What to try")});
    const auto& findings = readiness.findings;
    // They are in order: those of a severity and kind stand together.
    for (std::size_t i = 0; i < findings.size();) {
        std::vector<int> group;
        const Finding& first = findings[i];
        for (; i < findings.size() && findings[i].severity == first.severity &&
               findings[i].kind == first.kind;
             ++i) {
            group.push_back(static_cast<int>(i));
        }
        if (shown.contains(first.severity)) {
            addGroup(readiness, group);
        }
    }
}

void ProblemsModel::addGroup(const Readiness& readiness, const std::vector<int>& group) {
    const auto finding = [&readiness](int index) -> const Finding& {
        return readiness.findings[static_cast<std::size_t>(index)];
    };
    const Finding& first = finding(group.front());
    if (group.size() == 1 || first.kind == FindingKind::Message) {
        for (std::size_t k = 0; k < group.size() && k < kMostRows; ++k) {
            appendRow(rowOf(finding(group[k]), group[k]));
        }
        return;
    }
    const Row parent = rowOfGroup(first, group);
    for (std::size_t k = 0; k < group.size(); ++k) {
        if (k == kMostRows) {
            auto* rest =
                makeItem(tr("and %1 more")
                             .arg(QLocale().toString(static_cast<qlonglong>(group.size() - k))));
            rest->setFlags(Qt::NoItemFlags);
            parent.front()->appendRow(rest);
            break;
        }
        Row row = rowOf(finding(group[k]), group[k]);
        row[Advice]->setText({});  // said once, over all of them
        parent.front()->appendRow(row);
    }
    appendRow(parent);
}

ProblemsModel::Row ProblemsModel::rowOf(const Finding& finding, int index) {
    Row row{makeItem(QString::fromStdString(finding.subject.name)), makeItem(problemText(finding)),
            makeItem(problemAdvice(finding))};
    row[Where]->setIcon(severityMark(finding.severity));
    row[Where]->setData(QVariant::fromValue(QList<int>{index}), FindingsRole);
    row[Where]->setData(keyOf(finding), KeyRole);
    return row;
}

ProblemsModel::Row ProblemsModel::rowOfGroup(const Finding& first, const std::vector<int>& group) {
    const auto size = static_cast<qlonglong>(group.size());
    const QString where = QString::fromStdString(first.subject.name);
    Row row{makeItem(tr("%1 (%2)").arg(problemTitle(first.kind), QLocale().toString(size))),
            makeItem(first.figures.empty() ? problemText(first) : tr("Worst: %1").arg(where)),
            makeItem(problemAdvice(first))};
    row[Where]->setIcon(severityMark(first.severity));
    row[Where]->setData(QVariant::fromValue(QList<int>(group.begin(), group.end())), FindingsRole);
    row[Where]->setData(static_cast<int>(first.kind), KindRole);
    row[Where]->setData(QString::number(static_cast<int>(first.kind)), KeyRole);
    return row;
}

}  // namespace toile::app
