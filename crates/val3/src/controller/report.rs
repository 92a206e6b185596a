//! Lines about differences and planned changes.

use val3_controller::{ControllerPath, FileDifference, FileDifferences, PlannedChange, SideChange};
use val3_lang::suggest::{proposals, question};

/// Size for people.
pub(crate) fn shown_bytes(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} bytes"),
        10_000..10_000_000 => format!("{} kB", bytes / 1000),
        _ => format!("{} MB", bytes / 1_000_000),
    }
}

/// Number of files for people.
pub(crate) fn counted_files(count: usize) -> String {
    if count == 1 { "1 file".to_owned() } else { format!("{count} files") }
}

/// Paths for people, at most 20.
pub(crate) fn listed_files(paths: &[ControllerPath]) -> String {
    const SHOWN: usize = 20;
    let shown = paths.iter().take(SHOWN).map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ");
    match paths.len().saturating_sub(SHOWN) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

/// What to do about a name that no application of the controller has.
pub(super) fn application_help(name: &str, present: &[String]) -> String {
    let near = question(proposals(name, present.iter().map(String::as_str)));
    let quoted = || present.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    near.unwrap_or_else(|| match present {
        [] => "the folder `usr/usrapp` of the controller is empty".to_owned(),
        _ => format!("its applications are in {}", quoted()),
    })
}

/// One line for each file with a difference.
pub(crate) fn status_lines(differences: &FileDifferences) -> Vec<String> {
    differences.iter().map(|(path, difference)| status_line(path, *difference)).collect()
}

fn status_line(path: &ControllerPath, difference: FileDifference) -> String {
    let (sides, change) = match difference {
        FileDifference::Local(change) => ("local", change_word(change).to_owned()),
        FileDifference::Controller(change) => ("controller", change_word(change).to_owned()),
        FileDifference::Conflict { local, controller } => {
            ("conflict", format!("{} here, {} on the controller", change_word(local), change_word(controller)))
        }
        FileDifference::Alike(_) => ("alike", "same change on both sides".to_owned()),
    };
    format!("{sides:10}  {path}: {change}")
}

/// Word for a change of one side.
pub(crate) const fn change_word(change: SideChange) -> &'static str {
    match change {
        SideChange::Added => "added",
        SideChange::Modified => "changed",
        SideChange::Removed => "removed",
    }
}

/// One line for each change of a push, in its order.
pub(crate) fn planned_lines(changes: &[PlannedChange]) -> Vec<String> {
    changes.iter().map(planned_line).collect()
}

fn planned_line(change: &PlannedChange) -> String {
    match (&change.old, &change.new) {
        (None, Some(new)) => format!("add      {} ({})", change.path, shown_bytes(new.size)),
        (_, Some(new)) => format!("replace  {} ({})", change.path, shown_bytes(new.size)),
        (_, None) => format!("remove   {}", change.path),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_few_digits() {
        assert_eq!([9_999, 10_500, 12_345_678].map(shown_bytes), ["9999 bytes", "10 kB", "12 MB"]);
    }
}
