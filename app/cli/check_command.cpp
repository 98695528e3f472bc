// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/proof_order.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/check/ready_to_cut.h"
#include "core/diagnose/finding.h"
#include "core/project/place_pieces.h"
#include "core/project/project.h"
#include "core/project/rigid_motion.h"
#include "core/prove/proof.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

/// A line for each finding; those that say the same of several pieces or seams share one.
void printFindings(const Readiness& readiness, std::ostream& out) {
    const auto& findings = readiness.findings;
    for (std::size_t i = 0; i < findings.size();) {
        Finding told = findings[i];
        std::string& names = told.subject.name;
        names = shownText(names, kMaxOfPlace);
        for (++i; i < findings.size() && findings[i].severity == told.severity &&
                  findings[i].kind == told.kind && !names.empty() &&
                  description(findings[i]) == description(told) &&
                  adviceFor(findings[i]) == adviceFor(told);
             ++i) {
            names += ", " + shownText(findings[i].subject.name, kMaxOfPlace);
        }
        out << name(told.severity) << ": " << sentence(told) << '\n';
    }
}

/// The pattern sewn back together; null, and why, where it cannot be.
std::shared_ptr<const Proof> proved(const Arguments& arguments, const CutPlan& plan,
                                    Progress& progress, std::ostream& err) {
    const auto ordered = orderOfOwn(arguments, *plan.garment, progress);
    if (const auto* refusal = std::get_if<Refusal>(&ordered)) {
        refuse(*refusal, err);
        return nullptr;
    }
    const FinishedPattern made = finished(arguments, *plan.garment, plan.results);
    const auto proof =
        proofOf(made.source(arguments.exporting), std::get<ProofOrder>(ordered), progress);
    if (!proof) {
        refuse(refusalOfProof(proof.error(), plan.results), err);
        return nullptr;
    }
    return *proof;
}

}  // namespace

int runCheck(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    auto read = readInput(arguments, progress, err);
    if (!read) {
        return kExitUnreadable;
    }
    CutPlan plan;
    plan.garment = std::make_shared<const Garment>(std::move(*read));
    plan.options = arguments.options;
    plan.lines = arguments.lines;
    plan.results = flattened(arguments, *plan.garment, progress);
    plan.pattern = std::make_shared<const Pattern>(makePattern(
        *plan.garment, plan.results, plan.lines, symmetryOf(*plan.garment, plan.lines)));
    const PatternOrder order = orderOf(arguments, *plan.garment);
    plan.fabric = order.fabric;
    plan.settings = settingsOf(order, *plan.garment);
    for (std::size_t i = 0; i < plan.settings.size(); ++i) {
        if (plan.results[i]->flat) {
            plan.settings[i] =
                anchoredSettings(std::move(plan.settings[i]), plan.results[i]->flat->Q);
        }
    }
    plan.materials = materialsOf(order, plan.settings);
    if (order.lines.grain) {
        setGrains(plan.settings, *plan.garment, plan.results, plan.pattern->symmetry.get(),
                  *order.lines.grain, plan.materials, plan.fabric);
    }
    if (arguments.project) {
        plan.rules = clothRules(arguments.project->markers);
    }
    if (arguments.isProving) {
        plan.proof = proved(arguments, plan, progress, err);
    }
    const Readiness readiness = readyToCut(plan, progress);
    if (arguments.json) {
        out << writeReadiness(*plan.garment, readiness);
    } else {
        out << verdictText(readiness) << '\n';
        printFindings(readiness, out);
        for (const ClothNeed& need : readiness.cloth) {
            out << "cloth: " << sentence(need) << '\n';
        }
    }
    out.flush();
    const bool isProved = !arguments.isProving || plan.proof != nullptr;
    const bool isReady = isProved && readiness.count(Severity::Fault) == 0 &&
                         !(arguments.failOnDoubt && readiness.count(Severity::Doubt) > 0);
    return !out ? kExitUnreadable : isReady ? kExitDone : kExitSomeFailed;
}

}  // namespace toile::app
