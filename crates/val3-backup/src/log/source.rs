//! Source lines of messages, from the programs of available applications.

use std::collections::BTreeMap;

use val3_syntax::encoding::decode;
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, parse};

use super::subject::Subject;
use crate::{BackupFile, BackupFiles, UnreadFile};

/// Programs of applications, by name in lower case.
#[derive(Debug, Default)]
pub struct ProgramSources(BTreeMap<String, Vec<Program>>);

/// File of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Program {
    /// Name of the folder, which usually is the name of the application.
    application: String,
    path: String,
}

/// Line of a program that a message refers to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceLine {
    /// Application.
    pub application: String,
    /// Path of the file in the backup.
    pub path: String,
    /// Line number in the file, from 1.
    pub line: usize,
    /// Code of the line, without blanks around it.
    pub text: String,
    /// Whether the line no longer contains the token in the message, so that the program was changed since.
    pub is_changed: bool,
}

/// Lines to which a message may refer.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FoundLines {
    /// Lines.
    pub lines: Vec<SourceLine>,
    /// Programs that cannot be read.
    pub unread: Vec<UnreadFile>,
}

impl ProgramSources {
    /// Collects the programs in `usrapp`, or all programs if the backup has no such folder. They are only read when a message refers to them.
    #[must_use]
    pub fn new(files: &[BackupFile]) -> Self {
        let mut programs: BTreeMap<String, Vec<Program>> = BTreeMap::new();
        let has_applications = files.iter().any(|file| is_of_application(&file.path));
        for file in files.iter().filter(|file| !has_applications || is_of_application(&file.path)) {
            let mut parts = file.path.rsplit('/');
            let name = parts.next().and_then(|name| name.rsplit_once('.'));
            let Some((name, _)) = name.filter(|(_, extension)| extension.eq_ignore_ascii_case("pgx")) else { continue };
            let program = Program { application: parts.next().unwrap_or("").to_owned(), path: file.path.clone() };
            programs.entry(name.to_lowercase()).or_default().push(program);
        }
        Self(programs)
    }

    /// Returns the lines to which a message may refer. Several applications can have a program of the name: lines with
    /// the token in the message have precedence, then lines of `application`.
    #[must_use]
    pub fn lines(&self, files: &dyn BackupFiles, subject: &Subject, application: Option<&str>) -> FoundLines {
        let (Some(program), Some(code_line)) = (&subject.program, subject.code_line) else {
            return FoundLines::default();
        };
        let mut found = FoundLines::default();
        for program in self.0.get(&program.to_lowercase()).into_iter().flatten() {
            match files.read(&program.path) {
                Ok(bytes) => found.lines.extend(program.line(bytes, code_line, subject.token.as_deref())),
                Err(reason) => found.unread.push(UnreadFile { path: program.path.clone(), reason }),
            }
        }
        retain_if_any(&mut found.lines, |line| !line.is_changed);
        let application = subject.application.as_deref().or(application);
        retain_if_any(&mut found.lines, |line| Some(line.application.as_str()) == application);
        found
    }
}

/// Whether the file is in `usrapp`. Programs in other folders are templates.
fn is_of_application(path: &str) -> bool {
    path.split('/').any(|part| part.eq_ignore_ascii_case("usrapp"))
}

/// Retains the lines for which `is_better` holds, if there are any.
fn retain_if_any(lines: &mut Vec<SourceLine>, is_better: impl Fn(&SourceLine) -> bool) {
    if lines.iter().any(&is_better) {
        lines.retain(is_better);
    }
}

impl Program {
    /// Returns a line of the code in the file's content, from 1 at `begin`; `None` if the code is shorter.
    fn line(&self, content: Vec<u8>, code_line: usize, token: Option<&str>) -> Option<SourceLine> {
        let text = decode(content).text;
        let (begin, end) = code_range(parse(&text).view())?;
        let code = text.get(begin..end)?.lines().nth(code_line.checked_sub(1)?)?.trim();
        let line = text.get(..begin)?.matches('\n').count() + code_line;
        // The controller shortens long tokens.
        let token = token.map(|token| token.trim_end_matches("..."));
        let is_changed = token.is_some_and(|token| !code.to_lowercase().contains(&token.to_lowercase()));
        Some(SourceLine {
            application: self.application.clone(),
            path: self.path.clone(),
            line,
            text: code.to_owned(),
            is_changed,
        })
    }
}

/// Offsets of `begin` and of the code's end, for the first code in a file.
fn code_range(node: View<'_>) -> Option<(usize, usize)> {
    node.children().find_map(|child| match child.kind() {
        SyntaxKind::CODE => {
            let begin = child.token(SyntaxKind::BEGIN_KW)?.range().start();
            Some((begin.into(), child.range().end().into()))
        }
        SyntaxKind::ELEMENT => code_range(child),
        _ => None,
    })
}
