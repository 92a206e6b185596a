//! Amount of checked code.

use std::iter::Sum;

use memchr::memchr_iter;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project;
use val3_syntax::TextSlice;

/// Counts over the requested projects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CheckStatistics {
    /// Number of projects: applications, libraries and types.
    pub applications: usize,
    /// Number of files in these projects.
    pub files: usize,
    /// Number of programs.
    pub programs: usize,
    /// Number of code lines, without blank lines and comments.
    pub code_lines: usize,
}

/// Counts the content of `project`.
pub fn statistics(db: &dyn Db, project: Project) -> CheckStatistics {
    let programs = project::program_files(db, project);
    CheckStatistics {
        applications: 1,
        files: 1 + project::data_files(db, project).len() + programs.len(),
        programs: programs.len(),
        code_lines: programs.iter().map(|file| code_lines(db, *file)).sum(),
    }
}

impl Sum for CheckStatistics {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), |sum, part| Self {
            applications: sum.applications + part.applications,
            files: sum.files + part.files,
            programs: sum.programs + part.programs,
            code_lines: sum.code_lines + part.code_lines,
        })
    }
}

/// Number of lines from `begin` to `end` that are neither blank nor a comment.
fn code_lines(db: &dyn Db, file: File) -> usize {
    let text: &str = file.text(db);
    let Some(start) = ["<Code", "<code"].iter().find_map(|tag| text.find(tag)) else { return 0 };
    let code = text.part(start..);
    let code = code.split_once('>').map_or("", |(_, code)| code);
    let code = code.split("</").next().unwrap_or("");
    let ends = memchr_iter(b'\n', code.as_bytes()).chain([code.len()]);
    let mut start = 0;
    let lines = ends.map(|end| code.as_bytes().part(std::mem::replace(&mut start, end + 1)..end));
    lines.map(<[u8]>::trim_ascii).filter(|line| !line.is_empty() && !line.starts_with(b"//") && !is_mark(line)).count()
}

/// Whether the line contains only the marks of a CDATA section.
fn is_mark(line: &[u8]) -> bool {
    matches!(line, b"<![CDATA[" | b"]]>")
}
