//! Removes faults that are consequences of a syntax fault, so that one mistake causes one message.

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, FileRange, FileStatus};
use val3_analysis::items::faults::text_faults;
use val3_analysis::problem::{Problem, ProblemKind};
use val3_syntax::TextSize;
use val3_syntax::error::SyntaxError;

/// Returns the problems in `file` that are not consequences of syntax faults. Problems on a line with a syntax error
/// are removed, and problems with misplaced elements if elements are not closed properly.
pub(crate) fn without_cascades<'p>(db: &dyn Db, file: File, problems: &'p [Problem]) -> Vec<&'p Problem> {
    let errors = &text_faults(db, file).errors;
    // The empty text of an unreadable file has faults, but they are consequences themselves.
    let is_unreadable = matches!(file.status(db), FileStatus::Unreadable(_));
    if errors.is_empty() || problems.is_empty() || is_unreadable {
        return problems.iter().collect();
    }
    let faults = FileFaults::new(file, file.text(db), errors);
    problems.iter().filter(|problem| !faults.may_cause(problem)).collect()
}

/// Syntax faults of a file.
struct FileFaults {
    file: File,
    lines: LineStarts,
    broken_lines: FxHashSet<usize>,
    /// Whether elements are not closed properly.
    broken_structure: bool,
}

impl FileFaults {
    fn new(file: File, text: &str, errors: &[SyntaxError]) -> Self {
        let lines = LineStarts::new(text);
        let broken = errors.iter().filter(|error| error.kind.breaks_line());
        let broken = broken.flat_map(|error| lines.line(error.range.start())..=lines.line(error.range.end()));
        let broken_lines = broken.collect();
        let broken_structure = errors.iter().any(|error| error.kind.breaks_structure());
        Self { file, lines, broken_lines, broken_structure }
    }

    /// Whether the problem is on a line with a fault, or about elements if they are not closed properly.
    fn may_cause(&self, problem: &Problem) -> bool {
        let FileRange { file, range } = problem.place;
        self.broken_structure && is_about_structure(&problem.kind)
            || file == self.file && self.broken_lines.contains(&self.lines.line(range.start()))
    }
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
