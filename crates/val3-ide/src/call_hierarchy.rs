//! Incoming and outgoing calls of a program. Tasks that it creates count as calls.

use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::items::project::{items, program_files};
use val3_analysis::occurrences::{Symbol, occurrences};
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::navigate::{declaration, name_at};
use crate::owner::owner;
use crate::references::uses;

/// A program in the call hierarchy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CallItem {
    /// Program name.
    pub name: SmolStr,
    /// Project name: the name of the `.pjx`.
    pub project: String,
    /// Program file.
    pub file: File,
    /// Range of the name in the file.
    pub range: TextRange,
}

/// A calling or called program, with the locations of the calls.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    /// The other program.
    pub item: CallItem,
    /// Ranges of the program names in the calls, in the caller's file.
    pub places: Vec<TextRange>,
    /// Whether one of the calls creates a task.
    pub in_task: bool,
}

/// Program named at a position, otherwise the program whose code contains the position.
pub fn call_item(db: &dyn Db, at: FilePosition) -> Option<CallItem> {
    if let Some((_, found)) = name_at(db, at)
        && let Symbol::Program(project, name) = &found.symbol
    {
        return item(db, *project, name);
    }
    item_of(db, owner(db, at.file)?, at.file)
}

/// Programs that call the program in `file`, sorted by path.
pub fn incoming_calls(db: &dyn Db, file: File) -> Vec<Call> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    let Some(callee) = item_of(db, project, file) else { return Vec::new() };
    let mut calls: Vec<Call> = Vec::new();
    for (caller, from, range) in uses(db, &Symbol::Program(project, callee.name)) {
        let Some(call) = called(body(db, caller), range) else { continue };
        let Some(item) = item_of(db, from, caller) else { continue };
        add(&mut calls, item, range, call.in_task);
    }
    calls.sort_by(|a, b| a.item.file.path(db).cmp(b.item.file.path(db)));
    calls
}

/// Programs that the program in `file` calls, in the order of the first call.
pub fn outgoing_calls(db: &dyn Db, file: File) -> Vec<Call> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    let own = body(db, file);
    let mut calls: Vec<Call> = Vec::new();
    for found in occurrences(db, project, file) {
        let Symbol::Program(of, name) = &found.symbol else { continue };
        let Some(call) = called(own, found.range) else { continue };
        let Some(item) = item(db, *of, name) else { continue };
        add(&mut calls, item, found.range, call.in_task);
    }
    calls
}

fn add(calls: &mut Vec<Call>, item: CallItem, place: TextRange, in_task: bool) {
    match calls.iter_mut().find(|call| call.item == item) {
        Some(call) => {
            call.places.push(place);
            call.in_task |= in_task;
        }
        None => calls.push(Call { item, places: vec![place], in_task }),
    }
}

struct CallSiteKind {
    in_task: bool,
}

/// Call whose program name is at `range`; `None` if the name is not called.
fn called(body: &Body, range: TextRange) -> Option<CallSiteKind> {
    body.stmts().into_iter().find_map(|stmt| {
        let (call, in_task) = match &stmt.kind {
            StmtKind::Call(id) => (id, false),
            StmtKind::TaskCreate { arguments, .. } => (arguments.last()?, true),
            _ => return None,
        };
        names_callee(body, *call, range).then_some(CallSiteKind { in_task })
    })
}

/// Whether the expression is a call with its callee at `range`.
fn names_callee(body: &Body, call: ExprId, range: TextRange) -> bool {
    match body.expr(call) {
        Expr::Call(callee, _) => body.range(*callee).contains_range(range),
        _ => false,
    }
}

fn item(db: &dyn Db, project: Project, name: &str) -> Option<CallItem> {
    item_of(db, project, *items(db, project).programs.get(name)?)
}

fn item_of(db: &dyn Db, project: Project, file: File) -> Option<CallItem> {
    if !program_files(db, project).contains(&file) {
        return None;
    }
    let name = val3_analysis::items::program::header(db, file).name.clone();
    let place: FileRange = declaration(db, &Symbol::Program(project, name.clone()))?;
    // If two programs have the same name, the first one counts.
    let counts = place.file == file;
    let project = project.manifest(db).path(db).file_stem().unwrap_or("").to_owned();
    counts.then_some(CallItem { name, project, file, range: place.range })
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::{MarkedListing, shown};

    const LISTING: &str = "library part \"Disk://part/part.pjx\"\ncall pick()\ncall part:weigh()\ntaskCreate \"t\",10,pick()\nif true\n  call pick()\nendIf\nprogram pick()\nbegin\n  call part:weigh()\nend\n--- part\npublic program weigh()\nbegin\nend\n";

    /// Renders the calls, with their locations in the caller's file, which `caller` selects.
    fn check(calls: &[Call], caller: impl Fn(&Call) -> File, db: &dyn Db, expected: Expect) {
        expected.assert_eq(&calls.iter().map(|call| line(db, call, caller(call))).collect::<String>());
    }

    fn line(db: &dyn Db, call: &Call, caller: File) -> String {
        let places = call.places.iter().map(|range| shown(db, FileRange { file: caller, range: *range }));
        let places: Vec<String> = places.collect();
        let task = if call.in_task { " in a task" } else { "" };
        format!("{}:{}{task}: {}\n", call.item.project, call.item.name, places.join(", "))
    }

    #[test]
    fn outgoing_calls_are_listed() {
        let marked = MarkedListing::new(&LISTING.replacen("call pick", "ca$0ll pick", 1));
        let item = call_item(marked.db(), marked.at()).unwrap();
        assert_eq!(item.name, "start");
        let calls = outgoing_calls(marked.db(), item.file);
        check(
            &calls,
            |_| item.file,
            marked.db(),
            expect![[r#"
            main:pick in a task: main/start.pgx:5 pick, main/start.pgx:7 pick, main/start.pgx:9 pick
            part:weigh: main/start.pgx:6 weigh
        "#]],
        );
    }

    fn incoming(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let item = call_item(marked.db(), marked.at()).unwrap();
        let calls = incoming_calls(marked.db(), item.file);
        check(&calls, |call| call.item.file, marked.db(), expected);
    }

    #[test]
    fn incoming_calls_of_all_projects_are_listed() {
        incoming(
            &LISTING.replacen("call pick", "call pi$0ck", 1),
            expect![[r#"
            main:start in a task: main/start.pgx:5 pick, main/start.pgx:7 pick, main/start.pgx:9 pick
        "#]],
        );
        incoming(
            &LISTING.replacen("part:weigh", "part:we$0igh", 1),
            expect![[r#"
            main:pick: main/pick.pgx:5 weigh
            main:start: main/start.pgx:6 weigh
        "#]],
        );
    }
}
