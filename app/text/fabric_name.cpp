// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/fabric_name.h"

#include <QCoreApplication>
#include <utility>

namespace toile::app {

namespace {

/// Translation context.
class FabricWords {
    Q_DECLARE_TR_FUNCTIONS(FabricName)
};

}  // namespace

QString fabricName(const Fabric& fabric) {
    const std::pair<const char*, QString> names[] = {
        {"unstated", FabricWords::tr("not set")},
        {"woven", FabricWords::tr("woven")},
        {"denim", FabricWords::tr("denim")},
        {"canvas", FabricWords::tr("canvas")},
        {"jersey", FabricWords::tr("jersey")},
        {"spandex", FabricWords::tr("spandex")},
        {"neoprene", FabricWords::tr("neoprene")},
        {"leather", FabricWords::tr("leather")},
        {"faux-leather", FabricWords::tr("faux leather")},
        {"eva-foam", FabricWords::tr("EVA foam")},
    };
    if (fabricPreset(fabric.id)) {
        for (const auto& [id, name] : names) {
            if (fabric.id == id) {
                return name;
            }
        }
        return QString::fromStdString(fabric.id);
    }
    return FabricWords::tr("custom");
}

}  // namespace toile::app
