// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/material_menu.h"

#include <QInputDialog>
#include <QMenu>
#include <algorithm>

#include "app/document/document.h"
#include "app/document/piece_edits.h"

namespace toile::app {

namespace {

/// Object name of the entries that refill() replaces.
constexpr auto kEntry = "materialEntry";

std::vector<int> selectedPieces(const Document& document) {
    return {document.selection().begin(), document.selection().end()};
}

QString materialOf(const Document& document, int piece) {
    return QString::fromStdString(document.settings()[static_cast<std::size_t>(piece)].material);
}

}  // namespace

MaterialMenu::MaterialMenu(Document& document, QWidget& window, QObject* parent)
    : QObject(parent), document_(document), window_(window) {}

void MaterialMenu::fill(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { refill(menu); });
    refill(menu);
}

void MaterialMenu::refill(QMenu& menu) {
    for (QAction* entry : menu.findChildren<QAction*>(kEntry, Qt::FindDirectChildrenOnly)) {
        delete entry;
    }
    const auto& selection = document_.selection();
    const auto add = [&](const QString& text, const QString& material) {
        auto* entry = new QAction(text, &menu);
        entry->setObjectName(kEntry);
        entry->setData(material);
        entry->setCheckable(true);
        entry->setChecked(!selection.empty() && std::ranges::all_of(selection, [&](int piece) {
            return materialOf(document_, piece) == material;
        }));
        entry->setEnabled(!selection.empty());
        entry->setStatusTip(tr("Cut the selected pieces from this material"));
        connect(entry, &QAction::triggered, this,
                [this, material] { setMaterial(document_, selectedPieces(document_), material); });
        const auto actions = menu.actions();
        const auto line = std::find_if(actions.rbegin(), actions.rend(),
                                       [](const QAction* action) { return action->isSeparator(); });
        menu.insertAction(line == actions.rend() ? nullptr : *line, entry);
    };
    add(tr("Garment's &fabric"), {});
    for (const Material& material : document_.state().materials) {
        const QString name = QString::fromStdString(material.name);
        add(QString(name).replace('&', "&&"), name);
    }
}

void MaterialMenu::askForNew() {
    const std::vector<int> pieces = selectedPieces(document_);
    if (pieces.empty()) {
        return;
    }
    QStringList names = proposedMaterials();
    for (const Material& material : document_.state().materials) {
        names.removeAll(QString::fromStdString(material.name));
    }
    auto* dialog = new QInputDialog(&window_);
    dialog->setObjectName("newMaterial");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("New material"));
    dialog->setLabelText(tr("Material of %1:").arg(nameOfPieces(document_, pieces)));
    dialog->setComboBoxItems(names);
    dialog->setComboBoxEditable(true);
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.simplified().isEmpty()) {
            setMaterial(document_, selectedPieces(document_), name);
        }
    });
    dialog->open();
}

}  // namespace toile::app
