//! Conversion of feature results to protocol values. No other module creates protocol values from them.

mod change;
mod markup;

pub(crate) use change::{ImpossibleChange, completion, workspace_edit};
pub(crate) use markup::{documentation, markup};

use std::ops::RangeInclusive;

use salsa::Database as _;
use tower_lsp::lsp_types::*;
use val3_analysis::db::{File, Project};
use val3_check::diagnostic as check;
use val3_check::rule::{Rule, Severity};
use val3_check::topics;
use val3_config::ConfigError;
use val3_ide as ide;
use val3_lines::LineIndex;

use crate::lines::PositionConverter;
use crate::snapshot::Snapshot;

/// Source name of diagnostics.
const SOURCE: &str = "val3";

/// Diagnostics of a project, by file. Diagnostics of a project file that does not exist are omitted.
pub(crate) fn diagnostics(snapshot: &Snapshot, project: Project) -> Vec<(Url, Vec<Diagnostic>)> {
    let Some(settings) = snapshot.settings else { return Vec::new() };
    let mut files: Vec<(File, Vec<Diagnostic>)> = Vec::new();
    for found in &ide::project_diagnostics(snapshot.db(), settings, &snapshot.projects, project) {
        let file = found.place.file;
        // There may be many diagnostics, and a write blocks until this loop ends.
        snapshot.db.unwind_if_revision_cancelled();
        if !snapshot.is_shown(file) {
            continue;
        }
        let converted = diagnostic(snapshot, found);
        match files.iter_mut().find(|(known, _)| *known == file) {
            Some((_, of_file)) => of_file.push(converted),
            None => files.push((file, vec![converted])),
        }
    }
    let files = files.into_iter().map(|(file, found)| (snapshot.uri(file), found));
    files.chain(cell_faults(snapshot, project)).collect()
}

/// Faults in the `cell.toml` of an application and in the meshes of links, by file. Of several applications that share
/// the `cell.toml`, the first reports them.
fn cell_faults(snapshot: &Snapshot, project: Project) -> Vec<(Url, Vec<Diagnostic>)> {
    let Some(file) = project.surroundings(&snapshot.db) else { return Vec::new() };
    let mut sharing = ide::projects_of(snapshot.db(), file).iter().filter(|other| snapshot.projects.contains(other));
    if sharing.next() != Some(&project) {
        return Vec::new();
    }
    let mut files = vec![(snapshot.uri(file), Vec::new())];
    add_by_file(snapshot, &val3_analysis::surroundings::cell_faults(snapshot.db(), file, true), &mut files);
    files
}

/// Diagnostics of one program in a project, available before the other programs are checked. `None` without settings or
/// if the project does not contain the program.
pub(crate) fn program_diagnostics(snapshot: &Snapshot, project: Project, file: File) -> Option<Vec<Diagnostic>> {
    let found = ide::program_diagnostics(snapshot.db(), snapshot.settings?, project, file)?;
    Some(found.iter().map(|found| diagnostic(snapshot, found)).collect())
}

/// Converts one diagnostic.
pub(crate) fn diagnostic(snapshot: &Snapshot, found: &check::Diagnostic) -> Diagnostic {
    Diagnostic {
        range: snapshot.range(found.place.file, found.place.range),
        severity: Some(severity(found)),
        code: Some(NumberOrString::String(found.rule.code.to_owned())),
        code_description: Url::parse(&topics::address(found.rule)).ok().map(|href| CodeDescription { href }),
        source: Some(SOURCE.to_owned()),
        message: message(&found.message, &found.help),
        related_information: related_information(snapshot, found),
        tags: tag(found.rule).map(|tag| vec![tag]),
        ..Diagnostic::default()
    }
}

/// The label and the related places of a diagnostic; `None` if it has neither.
fn related_information(snapshot: &Snapshot, found: &check::Diagnostic) -> Option<Vec<DiagnosticRelatedInformation>> {
    let label = Some(found.label.as_str()).filter(|label| !label.is_empty()).map(|label| (found.place, label));
    let related = found.related.iter().map(|related| (related.place, related.message.as_str()));
    let notes = label.into_iter().chain(related).map(|(place, message)| DiagnosticRelatedInformation {
        location: snapshot.location(place),
        message: message.to_owned(),
    });
    let notes: Vec<_> = notes.collect();
    (!notes.is_empty()).then_some(notes)
}

/// Message text, followed by the help on its own line.
fn message(message: &str, help: &str) -> String {
    if help.is_empty() { message.to_owned() } else { format!("{message}\nhelp: {help}") }
}

/// Severity of a diagnostic. Unused items are hints, which editors fade and do not list, unless a configuration raises
/// their level.
fn severity(found: &check::Diagnostic) -> DiagnosticSeverity {
    match found.severity {
        severity if is_unused(found.rule) && severity <= found.rule.severity => DiagnosticSeverity::HINT,
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Info => DiagnosticSeverity::INFORMATION,
    }
}

/// Codes of the rules about declarations that are never used or never read.
const UNUSED: RangeInclusive<&str> = "V0113"..="V0120";

fn is_unused(rule: &Rule) -> bool {
    UNUSED.contains(&rule.code)
}

