//! `textDocument/codeAction` and `codeAction/resolve`

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::*;
use val3_ide::{Assist, AssistKind, FileRange, QuickFix};

use super::execute_command::apply;
use crate::convert::{NotPossible, diagnostic, workspace_edit};
use crate::loose;
use crate::snapshot::{Refusal, Snapshot};

/// Sorting a list of a project file.
const SORT: CodeActionKind = CodeActionKind::new("source.sort");

/// The kinds of what is offered.
pub(super) const KINDS: [CodeActionKind; 6] = [
    CodeActionKind::QUICKFIX,
    CodeActionKind::REFACTOR_EXTRACT,
    CodeActionKind::REFACTOR_INLINE,
    CodeActionKind::REFACTOR_REWRITE,
    CodeActionKind::SOURCE_FIX_ALL,
    SORT,
];

/// What was offered where, so that its edit can be computed later.
#[derive(Serialize, Deserialize)]
struct Offered {
    assist: String,
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
    let wanted = Wanted(params.context.only.as_deref());
    let mut actions = fixes(snapshot, at, &wanted);
    let kinds: Vec<AssistKind> = ASSIST_KINDS.into_iter().filter(|it| wanted.has(&kind(*it))).collect();
    for assist in val3_ide::assists(snapshot.db(), at, Some(&kinds)) {
        let place = Offered { assist: assist.id.to_owned(), uri: uri.clone(), range: params.range, version: None };
        actions.extend(offer(snapshot, at, assist, place));
    }
    let client = snapshot.session.client;
    let answer = actions.into_iter().filter_map(|action| match client.has_code_actions {
        true => Some(CodeActionOrCommand::CodeAction(action)),
        false => command(snapshot, action).map(CodeActionOrCommand::Command),
    });
    Ok(Some(answer.collect()))
}

/// The fixes of the findings at a place, and all safe ones of the file at once.
fn fixes(snapshot: &Snapshot, at: FileRange, wanted: &Wanted<'_>) -> Vec<CodeAction> {
    let Some(settings) = snapshot.settings else { return Vec::new() };
    let mut actions: Vec<CodeAction> = Vec::new();
    let projects = val3_ide::projects_of(snapshot.db(), at.file).iter();
    for project in projects.filter(|project| snapshot.projects.contains(project)) {
        let findings = val3_ide::project_diagnostics(snapshot.db(), settings, *project);
        let mut found: Vec<CodeAction> = Vec::new();
        if wanted.has(&CodeActionKind::QUICKFIX) {
            found.extend(val3_ide::quick_fixes(findings, at).iter().filter_map(|fix| quick_fix(snapshot, fix)));
        }
        if wanted.has(&CodeActionKind::SOURCE_FIX_ALL) {
            found.extend(fix_all(snapshot, &val3_ide::fix_all(snapshot.db(), findings, at.file)));
        }
        // Two projects that share a file find most things twice.
        found.into_iter().for_each(|action| {
            if !actions.contains(&action) {
                actions.push(action);
            }
        });
    }
    actions
}

fn quick_fix(snapshot: &Snapshot, fix: &QuickFix<'_>) -> Option<CodeAction> {
    Some(CodeAction {
        title: fix.title.clone(),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![diagnostic(snapshot, fix.diagnostic)]),
        edit: Some(workspace_edit(snapshot, &fix.change).ok()?),
        is_preferred: fix.safe.then_some(true),
        ..CodeAction::default()
    })
}

fn fix_all(snapshot: &Snapshot, change: &val3_ide::SourceChange) -> Option<CodeAction> {
    let edit = workspace_edit(snapshot, change).ok().filter(|_| !change.is_empty())?;
    Some(CodeAction {
        title: "Mend everything that can be mended safely".to_owned(),
        kind: Some(CodeActionKind::SOURCE_FIX_ALL),
        edit: Some(edit),
        ..CodeAction::default()
    })
}

/// An assist, with its edit where the client does not ask for it later, or part of it may not be possible.
fn offer(snapshot: &Snapshot, at: FileRange, assist: Assist, place: Offered) -> Option<CodeAction> {
    let (edit, data) = match is_lazy(snapshot, at) {
        true => (None, Some(serde_json::to_value(Offered { version: snapshot.version(at.file), ..place }).ok()?)),
        false => (Some(edit_of(snapshot, assist.id, at)?.ok()?), None),
    };
    Some(CodeAction { title: assist.title, kind: Some(kind(assist.kind)), edit, data, ..CodeAction::default() })
}

fn is_lazy(snapshot: &Snapshot, at: FileRange) -> bool {
    let client = snapshot.session.client;
    let can_all = client.changes_files.creates && client.changes_files.renames && client.changes_files.deletes;
    let owner = val3_ide::owner(snapshot.db(), at.file);
    let is_listed = owner.is_some_and(|project| !loose::is_manifest(project.manifest(&snapshot.db).path(&snapshot.db)));
    client.resolves_edits && can_all && is_listed
}

fn edit_of(snapshot: &Snapshot, id: &str, at: FileRange) -> Option<Result<WorkspaceEdit, NotPossible>> {
    let change = val3_ide::resolve_assist(snapshot.db(), id, at)?;
    Some(workspace_edit(snapshot, &change))
}

/// The edit of an action that was chosen. Its place means another one if the document was edited since.
pub(crate) fn resolve(snapshot: &Snapshot, action: &CodeAction) -> Result<CodeAction, Refusal> {
    let mut action = action.clone();
    let Some(offered) = action.data.take().and_then(|data| serde_json::from_value::<Offered>(data).ok()) else {
        return Ok(action);
    };
    let file = snapshot.file(&offered.uri)?;
    if snapshot.version(file) != offered.version {
        return Err(Refusal::Outdated);
    }
    let at = FileRange { file, range: snapshot.lines(file).text_range(offered.range) };
    let edit = edit_of(snapshot, &offered.assist, at).ok_or(Refusal::Outdated)?;
    action.edit = Some(edit?);
    Ok(action)
}

/// For clients that know commands alone: the server asks them to make the edit.
fn command(snapshot: &Snapshot, action: CodeAction) -> Option<Command> {
    apply(snapshot, action.title, action.edit?)
}

/// The kinds that a client asks for; a kind asks for those below it as well.
struct Wanted<'a>(Option<&'a [CodeActionKind]>);

impl Wanted<'_> {
    fn has(&self, kind: &CodeActionKind) -> bool {
        let covers = |wanted: &CodeActionKind| {
            let rest = kind.as_str().strip_prefix(wanted.as_str());
            wanted.as_str().is_empty() || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        self.0.is_none_or(|only| only.iter().any(covers))
    }
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
