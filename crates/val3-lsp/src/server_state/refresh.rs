//! Refresh requests to the client for stale findings, inlay hints, code lenses and texts.
//!
//! Clients refresh an edited document themselves. For all other documents, the current values are compared with the
//! client's values in the background, so that a refresh is requested only if something differs.

use std::panic::AssertUnwindSafe;

use salsa::Cancelled;
use tower_lsp::lsp_types::Url;
use tower_lsp::lsp_types::request::{CodeLensRefresh, InlayHintRefreshRequest, WorkspaceDiagnosticRefresh};

use super::ServerState;
use crate::display_cache::{DisplayedDocument, Fingerprint};
use crate::documents::SentFindings;
use crate::panics::contained;
use crate::pool::Priority;
use crate::requests::code_lens::{current_lenses, current_uses};
use crate::requests::diagnostics::current_report;
use crate::requests::inlay_hint::current_hints;
use crate::requests::text_document_content::{TextDocumentContentParams, TextDocumentContentRefresh, current_text};
use crate::snapshot::Snapshot;

/// Current values that differ from the client's cached values.
struct StaleContents {
    reports: Vec<(Url, SentFindings)>,
    shown: Vec<(Url, DisplayedDocument, Parts)>,
    texts: Vec<(Url, Fingerprint)>,
}

/// Stale parts of a document.
#[derive(Clone, Copy, Default)]
struct Parts {
    hints: bool,
    lenses: bool,
}

impl ServerState {
    /// Checks whether anything that the client has cached has changed.
    pub(super) fn check_for_refresh(&self, generation: u64) {
        let waits_for_findings = self.session.is_asked_for_findings() && self.session.client.pulls_again;
        let has_findings = waits_for_findings && !self.documents.reports().is_empty();
        if !has_findings && self.documents.display_cache().is_empty() {
            return;
        }
        let (snapshot, inbox) = (self.snapshot(), self.inbox.clone());
        self.pool.spawn(Priority::Background, move || {
            let outcome = contained(|| Cancelled::catch(AssertUnwindSafe(|| stale(&snapshot, has_findings))));
            drop(snapshot);
            inbox.post(move |server| match outcome {
                Ok(Ok(stale)) => server.request_refresh(stale),
                Ok(Err(_)) if server.checks.is_current(generation) => server.check_for_refresh(generation),
                Ok(Err(_)) => {}
                Err(reason) => server.complain("the check", &reason),
            });
        });
    }

    /// Requests one refresh. The current values count as sent, even if the client does not react.
    fn request_refresh(&self, stale: StaleContents) {
        let StaleContents { reports, shown, texts } = stale;
        if !reports.is_empty() {
            self.outbox.request::<WorkspaceDiagnosticRefresh>(());
        }
        if shown.iter().any(|(_, _, parts)| parts.hints) {
            self.outbox.request::<InlayHintRefreshRequest>(());
        }
        if shown.iter().any(|(_, _, parts)| parts.lenses) {
            self.outbox.request::<CodeLensRefresh>(());
        }
        for (uri, text) in texts {
            self.documents.display_cache().keep_text(uri.clone(), text);
            self.outbox.request::<TextDocumentContentRefresh>(TextDocumentContentParams { uri });
        }
        reports.into_iter().for_each(|(uri, report)| self.documents.keep_report(&uri, report));
        for (uri, now, _) in shown {
            if self.documents.get(&uri).is_some_and(|document| document.version == now.version) {
                self.documents.display_cache().keep(uri, now);
            }
        }
    }
}

fn stale(snapshot: &Snapshot, has_findings: bool) -> StaleContents {
    let reports = if has_findings { stale_reports(snapshot) } else { Vec::new() };
    StaleContents { reports, shown: stale_displays(snapshot), texts: stale_texts(snapshot) }
}

/// Stale findings.
fn stale_reports(snapshot: &Snapshot) -> Vec<(Url, SentFindings)> {
    let known = snapshot.documents.reports().into_iter().filter(|(uri, known)| is_shown(snapshot, uri, known.version));
    let now = known.map(|(uri, known)| {
        let id = current_report(snapshot, &uri);
        (uri, known, id)
    });
    let others = now.filter(|(_, known, id)| known.id != *id);
    others.map(|(uri, known, id)| (uri, SentFindings { version: known.version, id })).collect()
}

/// Stale texts. A text whose file was removed is unchanged.
fn stale_texts(snapshot: &Snapshot) -> Vec<(Url, Fingerprint)> {
    let texts = snapshot.documents.display_cache().texts().map(|(uri, text)| (uri.clone(), *text)).collect::<Vec<_>>();
    let now = texts.into_iter().filter_map(|(uri, known)| Some((current_text(snapshot, &uri)?, known, uri)));
    now.filter(|(now, known, _)| now != known).map(|(now, _, uri)| (uri, now)).collect()
}

/// Documents whose displayed contents are stale.
fn stale_displays(snapshot: &Snapshot) -> Vec<(Url, DisplayedDocument, Parts)> {
    // The lock is released before the computation, because requests need it.
    let known: Vec<(Url, DisplayedDocument)> =
        snapshot.documents.display_cache().iter().map(|(uri, shown)| (uri.clone(), shown.clone())).collect();
    let known = known.into_iter().filter(|(uri, known)| is_shown(snapshot, uri, known.version));
    let now = known.map(|(uri, known)| {
        let now = look(snapshot, &uri, &known);
        let lenses = now.lenses != known.lenses || now.uses != known.uses;
        let parts = Parts { hints: now.hints != known.hints, lenses };
        (uri, now, parts)
    });
    now.filter(|(_, _, parts)| parts.hints || parts.lenses).collect()
}

/// Current contents of a document, restricted to what the client has displayed.
fn look(snapshot: &Snapshot, uri: &Url, known: &DisplayedDocument) -> DisplayedDocument {
    let uses = known.uses.iter().map(|(lens, count)| (*lens, current_uses(snapshot, uri, *lens).unwrap_or(*count)));
    DisplayedDocument {
        version: known.version,
        hints: known.hints.and_then(|(range, _)| Some((range, current_hints(snapshot, uri, range)?))),
        lenses: known.lenses.and_then(|_| current_lenses(snapshot, uri)),
        uses: uses.collect(),
    }
}

fn is_shown(snapshot: &Snapshot, uri: &Url, version: i32) -> bool {
    snapshot.documents.get(uri).is_some_and(|document| document.version == version)
}
