//! Clients that ask for findings are told to ask again when those they have are no longer right.

use std::panic::AssertUnwindSafe;

use salsa::Cancelled;
use tower_lsp::lsp_types::Url;
use tower_lsp::lsp_types::request::WorkspaceDiagnosticRefresh;

use crate::documents::Report;
use crate::panics::contained;
use crate::pool::Lane;
use crate::requests::current_report;
use crate::snapshot::Snapshot;
use crate::world::World;

impl World {
    /// Looks behind everything else whether a document has other findings than the client was told, though it was not
    /// edited itself: about those that were, clients ask without being told to.
    pub(crate) fn look_again(&self, generation: u64) {
        if !self.session.client.pulls_again || self.documents.reports().is_empty() {
            return;
        }
        let (snapshot, inbox) = (self.snapshot(), self.inbox.clone());
        self.pool.spawn(Lane::Background, move || {
            let outcome = contained(|| Cancelled::catch(AssertUnwindSafe(|| outdated(&snapshot))));
            drop(snapshot);
            inbox.post(move |world| match outcome {
                Ok(Ok(reports)) => world.tell_to_ask_again(reports),
                Ok(Err(_)) => world.check_again(generation),
                Err(reason) => world.complain("the check", &reason),
            });
        });
    }

    fn tell_to_ask_again(&self, reports: Vec<(Url, Report)>) {
        if !reports.is_empty() {
            // Once is enough, also for a client that does not ask.
            reports.into_iter().for_each(|(uri, report)| self.documents.keep_report(&uri, report));
            self.outbox.ask::<WorkspaceDiagnosticRefresh>((), |_, _| {});
        }
    }
}

/// The reports that are others now.
fn outdated(snapshot: &Snapshot) -> Vec<(Url, Report)> {
    let is_edited =
        |uri: &Url, known: &Report| snapshot.documents.get(uri).is_none_or(|found| found.version != known.version);
    let known = snapshot.documents.reports().into_iter().filter(|(uri, known)| !is_edited(uri, known));
    let now = known.map(|(uri, known)| {
        let id = current_report(snapshot, &uri);
        (uri, known, id)
    });
    let others = now.filter(|(_, known, id)| known.id != *id);
    others.map(|(uri, known, id)| (uri, Report { version: known.version, id })).collect()
}
