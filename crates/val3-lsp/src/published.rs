//! Pushed findings: sent with their document version, and only if they have changed.

use rustc_hash::{FxHashMap, FxHashSet};
use tower_lsp::lsp_types::notification::PublishDiagnostics;
use tower_lsp::lsp_types::{Diagnostic, NumberOrString, PublishDiagnosticsParams, Url};
use val3_analysis::db::Project;

use crate::convert::diagnostics;
use crate::documents::{Document, Documents};
use crate::outbox::Outbox;
use crate::snapshot::Snapshot;

/// Origin of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum FindingSource {
    /// Reader of configurations.
    Configuration,
    /// Check of a project.
    Project(Project),
}

/// Findings from one origin, by file.
#[derive(Debug, PartialEq)]
pub(crate) struct ProjectFindings {
    /// Origin of the findings.
    pub(crate) finder: FindingSource,
    /// All files with findings, and all open files.
    pub(crate) files: Vec<(Url, Vec<Diagnostic>)>,
}

/// Findings sent to the client.
#[derive(Debug, Default)]
pub(crate) struct Published {
    /// Latest findings, by origin and file.
    found: FxHashMap<FindingSource, FxHashMap<Url, Vec<Diagnostic>>>,
    /// Document version and findings that the client has, by file.
    sent: FxHashMap<Url, (Option<i32>, Vec<Diagnostic>)>,
}

/// Sort key of a finding.
fn place(diagnostic: &Diagnostic) -> (u32, u32, Option<&str>, &str) {
    let Diagnostic { range, code, message, .. } = diagnostic;
    let code = match code {
        Some(NumberOrString::String(code)) => Some(code.as_str()),
        _ => None,
    };
    (range.start.line, range.start.character, code, message)
}

/// Findings of a project, computed on a snapshot.
pub(crate) fn findings(snapshot: &Snapshot, project: Project) -> ProjectFindings {
    let mut files: Vec<(Url, Vec<Diagnostic>)> = diagnostics(snapshot, project);
    let with_findings: FxHashSet<&Url> = files.iter().map(|(uri, _)| uri).collect();
    let open = snapshot
        .documents
        .iter()
        .filter(|document| !with_findings.contains(&document.uri) && snapshot.is_part(document, project));
    let without: Vec<_> = open.map(|document| (document.uri.clone(), Vec::new())).collect();
    files.extend(without);
    ProjectFindings { finder: FindingSource::Project(project), files }
}

impl Published {
    /// Stores the findings from one origin and sends the changed files to the client.
    pub(crate) fn project(&mut self, found: ProjectFindings, documents: &Documents, outbox: &Outbox) {
        let now: FxHashMap<Url, Vec<Diagnostic>> = found.files.into_iter().collect();
        let known = self.found.remove(&found.finder).unwrap_or_default();
        let gone = known.keys().filter(|uri| !now.contains_key(*uri));
        // Findings are sent for every version of a document, even if they are unchanged.
        let news = now.iter().filter(|(uri, found)| known.get(*uri) != Some(*found) || documents.get(uri).is_some());
        let changed: Vec<Url> = gone.chain(news.map(|(uri, _)| uri)).cloned().collect();
        self.found.insert(found.finder, now);
        changed.iter().for_each(|uri| self.send(uri, documents, outbox));
    }

    /// Stores and sends the findings of a project in one file, before its other files are checked.
    pub(crate) fn file(
        &mut self,
        project: Project,
        uri: Url,
        found: Vec<Diagnostic>,
        documents: &Documents,
        outbox: &Outbox,
    ) {
        self.found.entry(FindingSource::Project(project)).or_default().insert(uri.clone(), found);
        self.send(&uri, documents, outbox);
    }

    /// Removes the findings of projects that no longer exist.
    pub(crate) fn keep(&mut self, projects: &[Project], documents: &Documents, outbox: &Outbox) {
        let kept: FxHashSet<Project> = projects.iter().copied().collect();
        let gone = self.found.keys().copied().filter(|finder| match finder {
            FindingSource::Project(project) => !kept.contains(project),
            _ => false,
        });
        for finder in gone.collect::<FxHashSet<FindingSource>>() {
            self.project(ProjectFindings { finder, files: Vec::new() }, documents, outbox);
            self.found.remove(&finder);
        }
    }

    /// Records that a document was closed: its findings are then sent without a version.
    pub(crate) fn closed(&mut self, document: &Document) {
        if let Some((version, _)) = self.sent.get_mut(&document.uri) {
            *version = None;
        }
    }

    /// Sends the findings in a file, unless the client already has them.
    fn send(&mut self, uri: &Url, documents: &Documents, outbox: &Outbox) {
        let found = self.found.values().filter_map(|files| files.get(uri));
        let mut diagnostics: Vec<Diagnostic> = found.flatten().cloned().collect();
        diagnostics.sort_by(|a, b| place(a).cmp(&place(b)));
        // Two projects that share a file report most findings in it twice.
        diagnostics.dedup();
        let version = documents.get(uri).map(|document| document.version);
        let is_sent = match self.sent.get(uri) {
            Some(sent) => *sent == (version, diagnostics.clone()),
            None => diagnostics.is_empty() && version.is_none(),
        };
        if !is_sent {
            self.sent.insert(uri.clone(), (version, diagnostics.clone()));
            outbox.notify::<PublishDiagnostics>(PublishDiagnosticsParams { uri: uri.clone(), diagnostics, version });
        }
    }
}
