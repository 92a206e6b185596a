//! `textDocument/codeAction` and `codeAction/resolve`

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::{
    CodeAction, CodeActionDisabled, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, Command,
    Range, Url,
};
use val3_analysis::db::{File, FileRange};
use val3_check::diagnostic::Diagnostic;
use val3_ide::{Assist, AssistKind, QuickFix, SourceChange};

use super::execute_command::apply;
use crate::convert::{ImpossibleChange, completion, diagnostic, workspace_edit};
use crate::snapshot::{Refusal, Snapshot};

/// Action id for all safe fixes of a file; no assist has this id.
const FIX_ALL: &str = "fix-all";

/// Action kind for sorting a list in a project file.
const SORT: CodeActionKind = CodeActionKind::new("source.sort");

/// Kinds of the offered actions.
pub(super) const KINDS: [CodeActionKind; 6] = [
    CodeActionKind::QUICKFIX,
    CodeActionKind::REFACTOR_EXTRACT,
    CodeActionKind::REFACTOR_INLINE,
    CodeActionKind::REFACTOR_REWRITE,
    CodeActionKind::SOURCE_FIX_ALL,
    SORT,
];

/// An offered action and its range, from which the edit is computed later.
#[derive(Clone, Serialize, Deserialize)]
struct CodeActionData {
    /// Assist id, or [`FIX_ALL`].
    id: String,
    uri: Url,
    range: Range,
    version: Option<i32>,
}

pub(crate) fn code_action(
    snapshot: &Snapshot,
    params: &CodeActionParams,
) -> Result<Option<CodeActionResponse>, Refusal> {
    let uri = &params.text_document.uri;
    let file = snapshot.file(uri)?;
    let at = FileRange { file, range: snapshot.lines(file).text_range(params.range) };
    let wanted = RequestedKinds(params.context.only.as_deref());
    let place =
        CodeActionData { id: String::new(), uri: uri.clone(), range: params.range, version: snapshot.version(file) };
    let mut actions: Vec<CodeAction> = Vec::new();
    if wanted.has(&CodeActionKind::QUICKFIX) {
        actions.extend(quick_fixes(snapshot, at));
    }
    let kinds: Vec<AssistKind> = ASSIST_KINDS.into_iter().filter(|it| wanted.has(&kind(*it))).collect();
    let assists = val3_ide::assists(snapshot.db(), at, Some(&kinds));
    let is_lazy = is_lazy(snapshot, file);
    actions.extend(assists.into_iter().filter_map(|found| assist(snapshot, at, found, &place, is_lazy)));
    if wanted.has(&CodeActionKind::SOURCE_FIX_ALL) {
        // Clients that request this kind when a file is saved rarely resolve actions.
        actions.extend(fix_all(snapshot, at, &place, is_lazy && wanted.0.is_none()));
    }
    let answer = actions.into_iter().filter_map(|action| match snapshot.session.client.has_code_actions {
        true => Some(CodeActionOrCommand::CodeAction(action)),
        false => command(snapshot, action).map(CodeActionOrCommand::Command),
    });
    Ok(Some(answer.collect()))
}

/// Fixes for the findings in a range.
fn quick_fixes(snapshot: &Snapshot, at: FileRange) -> Vec<CodeAction> {
    let mut actions: Vec<CodeAction> = Vec::new();
    for findings in snapshot.findings(at.file) {
        for fix in snapshot.with_fixes(|context| val3_ide::quick_fixes(context, &findings, at)) {
            // Two projects that share a file report most findings in it twice.
            actions.extend(quick_fix(snapshot, fix).filter(|action| !actions.contains(action)));
        }
    }
    actions
}

fn quick_fix(snapshot: &Snapshot, fix: QuickFix<'_>) -> Option<CodeAction> {
    let action = CodeAction {
        title: fix.title,
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![diagnostic(snapshot, fix.diagnostic)]),
        ..CodeAction::default()
    };
    match fix.disabled {
        Some(reason) => disabled(snapshot, action, reason),
        None => Some(CodeAction {
            edit: Some(workspace_edit(snapshot, &fix.change).ok()?),
            is_preferred: fix.safe.then_some(true),
            ..action
        }),
    }
}

/// A disabled action with the reason; `None` if the client does not show disabled actions.
fn disabled(snapshot: &Snapshot, action: CodeAction, reason: String) -> Option<CodeAction> {
    let is_shown = snapshot.session.client.shows_disabled;
    is_shown.then_some(CodeAction { disabled: Some(CodeActionDisabled { reason }), ..action })
}

/// Action that applies all safe fixes of a file. If several projects share the file, it uses the first project with
/// safe fixes.
fn fix_all(snapshot: &Snapshot, at: FileRange, place: &CodeActionData, is_lazy: bool) -> Option<CodeAction> {
    snapshot.findings(at.file).find(|findings| findings.iter().any(|finding| has_safe_fix(finding, at.file)))?;
    let title = "Apply all safe fixes of the file".to_owned();
    let action = CodeAction { title, kind: Some(CodeActionKind::SOURCE_FIX_ALL), ..CodeAction::default() };
    offer(snapshot, FIX_ALL, at, action, place, is_lazy)
}

