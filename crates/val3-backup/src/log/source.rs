//! Source lines of messages: the programs of applications that are at hand.

use std::collections::BTreeMap;

use val3_syntax::encoding::decode;
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, parse};

use super::subject::Subject;
use crate::{BackupFile, BackupFiles};

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

impl ProgramSources {
    /// Collects the programs in a backup. They are only read when a message refers to them.
    #[must_use]
    pub fn new(files: &[BackupFile]) -> Self {
        let mut programs: BTreeMap<String, Vec<Program>> = BTreeMap::new();
        for file in files {
            let mut parts = file.path.rsplit('/');
            let name = parts.next().and_then(|name| name.rsplit_once('.'));
            let Some((name, _)) = name.filter(|(_, extension)| extension.eq_ignore_ascii_case("pgx")) else { continue };
            let program = Program { application: parts.next().unwrap_or("").to_owned(), path: file.path.clone() };
            programs.entry(name.to_lowercase()).or_default().push(program);
        }
        Self(programs)
    }

    /// Returns the lines that a message may refer to. Several applications can have a program of the name: lines with
    /// the token in the message have precedence, then lines of `application`.
    #[must_use]
    pub fn lines(&self, files: &dyn BackupFiles, subject: &Subject, application: Option<&str>) -> Vec<SourceLine> {
        let (Some(program), Some(code_line)) = (&subject.program, subject.code_line) else { return Vec::new() };
        let programs = self.0.get(&program.to_lowercase()).map(Vec::as_slice).unwrap_or_default();
        let found = programs.iter().filter_map(|program| program.line(files, code_line, subject.token.as_deref()));
        let mut found: Vec<SourceLine> = found.collect();
        retain_if_any(&mut found, |line| !line.is_changed);
        let application = subject.application.as_deref().or(application);
        retain_if_any(&mut found, |line| Some(line.application.as_str()) == application);
        found
    }
}

/// Retains the lines for which `is_better` holds, if there are any.
fn retain_if_any(lines: &mut Vec<SourceLine>, is_better: impl Fn(&SourceLine) -> bool) {
    if lines.iter().any(&is_better) {
        lines.retain(is_better);
    }
}

impl Program {
    /// Returns a line of the code, from 1 at `begin`; `None` if the file cannot be read or is shorter.
    fn line(&self, files: &dyn BackupFiles, code_line: usize, token: Option<&str>) -> Option<SourceLine> {
        let text = decode(files.read(&self.path).ok()?).text;
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

/// Offsets of `begin` and of the end of the first code in a file.
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
