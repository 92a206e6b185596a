//! Ids of elements in user pages.

use val3_analysis::body::{Expr, body};
use val3_analysis::db::{Db, File};
use val3_analysis::items::program::header;
use val3_analysis::items::project::program_files;
use val3_analysis::occurrences::page_elements;
use val3_analysis::pages::{HTML, page_ids, page_name};

use crate::RefactoringError;
use crate::owner::projects_of;

/// Checks that no script or style of the page names the element, and that no program computes its id.
pub(super) fn check_no_other_use(db: &dyn Db, page: File, id: &str) -> Result<(), RefactoringError> {
    let file = page.path(db).file_name().unwrap_or("");
    if is_named_elsewhere(db, page, id) {
        return Err(format!("a script or a style of `{file}` may name `{id}`. Rename it in the text").into());
    }
    let name = page_name(file, HTML).unwrap_or("");
    for project in projects_of(db, page) {
        for program in program_files(db, *project) {
            let body = body(db, *program);
            let may_be = page_elements(body).into_iter().any(|(of, element)| {
                let is_page = !matches!(body.expr(of), Expr::String(of) if !of.eq_ignore_ascii_case(name));
                is_page && !matches!(body.expr(element), Expr::String(_))
            });
            if may_be {
                let program = &header(db, *program).name;
                return Err(
                    format!("the program `{program}` computes the id of an element, which may be `{id}`").into()
                );
            }
        }
    }
    Ok(())
}

/// Whether the HTML file contains the id as a selector (`#id`) or in quotes, outside comments and the attributes `id`
/// and `for`.
fn is_named_elsewhere(db: &dyn Db, page: File, id: &str) -> bool {
    let text = page.text(db);
    let ids = page_ids(db, page);
    let known: Vec<usize> = ids.declared.iter().chain(&ids.named).map(|(_, range)| range.start().into()).collect();
    text.match_indices(id).any(|(at, _)| {
        let before = text.get(..at).and_then(|before| before.chars().next_back());
        let after = text.get(at + id.len()..).and_then(|after| after.chars().next());
        let is_reference = before.is_some_and(|letter| matches!(letter, '#' | '"' | '\'' | '`'));
        let mut parts = ids.parts.iter();
        let is_in_part = parts.any(|part| usize::from(part.start()) <= at && at < part.end().into());
        is_reference && is_in_part && !after.is_some_and(is_in_id) && !known.contains(&at)
    })
}

/// Whether a longer id would continue with the letter.
fn is_in_id(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | '-')
}

/// Checks that the new id is valid, and that no other element of the page has it.
pub(super) fn check(db: &dyn Db, page: File, new_id: &str) -> Result<(), RefactoringError> {
    if new_id.is_empty() || new_id.contains(is_forbidden) {
        return Err(format!("`{new_id}` is no id: some text without blanks, quotes, `&`, `<`, `>` and `\\`").into());
    }
    if page_ids(db, page).declares(new_id) {
        let file = page.path(db).file_name().unwrap_or("");
        return Err(format!("`{file}` has an element with the id `{new_id}` already").into());
    }
    Ok(())
}

/// Whether an id cannot contain the letter.
fn is_forbidden(letter: char) -> bool {
    letter.is_whitespace() || letter.is_control() || "\"'&<>\\".contains(letter)
}
