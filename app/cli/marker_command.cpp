// SPDX-License-Identifier: GPL-3.0-or-later
#include <ostream>
#include <string>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/nest/instance_file.h"
#include "core/nest/nest.h"
#include "core/nest/nest_writer.h"

namespace toile::app {
namespace {

constexpr double kUsualSeconds = 5;

int refuseMarker(const Error& error, std::ostream& err) {
    err << "toile: " << sentence(error) << '\n';
    return kExitUnreadable;
}

/// Whether to go on: until the rounds are done or the time is up, whichever was typed.
bool isToGoOn(const MarkerArguments& typed, int rounds, double seconds) {
    const bool hasRounds = !typed.rounds || rounds < *typed.rounds;
    const double most = typed.seconds.value_or(typed.rounds ? seconds + 1 : kUsualSeconds);
    return hasRounds && seconds < most;
}

}  // namespace

int runMarker(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    const MarkerArguments& typed = arguments.marker;
    auto instance = readNestInstance(arguments.inputs.front());
    if (!instance) {
        return refuseMarker(instance.error(), err);
    }
    NestOptions options;
    options.seed = typed.seed;
    options.gap = typed.gap;
    options.border = typed.border;
    options.threads = typed.threads;
    const Stopwatch watch;
    const Progress progress;
    auto nester = Nester::make(std::move(*instance), options, progress);
    if (!nester) {
        return refuseMarker(nester.error(), err);
    }
    const NestResult& best = nester->best();
    while (!best.optimal && isToGoOn(typed, best.rounds, watch.seconds())) {
        nester->step(progress);
    }
    out << "length " << fixed(best.length, 3) << " mm, use " << fixed(100 * best.use, 2) << " %, "
        << counted(best.rounds, "round") << (best.optimal ? ", no nest is shorter" : "") << '\n';
    for (const auto& path : arguments.outputs) {
        const bool isPicture = path.extension() == ".svg" || path.extension() == ".SVG";
        const std::string text = isPicture ? nestPicture(nester->instance(), best)
                                           : nestReport(nester->instance(), options, best);
        if (const auto written = writeFile(path, text); !written) {
            return refuseMarker(written.error(), err);
        }
    }
    out.flush();
    return !out ? kExitUnreadable : best.valid ? kExitDone : kExitSomeFailed;
}

}  // namespace toile::app