/// Tag by which an editor fades or strikes out the code.
fn tag(rule: &Rule) -> Option<DiagnosticTag> {
    if is_unused(rule) || rule.name.starts_with("unused-") || rule.name.starts_with("unreachable-") {
        return Some(DiagnosticTag::UNNECESSARY);
    }
    rule.name.contains("deprecated").then_some(DiagnosticTag::DEPRECATED)
}

/// Configuration faults, by file.
pub(crate) fn configuration_faults(snapshot: &Snapshot) -> Vec<(Url, Vec<Diagnostic>)> {
    let mut files = Vec::new();
    add_by_file(snapshot, &snapshot.faults, &mut files);
    files
}

/// Adds errors to the diagnostics of their files.
fn add_by_file(snapshot: &Snapshot, errors: &[ConfigError], files: &mut Vec<(Url, Vec<Diagnostic>)>) {
    for error in errors {
        let uri = snapshot.uri_of(&error.path);
        let found = configuration_fault(snapshot, error);
        match files.iter_mut().find(|(known, _)| *known == uri) {
            Some((_, of_file)) => of_file.push(found),
            None => files.push((uri, vec![found])),
        }
    }
}

/// Converts one configuration fault.
pub(crate) fn configuration_fault(snapshot: &Snapshot, error: &ConfigError) -> Diagnostic {
    let index = LineIndex::for_protocol(&error.text);
    let lines = PositionConverter::new(&error.text, &index, snapshot.session.encoding, true);
    let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX).into();
    let range =
        Range { start: lines.position(offset(error.range.start)), end: lines.position(offset(error.range.end)) };
    Diagnostic {
        range,
        severity: Some(DiagnosticSeverity::ERROR),
        source: Some(SOURCE.to_owned()),
        message: message(&error.message, &error.help),
        ..Diagnostic::default()
    }
}

/// Protocol symbol kind for an outline item.
pub(crate) fn symbol_kind(kind: ide::SymbolKind) -> SymbolKind {
    match kind {
        ide::SymbolKind::Project => SymbolKind::PACKAGE,
        ide::SymbolKind::Program => SymbolKind::FUNCTION,
        ide::SymbolKind::Data | ide::SymbolKind::Local | ide::SymbolKind::Parameter => SymbolKind::VARIABLE,
        ide::SymbolKind::Library => SymbolKind::MODULE,
        ide::SymbolKind::Type => SymbolKind::STRUCT,
    }
}

/// Protocol item kind for a completion.
pub(crate) fn completion_kind(kind: ide::CompletionKind) -> CompletionItemKind {
    match kind {
        ide::CompletionKind::Local | ide::CompletionKind::Parameter | ide::CompletionKind::Data => {
            CompletionItemKind::VARIABLE
        }
        ide::CompletionKind::Field => CompletionItemKind::FIELD,
        ide::CompletionKind::Program => CompletionItemKind::FUNCTION,
        ide::CompletionKind::Instruction => CompletionItemKind::METHOD,
        ide::CompletionKind::Keyword => CompletionItemKind::KEYWORD,
        ide::CompletionKind::Library => CompletionItemKind::MODULE,
        ide::CompletionKind::Type => CompletionItemKind::STRUCT,
        ide::CompletionKind::Constant => CompletionItemKind::ENUM_MEMBER,
        ide::CompletionKind::Literal => CompletionItemKind::VALUE,
        ide::CompletionKind::Text => CompletionItemKind::TEXT,
        ide::CompletionKind::Path => CompletionItemKind::FILE,
        ide::CompletionKind::Element => CompletionItemKind::CLASS,
        ide::CompletionKind::Attribute => CompletionItemKind::PROPERTY,
    }
}

/// Kind of a folding range; `None` for blocks of code.
pub(crate) fn fold_kind(kind: ide::FoldKind) -> Option<FoldingRangeKind> {
    match kind {
        ide::FoldKind::Comment => Some(FoldingRangeKind::Comment),
        ide::FoldKind::Xml => Some(FoldingRangeKind::Region),
        ide::FoldKind::Block => None,
    }
}

/// Converts edits in one file.
pub(crate) fn edits<'e>(
    snapshot: &Snapshot,
    file: File,
    edits: impl IntoIterator<Item = (val3_syntax::TextRange, &'e str)>,
) -> Vec<TextEdit> {
    let lines = snapshot.lines(file);
    edits.into_iter().map(|(range, text)| TextEdit { range: lines.range(range), new_text: text.to_owned() }).collect()
}

/// Locations, or location links with the source range if the client supports them.
pub(crate) fn targets(snapshot: &Snapshot, from: File, targets: &[ide::NavigationTarget]) -> GotoDefinitionResponse {
    let targets = targets.iter().filter(|target| snapshot.is_shown(target.to.file));
    if snapshot.session.client.has_links {
        let links = targets.map(|target| snapshot.link(snapshot.range(from, target.from), target.to));
        return GotoDefinitionResponse::Link(links.collect());
    }
    GotoDefinitionResponse::Array(targets.map(|target| snapshot.location(target.to)).collect())
}
