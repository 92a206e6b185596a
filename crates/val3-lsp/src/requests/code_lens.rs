//! `textDocument/codeLens` and `codeLens/resolve`

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use tower_lsp::lsp_types::{CodeLens, CodeLensParams, Command, Location, Range, Url};
use val3_analysis::db::{File, FileRange};
use val3_ide::LensKind;
use val3_syntax::text_at;

use crate::display_cache::Fingerprint;
use crate::session::ClientCommands;
use crate::snapshot::{Refusal, Snapshot};

/// Document of a reference lens, from which the count is computed later.
#[derive(Serialize, Deserialize)]
struct UsesLensData {
    uri: Url,
    version: Option<i32>,
}

pub(crate) fn code_lens(snapshot: &Snapshot, params: &CodeLensParams) -> Result<Option<Vec<CodeLens>>, Refusal> {
    let uri = &params.text_document.uri;
    let lenses = lenses(snapshot, uri)?;
    if let Some(document) = snapshot.documents.get(uri).filter(|_| snapshot.session.client.refreshes_lenses) {
        snapshot.documents.display_cache().entry(uri, document.version).lenses = Some(Fingerprint::of(&lenses));
    }
    Ok(Some(lenses))
}

/// Fingerprint of the current lenses; `None` for an unknown document.
pub(crate) fn current_lenses(snapshot: &Snapshot, uri: &Url) -> Option<Fingerprint> {
    lenses(snapshot, uri).ok().map(|lenses| Fingerprint::of(&lenses))
}

/// Current reference count of a lens.
pub(crate) fn current_uses(snapshot: &Snapshot, uri: &Url, lens: Range) -> Option<usize> {
    snapshot.file(uri).ok().map(|file| places(snapshot, file, lens).len())
}

fn lenses(snapshot: &Snapshot, uri: &Url) -> Result<Vec<CodeLens>, Refusal> {
    let file = snapshot.file(uri)?;
    let lines = snapshot.lines(file);
    let counted = serde_json::to_value(UsesLensData { uri: uri.clone(), version: snapshot.version(file) }).ok();
    let found = val3_ide::code_lenses(snapshot.db(), file);
    let is_test = found.iter().any(|lens| matches!(lens.kind, LensKind::RunTest(_)));
    let supported = found.into_iter().filter(|found| is_supported(snapshot, found.kind, is_test));
    let lenses = supported.map(|found| {
        let command = start(snapshot, found.kind, text_at(file.text(snapshot.db()), found.range));
        let is_counted = matches!(found.kind, LensKind::ProgramReferences | LensKind::DataReferences);
        let data = if is_counted { counted.clone() } else { None };
        CodeLens { range: lines.range(found.range), command, data }
    });
    Ok(lenses.collect())
}

/// Whether the client can execute the lens, and the user's settings show its references. A test has no "run" lens if the client can execute it as a test.
fn is_supported(snapshot: &Snapshot, kind: LensKind, is_test: bool) -> bool {
    let commands = snapshot.session.commands;
    match kind {
        LensKind::Run(manifest) => commands.runs && !(is_test && commands.runs_tests) && snapshot.is_shown(manifest),
        LensKind::Debug(manifest) => {
            commands.debugs && !(is_test && commands.debugs_tests) && snapshot.is_shown(manifest)
        }
        LensKind::RunTest(_) => commands.runs_tests,
        LensKind::DebugTest(_) => commands.debugs_tests,
        LensKind::ProgramReferences => snapshot.session.options.code_lens.program_references,
        LensKind::DataReferences => snapshot.session.options.code_lens.data_references,
    }
}

/// Client command with the `.pjx` and the program name; `None` for a reference lens.
fn start(snapshot: &Snapshot, kind: LensKind, program: &str) -> Option<Command> {
    let (title, command, manifest) = match kind {
        LensKind::Run(manifest) => ("Run", ClientCommands::RUN, manifest),
        LensKind::Debug(manifest) => ("Debug", ClientCommands::DEBUG, manifest),
        LensKind::RunTest(manifest) => ("Run test", ClientCommands::RUN_TEST, manifest),
        LensKind::DebugTest(manifest) => ("Debug test", ClientCommands::DEBUG_TEST, manifest),
        LensKind::ProgramReferences | LensKind::DataReferences => return None,
    };
    let arguments = vec![json!(snapshot.uri(manifest)), json!(program)];
    Some(Command { title: title.to_owned(), command: command.to_owned(), arguments: Some(arguments) })
}

/// Computes the reference count of a lens when it becomes visible.
pub(crate) fn resolve(snapshot: &Snapshot, lens: &CodeLens) -> Result<CodeLens, Refusal> {
    let mut lens = lens.clone();
    let Some(counted) = lens.data.take().and_then(|data| serde_json::from_value::<UsesLensData>(data).ok()) else {
        return Ok(lens);
    };
    let file = snapshot.file(&counted.uri).map_err(|_| Refusal::Outdated)?;
    if snapshot.version(file) != counted.version {
        return Err(Refusal::Outdated);
    }
    let places = places(snapshot, file, lens.range);
    if let Some(version) = counted.version.filter(|_| snapshot.session.client.refreshes_lenses) {
        snapshot.documents.display_cache().entry(&counted.uri, version).counted(lens.range, places.len());
    }
    let places: Vec<Location> = places.into_iter().map(|place| snapshot.location(place)).collect();
    lens.command = Some(references(snapshot, &counted.uri, &lens, &places));
    Ok(lens)
}

/// References counted by a lens.
fn places(snapshot: &Snapshot, file: File, lens: Range) -> Vec<FileRange> {
    let range = snapshot.lines(file).text_range(lens);
    val3_ide::lens_references(snapshot.db(), FileRange { file, range })
}

/// Command that shows the references. For a client without support it has no name and only shows the count.
fn references(snapshot: &Snapshot, uri: &Url, lens: &CodeLens, places: &[Location]) -> Command {
    let title = match places.len() {
        1 => "1 reference".to_owned(),
        count => format!("{count} references"),
    };
    if !snapshot.session.commands.shows_references || places.is_empty() {
        return Command { title, command: String::new(), arguments: None };
    }
    let arguments: Vec<Value> = vec![json!(uri), json!(lens.range.start), json!(places)];
    Command { title, command: ClientCommands::SHOW_REFERENCES.to_owned(), arguments: Some(arguments) }
}
