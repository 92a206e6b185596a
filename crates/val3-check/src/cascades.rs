//! Removes faults that are consequences of a syntax fault, so that one mistake causes one message.

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, FileStatus};
use val3_analysis::items::faults::text_faults;
use val3_analysis::problem::{Problem, ProblemKind};
use val3_syntax::TextSize;

/// Returns the problems in `file` that are not consequences of syntax faults. Problems on a line with a syntax error
/// are removed, and problems with misplaced elements if elements are not closed properly.
pub(crate) fn without_cascades<'p>(db: &dyn Db, file: File, problems: &'p [Problem]) -> Vec<&'p Problem> {
    let errors = &text_faults(db, file).errors;
    // The empty text of an unreadable file has faults, but they are consequences themselves.
    let is_unreadable = matches!(file.status(db), FileStatus::Unreadable(_));
    if errors.is_empty() || problems.is_empty() || is_unreadable {
        return problems.iter().collect();
    }
    let lines = LineStarts::new(file.text(db));
    let broken_structure = errors.iter().any(|error| error.kind.breaks_structure());
    let broken_lines: FxHashSet<usize> = errors
        .iter()
        .filter(|error| error.kind.breaks_line())
        .flat_map(|error| lines.line(error.range.start())..=lines.line(error.range.end()))
        .collect();
    let is_echo = |problem: &Problem| {
        broken_structure && is_about_structure(&problem.kind)
            || problem.place.file == file && broken_lines.contains(&lines.line(problem.place.range.start()))
    };
    problems.iter().filter(|problem| !is_echo(problem)).collect()
}

fn is_about_structure(kind: &ProblemKind) -> bool {
    use ProblemKind::{MissingAttribute, MissingElement, UnexpectedElement};
    matches!(kind, UnexpectedElement { .. } | MissingAttribute { .. } | MissingElement { .. })
}

/// Start offsets of a text's lines.
struct LineStarts(Vec<u32>);

impl LineStarts {
    fn new(text: &str) -> Self {
        let ends = (1u32..).zip(text.bytes()).filter(|(_, byte)| *byte == b'\n');
        Self(ends.map(|(next, _)| next).collect())
    }

    /// Number of the line, from 0.
    fn line(&self, at: TextSize) -> usize {
        self.0.partition_point(|start| *start <= u32::from(at))
    }
}
