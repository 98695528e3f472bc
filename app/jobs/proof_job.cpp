// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/proof_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/render/sewn_cloth.h"
#include "core/prove/body_file.h"

namespace toile::app {

namespace {

/// Flattening takes a small part of the time, even if all of it is still to be done.
constexpr double kFlatShare = 0.1;

}  // namespace

std::unique_ptr<Job> proofJob(const Document& document, const ProofPlan& plan,
                              std::shared_ptr<Mailbox<ShownProof>> mailbox,
                              std::function<void(std::shared_ptr<const ShownProof>)> done) {
    ShownProof shown;
    shown.ground =
        proofGround(document.derived(), document.state(), document.settings(), plan.sewn);
    shown.plan = plan;
    ProofOrder order;
    order.isReference = plan.sewn == SewnPattern::Designer;
    order.bodyName = plan.body.filename().string();
    order.settings = plan.settings;
    if (shown.ground.reference) {
        order.file = *shown.ground.reference;
    }
    auto work = [now = PatternNow(document, {}, kFlatShare), scene = document.scene(),
                 shown = std::move(shown), order = std::move(order), mailbox = std::move(mailbox)](
                    Progress& progress) mutable -> Result<std::shared_ptr<const ShownProof>> {
        if (const auto& body = shown.plan.body; !body.empty()) {
            Progress reading(progress, 0);
            auto read = readBody(body, shown.plan.bodyUnit, *shown.ground.garment, reading);
            if (!read) {
                return read.error();
            }
            if (!isNear(*read, *shown.ground.garment)) {
                return bodyNotNear(body);
            }
            order.body = std::move(read).value();
        }
        const auto anchors = lineAnchors(*scene);
        const SewnPattern of = shown.plan.sewn;
        const auto watch = [&](const std::vector<Points3>& sewn) {
            ShownProof onItsWay = shown;
            onItsWay.cloth = sewnCloth(scene, anchors, sewn, nullptr, of);
            mailbox->put(std::make_shared<const ShownProof>(std::move(onItsWay)));
        };
        if (mailbox) {
            order.watch = watch;
        }
        auto proof = now.with({}, progress, [&](const ExportSource& source, const Progress& part) {
            shown.ground = withFlat(std::move(shown.ground), source.results());
            return proofOf(source, order, part);
        });
        order.watch = {};
        if (!proof) {
            return proof.error();
        }
        shown.proof = std::move(proof).value();
        shown.cloth = sewnCloth(scene, *shown.proof, of, anchors);
        return std::shared_ptr<const ShownProof>(
            std::make_shared<const ShownProof>(std::move(shown)));
    };
    return makeJob(QCoreApplication::translate("ProofJob", "Sewing the pattern back together"),
                   std::move(work), std::move(done));
}

void showProof(Document& document, std::shared_ptr<const Proof> proof) {
    auto cloth = sewnCloth(document.scene(), *proof);
    document.showProof(std::make_shared<const ShownProof>(
        ShownProof{proofGround(document.derived(), document.state(), document.settings(), {}),
                   {},
                   std::move(proof),
                   std::move(cloth)}));
}

}  // namespace toile::app
