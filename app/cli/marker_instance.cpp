// SPDX-License-Identifier: GPL-3.0-or-later
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/marker_interruptible.h"
#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/text.h"
#include "core/nest/instance_file.h"
#include "core/nest/nest.h"

namespace toile::app {

int runMarkerOfInstance(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    const MarkerArguments& typed = arguments.marker;
    auto instance = readNestInstance(arguments.inputs.front());
    if (!instance) {
        return refuse(instance.error(), err);
    }
    NestOptions options;
    options.seed = typed.settings.seed;
    options.gap = typed.settings.gap;
    options.border = typed.settings.border;
    options.threads = typed.threads;
    const Stopwatch watch;
    Progress progress;
    const Interruptible interruptible(progress);
    auto nester = Nester::make(std::move(*instance), options, progress);
    if (!nester) {
        return refuse(nester.error(), err);
    }
    const NestResult& best = nester->best();
    while (!best.optimal && !progress.isCancelled() &&
           isToGoOn(typed, best.rounds, watch.seconds())) {
        nester->step(progress);
    }
    out << "length " << fixed(best.length, 3) << " mm, use " << fixed(100 * best.use, 2) << " %, "
        << counted(best.rounds, "round") << (best.optimal ? ", which is the shortest" : "") << '\n';
    std::vector<std::filesystem::path> files = arguments.outputs;
    if (!typed.report.empty()) {
        files.push_back(typed.report);
    }
    for (const auto& path : files) {
        const std::string text = path == typed.report
                                     ? nestReport(nester->instance(), options, best)
                                     : nestPicture(nester->instance(), best);
        if (const auto written = writeFile(path, text); !written) {
            return refuse(written.error(), err);
        }
    }
    out.flush();
    return !out ? kExitUnreadable : best.valid ? kExitDone : kExitSomeFailed;
}

}  // namespace toile::app
