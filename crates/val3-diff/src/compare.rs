//! The comparison of two trees.

mod application;
mod data;
mod dependents;
mod fields;
mod interface;
mod movement;
mod placement;
mod program;
mod project;
mod settings;
mod text;
mod users;
mod values;

use std::collections::BTreeSet;

use crate::applications::{applications, matched, missing};
use crate::model::{Comparison, Problem, Side};
use crate::tree::Tree;

/// Compares two trees. Differences in the form of the files (XML layout, encoding, line ends, the dialect, defaults that are
/// written or left out) are none.
#[must_use]
pub fn compare(old: &Tree, new: &Tree) -> Comparison {
    let is_one_cell = old.has_one_cell() && new.has_one_cell();
    let (old_files, new_files) = (old.files(is_one_cell), new.files(is_one_cell));
    let (old, new) = (applications(&old_files), applications(&new_files));
    let mut problems = differing(missing(&old, &old_files, Side::Old), missing(&new, &new_files, Side::New));
    let users = users::users(&old, &new);
    let pairs = matched(&old, &new);
    let compared = pairs.iter().filter_map(|pair| application::compare(pair, &users, &mut problems)).collect();
    let settings = settings::compare(&old_files, &new_files, &mut problems);
    problems.sort();
    problems.dedup();
    Comparison { applications: compared, settings, problems, compared: pairs.len(), ..Comparison::default() }
}

/// The problems of one side alone. What was missing before is no news.
fn differing(old: Vec<Problem>, new: Vec<Problem>) -> Vec<Problem> {
    let key = |problem: &Problem| (problem.path.clone(), problem.message.clone());
    let (old_keys, new_keys): (BTreeSet<_>, BTreeSet<_>) =
        (old.iter().map(key).collect(), new.iter().map(key).collect());
    let old = old.into_iter().filter(|problem| !new_keys.contains(&key(problem)));
    let new = new.into_iter().filter(|problem| !old_keys.contains(&key(problem)));
    old.chain(new).collect()
}
