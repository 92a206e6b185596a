//! `textDocument/diagnostic` and `workspace/diagnostic`

use std::collections::BTreeMap;
use std::hash::{Hash as _, Hasher as _};

use rustc_hash::{FxHashMap, FxHasher};
use tower_lsp::lsp_types::*;
use val3_analysis::paths::is_same;

use crate::convert::{configuration_fault, configuration_faults, diagnostics};
use crate::documents::SentFindings;
use crate::job::JobPart;
use crate::progress::WorkProgress;
use crate::server_state::TREES;
use crate::snapshot::{Refusal, Snapshot};
use crate::uri;

pub(crate) fn document(
    snapshot: &Snapshot,
    params: &DocumentDiagnosticParams,
) -> Result<DocumentDiagnosticReportResult, Refusal> {
    let uri = &params.text_document.uri;
    if is_configuration(uri) {
        (snapshot.pulls_configurations)();
    }
    let items = findings(snapshot, uri);
    let result_id = id(&items);
    if let Some(document) = snapshot.documents.get(uri) {
        snapshot.documents.keep_report(uri, SentFindings { version: document.version, id: result_id.clone() });
    }
    let report = match params.previous_result_id.as_ref() == Some(&result_id) {
        true => DocumentDiagnosticReport::Unchanged(RelatedUnchangedDocumentDiagnosticReport {
            related_documents: None,
            unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id },
        }),
        false => DocumentDiagnosticReport::Full(RelatedFullDocumentDiagnosticReport {
            related_documents: None,
            full_document_diagnostic_report: FullDocumentDiagnosticReport { result_id: Some(result_id), items },
        }),
    };
    Ok(DocumentDiagnosticReportResult::Report(report))
}

/// Result id of the findings in a document.
pub(crate) fn current_report(snapshot: &Snapshot, uri: &Url) -> String {
    id(&findings(snapshot, uri))
}

fn findings(snapshot: &Snapshot, uri: &Url) -> Vec<Diagnostic> {
    let Ok(file) = snapshot.file(uri) else { return of_configuration(snapshot, uri) };
    let uri = snapshot.uri(file);
    let projects = val3_ide::projects_of(snapshot.db(), file);
    let mut items: Vec<Diagnostic> = Vec::new();
    for project in projects.iter().filter(|project| snapshot.projects.contains(project)) {
        let of_file = diagnostics(snapshot, *project).into_iter().filter(|(found, _)| *found == uri);
        of_file.flat_map(|(_, found)| found).for_each(|found| add(&mut items, found));
    }
    items
}

/// Faults of a configuration; empty for any other file.
fn of_configuration(snapshot: &Snapshot, uri: &Url) -> Vec<Diagnostic> {
    let Some(path) = uri::path(uri, None) else { return Vec::new() };
    let faults = snapshot.faults.iter().filter(|fault| is_same(&fault.path, &path));
    faults.map(|fault| configuration_fault(snapshot, fault)).collect()
}

fn is_configuration(uri: &Url) -> bool {
    let path = uri::path(uri, None);
    path.is_some_and(|path| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case(val3_config::FILE_NAME)))
}

/// Number of syntax trees that one part of the workspace check may add. It also bounds the memoised query results,
/// whose number is similar.
const TREES_OF_PART: usize = 512;

/// Progress report of the check, shown by the client until the last part is computed.
#[derive(Default)]
pub(crate) struct PullProgress(Option<WorkProgress>);

pub(crate) fn workspace(
    snapshot: &Snapshot,
    params: &WorkspaceDiagnosticParams,
    progress: &mut PullProgress,
) -> JobPart<WorkspaceDiagnosticReportResult> {
    (snapshot.pulls_configurations)();
    if !check(snapshot, params, progress) {
        return JobPart::More;
    }
    // A token is valid until the response.
    progress.0 = None;
    let mut files: BTreeMap<Url, Vec<Diagnostic>> = BTreeMap::new();
    let mut known: FxHashMap<&Url, &str> = FxHashMap::default();
    for previous in &params.previous_result_ids {
        known.insert(&previous.uri, &previous.value);
        // Findings that no longer exist are cleared.
        files.insert(previous.uri.clone(), Vec::new());
    }
    for project in snapshot.projects.iter() {
        for (uri, found) in diagnostics(snapshot, *project) {
            let items = files.entry(uri).or_default();
            found.into_iter().for_each(|found| add(items, found));
        }
    }
    for (uri, found) in configuration_faults(snapshot) {
        files.entry(uri).or_default().extend(found);
    }
    let items = files.into_iter().map(|(uri, items)| {
        let id = id(&items);
        let known = known.get(&uri).is_some_and(|known| *known == id);
        report(snapshot, uri, items, id, known)
    });
    JobPart::Last(WorkspaceDiagnosticReportResult::Report(WorkspaceDiagnosticReport { items: items.collect() }))
}

/// Checks unchecked projects until data should be freed. Returns whether all projects are checked.
fn check(snapshot: &Snapshot, params: &WorkspaceDiagnosticParams, progress: &mut PullProgress) -> bool {
    let Some(settings) = snapshot.settings else { return true };
    if progress.0.is_none() {
        let token = params.work_done_progress_params.work_done_token.clone().or_else(|| snapshot.first_pull.take());
        progress.0 = token.map(|token| WorkProgress::begin(snapshot.outbox.clone(), token, "checking the projects"));
    }
    // The number of added trees measures the work only after the trees of earlier requests are freed.
    snapshot.db().trees().keep_latest(TREES);
    for (done, project) in (1..).zip(snapshot.projects.iter()) {
        val3_ide::check_project(snapshot.db(), settings, *project);
        progress.0.iter().for_each(|progress| progress.checked(done, snapshot.projects.len()));
        if snapshot.db().trees().count() > TREES + TREES_OF_PART {
            return false;
        }
    }
    true
}

fn report(
    snapshot: &Snapshot,
    uri: Url,
    items: Vec<Diagnostic>,
    id: String,
    is_known: bool,
) -> WorkspaceDocumentDiagnosticReport {
    let version = snapshot.documents.get(&uri).map(|document| i64::from(document.version));
    match is_known {
        true => WorkspaceDocumentDiagnosticReport::Unchanged(WorkspaceUnchangedDocumentDiagnosticReport {
            uri,
            version,
            unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id: id },
        }),
        false => WorkspaceDocumentDiagnosticReport::Full(WorkspaceFullDocumentDiagnosticReport {
            uri,
            version,
            full_document_diagnostic_report: FullDocumentDiagnosticReport { result_id: Some(id), items },
        }),
    }
}

/// Adds a finding once, although two projects that share a file report it twice.
fn add(items: &mut Vec<Diagnostic>, found: Diagnostic) {
    if !items.contains(&found) {
        items.push(found);
    }
}

/// Result id: equal for equal findings.
fn id(items: &[Diagnostic]) -> String {
    let mut hasher = FxHasher::default();
    serde_json::to_string(items).unwrap_or_default().hash(&mut hasher);
    format!("{:x}", hasher.finish())
}
