// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/text/error_text.h"
#include "app/window/main_window.h"
#include "core/formats/formats.h"
#include "tests/app/support/monkey.h"

namespace toile::test {

void Monkey::watchExports() {
    QObject::connect(&window_.workspace().writing(), &JobRunner::failed, &closer_,
                     [this](const QString& title, const QString& sentence) {
                         if (sentence.contains(errorDescription({ErrorCode::NotReadBack}))) {
                             misread_ = title + ": " + sentence;
                         }
                     });
}

void Monkey::exportPattern() {
    Workspace& workspace = window_.workspace();
    const auto count = static_cast<int>(formats().size());
    const Format& format = formats()[static_cast<std::size_t>(random_.whole(0, count - 1))];
    ExportOptions options;
    constexpr DxfProfile kProfiles[] = {DxfProfile::Astm, DxfProfile::Aama, DxfProfile::Plain};
    constexpr Paper kPapers[] = {Paper::A4, Paper::A0, Paper::Roll841, Paper::Projector};
    options.dxf.profile = kProfiles[random_.whole(0, 2)];
    options.pdf.paper = kPapers[random_.whole(0, 3)];
    options.plt.turned = random_.chance(0.5);
    options.png.dpi = 30;
    options.mesh.isExact = random_.chance(0.5);
    note(QString("export %1").arg(format.name));
    if (workspace.canExport() && !workspace.writing().isBusy()) {
        workspace.exportTo(pathOf(folder_ + "/pattern" + format.endings.front()), options);
    }
}

}  // namespace toile::test