/// Whether the finding is in the file and has a safe fix.
fn has_safe_fix(finding: &Diagnostic, file: File) -> bool {
    finding.place.file == file && finding.fix.as_ref().is_some_and(|fix| fix.safe)
}

fn assist(
    snapshot: &Snapshot,
    at: FileRange,
    found: Assist,
    place: &CodeActionData,
    is_lazy: bool,
) -> Option<CodeAction> {
    let action = CodeAction { title: found.title, kind: Some(kind(found.kind)), ..CodeAction::default() };
    if let Some(reason) = found.disabled {
        return disabled(snapshot, action, reason);
    }
    offer(snapshot, found.id, at, action, place, is_lazy)
}

/// An action with its edit, or with the data from which the edit is computed later.
fn offer(
    snapshot: &Snapshot,
    id: &str,
    at: FileRange,
    action: CodeAction,
    place: &CodeActionData,
    is_lazy: bool,
) -> Option<CodeAction> {
    if is_lazy {
        let offered = CodeActionData { id: id.to_owned(), ..place.clone() };
        return Some(CodeAction { data: Some(serde_json::to_value(offered).ok()?), ..action });
    }
    complete(snapshot, action, &change_of(snapshot, id, at)?).ok()
}

/// The action with its edit, and with the command that the client executes afterwards.
fn complete(snapshot: &Snapshot, action: CodeAction, change: &SourceChange) -> Result<CodeAction, ImpossibleChange> {
    let edit = Some(workspace_edit(snapshot, change)?);
    Ok(CodeAction { edit, command: completion(snapshot, change), ..action })
}

/// Whether edits are computed when the client resolves an action. Required: the client resolves edits, supports all
/// file operations, so that no edit is impossible, and a project lists the file.
fn is_lazy(snapshot: &Snapshot, file: File) -> bool {
    let client = snapshot.session.client;
    let can_all = client.changes_files.creates && client.changes_files.renames && client.changes_files.deletes;
    let owner = val3_ide::owner(snapshot.db(), file);
    let is_listed = owner.is_some_and(|project| snapshot.is_shown(project.manifest(&snapshot.db)));
    client.resolves_edits && can_all && is_listed
}

/// Change made by an action; `None` if there is nothing to change.
fn change_of(snapshot: &Snapshot, id: &str, at: FileRange) -> Option<SourceChange> {
    match id {
        FIX_ALL => {
            let mut changes = snapshot
                .findings(at.file)
                .map(|findings| snapshot.with_fixes(|context| val3_ide::fix_all(context, &findings, at.file)));
            changes.find(|change| !change.is_empty())
        }
        _ => val3_ide::resolve_assist(snapshot.db(), id, at),
    }
}

/// Computes the edit of a chosen action. Fails as outdated if the document was edited, because the range is no longer
/// valid.
pub(crate) fn resolve(snapshot: &Snapshot, action: &CodeAction) -> Result<CodeAction, Refusal> {
    let mut action = action.clone();
    let Some(offered) = action.data.take().and_then(|data| serde_json::from_value::<CodeActionData>(data).ok()) else {
        return Ok(action);
    };
    let file = snapshot.file(&offered.uri).map_err(|_| Refusal::Outdated)?;
    if snapshot.version(file) != offered.version {
        return Err(Refusal::Outdated);
    }
    let at = FileRange { file, range: snapshot.lines(file).text_range(offered.range) };
    let change = change_of(snapshot, &offered.id, at).ok_or_else(|| match offered.id.as_str() {
        FIX_ALL => Refusal::Because("each safe fix of this file would add an error".to_owned()),
        _ => Refusal::Outdated,
    })?;
    Ok(complete(snapshot, action, &change)?)
}

/// The action as a command, for clients that accept only commands: the server then requests the edit.
fn command(snapshot: &Snapshot, action: CodeAction) -> Option<Command> {
    apply(snapshot, action.title, action.edit?)
}

/// Action kinds requested by the client; a kind includes all kinds below it.
struct RequestedKinds<'a>(Option<&'a [CodeActionKind]>);

impl RequestedKinds<'_> {
    fn has(&self, kind: &CodeActionKind) -> bool {
        self.0.is_none_or(|only| only.iter().any(|requested| includes(requested.as_str(), kind.as_str())))
    }
}

/// Whether `kind` is the requested kind, or a kind below it.
fn includes(requested: &str, kind: &str) -> bool {
    let rest = kind.strip_prefix(requested);
    requested.is_empty() || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

const ASSIST_KINDS: [AssistKind; 5] =
    [AssistKind::QuickFix, AssistKind::Extract, AssistKind::Inline, AssistKind::Rewrite, AssistKind::Organise];

fn kind(kind: AssistKind) -> CodeActionKind {
    match kind {
        AssistKind::QuickFix => CodeActionKind::QUICKFIX,
        AssistKind::Extract => CodeActionKind::REFACTOR_EXTRACT,
        AssistKind::Inline => CodeActionKind::REFACTOR_INLINE,
        AssistKind::Rewrite => CodeActionKind::REFACTOR_REWRITE,
        AssistKind::Organise => SORT,
    }
}
