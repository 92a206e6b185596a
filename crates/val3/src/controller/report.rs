//! Lines about differences and planned changes.

use val3_controller::{ControllerPath, FileDifference, FileDifferences, PlannedChange, SideChange};

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
    let line = |change: &PlannedChange| match (&change.old, &change.new) {
        (None, Some(new)) => format!("add      {} ({})", change.path, shown_bytes(new.size)),
        (_, Some(new)) => format!("replace  {} ({})", change.path, shown_bytes(new.size)),
        (_, None) => format!("remove   {}", change.path),
    };
    changes.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_few_digits() {
        assert_eq!([9_999, 10_500, 12_345_678].map(shown_bytes), ["9999 bytes", "10 kB", "12 MB"]);
    }
}
