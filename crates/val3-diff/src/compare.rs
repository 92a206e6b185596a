//! Comparison of two file trees.

mod alignment;
mod application;
mod contents;
mod data;
mod dependents;
mod fields;
mod interface;
mod movement;
mod others;
mod placement;
mod program;
mod project;
mod renames;
mod renumbering;
mod settings;
mod text;
mod users;
mod values;

use std::collections::BTreeSet;

use crate::applications::{applications, matched, missing};
use crate::exclusions::BlankComparison;
use crate::model::{Comparison, Problem, TreeSide};
use crate::tree::FileTree;

/// Compares two trees. Differences in file format (XML layout, encoding, line ends, dialect, omitted or explicit
/// defaults) are ignored.
#[must_use]
pub fn compare(old: &FileTree, new: &FileTree) -> Comparison {
    compare_with(old, new, BlankComparison::Compared)
}

/// Compares two trees. If code layout is ignored, lines that differ only in layout count as equal lines of a program;
/// [`Comparison::leave_out`] then removes programs without other differences.
#[must_use]
pub fn compare_with(old: &FileTree, new: &FileTree, layout: BlankComparison) -> Comparison {
    let is_one_cell = old.has_one_cell() && new.has_one_cell();
    let trees = [old, new];
    let (old_files, new_files) = (old.files(is_one_cell), new.files(is_one_cell));
    let (old, new) = (applications(&old_files), applications(&new_files));
    let mut problems = missing_files(&missing(&old, &old_files), &missing(&new, &new_files));
    let users = users::users(&old, &new);
    let pairs = matched(&old, &new);
    let others = others::compare(trees, &pairs, is_one_cell);
    let trees = [old.as_slice(), new.as_slice()];
    let compared =
        pairs.iter().filter_map(|pair| application::compare(pair, trees, &users, layout, &mut problems)).collect();
    let settings = settings::compare(&old_files, &new_files, &mut problems);
    problems.sort();
    problems.dedup();
    Comparison { applications: compared, settings, others, problems, compared: pairs.len(), ..Comparison::default() }
}

/// Returns problems for listed files that are missing in only one tree. A file that is missing in both is not reported.
fn missing_files(old: &BTreeSet<(String, String)>, new: &BTreeSet<(String, String)>) -> Vec<Problem> {
    let lost = new
        .difference(old)
        .map(|(path, name)| missing_file(TreeSide::New, path, name, "; restore it, or remove the entry"));
    let found = old.difference(new).map(|(path, name)| missing_file(TreeSide::Old, path, name, ""));
    found.chain(lost).collect()
}

fn missing_file(side: TreeSide, path: &str, name: &str, help: &str) -> Problem {
    Problem {
        path: path.to_owned(),
        side,
        message: format!("the project file lists `{name}`, and there is no such file{help}"),
    }
}
