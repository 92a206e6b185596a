//! Scratch file: evaluated code as the body of a program with the variables of a stack frame.

use salsa::Setter as _;
use val3_analysis::body::{Stmt, StmtKind, body};
use val3_analysis::db::{Database, File, FileStatus};
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::items::program::code_element;
use val3_check::{CheckUnit, unit_refusals};
use val3_lang::types::Container;
use val3_syntax::encoding::Encoding;
use val3_syntax::xml::escaped;
use val3_syntax::{SyntaxKind, TextRange, TextSize, TextSlice, decode_entities};

use super::target::{EvaluationContext, Targets};
use crate::evaluate::CodeFault;

/// Program file before the code, without variables.
const HEAD: &str = "<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
     xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"eval__\"><Code>";
const TAIL: &str = "</Code></Program></Programs>\n";

const BEGIN: &str = "begin\n";

/// Evaluated code in the program of a target.
pub(super) struct Scratch<'t> {
    targets: &'t Targets,
    target: &'t EvaluationContext,
    file: File,
    /// The code, and its prefix length in bytes.
    code: String,
    before: usize,
    /// Offset of the code in the file.
    start: usize,
}

impl<'t> Scratch<'t> {
    /// Creates the file for `text` after the prefix `before`.
    pub(super) fn new(targets: &'t mut Targets, target: &'t EvaluationContext, before: &str, text: &str) -> Self {
        let code = format!("{before}{text}");
        let (head, tail) = around(targets, target);
        let start = head.len() + BEGIN.len();
        let text = format!("{head}{BEGIN}{}\nend{tail}", escaped(&code));
        let file = set(targets, target, text);
        Self { targets, target, file, code, before: before.len(), start }
    }

    pub(super) fn file(&self) -> File {
        self.file
    }

    pub(super) fn db(&self) -> &Database {
        database(self.targets, self.target)
    }

    /// First fault in the evaluated code. Unlike a program, a debugger shows entire collections, so their missing key is no
    /// fault.
    pub(super) fn fault(&self) -> Option<CodeFault> {
        let unit = CheckUnit::Program(self.target.project, self.file);
        let refusals = unit_refusals(self.db(), unit);
        // The header comes from a program that was compiled, so its faults are ignored.
        let code = TextSize::try_from(self.start.saturating_sub(BEGIN.len())).ok()?;
        let collection = self.shown_collection();
        let mut in_file = refusals.into_iter().filter(|found| found.place.file == self.file);
        let found = in_file.find(|found| found.place.range.start() >= code && Some(found.place.range) != collection)?;
        let offset = |at: TextSize| self.offset(at.into()).saturating_sub(self.before);
        let range = offset(found.place.range.start())..offset(found.place.range.end());
        Some(CodeFault::at(found.message, self.code.part(self.before..), range))
    }

    /// Range of the evaluated expression if its value is a collection.
    fn shown_collection(&self) -> Option<TextRange> {
        let (db, project) = (self.db(), self.target.project);
        let body = body(db, self.file);
        let [Stmt { kind: StmtKind::Print(id), .. }] = body.block.as_slice() else { return None };
        let is_collection = infer(db, project, self.file).ty(*id).container == Container::Collection;
        (is_collection && self.before > 0).then(|| body.range(*id))
    }

    /// Offset in the evaluated code of a byte in the file.
    pub(super) fn offset(&self, offset: usize) -> usize {
        let escaped = escaped(&self.code);
        let before = escaped.get(..offset.saturating_sub(self.start)).unwrap_or(&escaped);
        decode_entities(before).len()
    }

    /// Offset in the file of the character after the first `at` bytes of the evaluated code.
    pub(super) fn position(&self, at: usize) -> usize {
        let before = self.code.get(..self.before + at).unwrap_or(&self.code);
        self.start + escaped(before).len()
    }
}

fn database<'t>(targets: &'t Targets, target: &EvaluationContext) -> &'t Database {
    // The application of a target always exists.
    targets.application(target.application).db()
}

/// Text of the program file before and after its code.
fn around(targets: &Targets, target: &EvaluationContext) -> (String, String) {
    let db = database(targets, target);
    let around = target.program.and_then(|file| around_code(db, file));
    around.unwrap_or_else(|| (HEAD.to_owned(), TAIL.to_owned()))
}

/// Text of a program file before and after its code; `None` without a complete code element.
fn around_code(db: &Database, file: File) -> Option<(String, String)> {
    let parse = parse(db, file);
    let element = code_element(parse.view())?;
    let end = element.view().child(SyntaxKind::END_TAG)?.range().start();
    let text = file.text(db);
    let head = text.get(..usize::from(element.tag_range().end()))?;
    Some((head.to_owned(), text.get(usize::from(end)..)?.to_owned()))
}

/// Sets the text of the scratch file in the target's project.
fn set(targets: &mut Targets, target: &EvaluationContext, text: String) -> File {
    let key = (target.application, target.project);
    let known = targets.files.get(&key).copied();
    let db = targets.application_mut(target.application).db_mut();
    let file = match known {
        Some(file) => {
            if **file.text(db) != *text {
                file.set_text(db).to(text.into());
            }
            file
        }
        None => {
            let path = target.project.manifest(db).path(db).with_file_name("eval__.pgx");
            File::new(db, path, text.into(), FileStatus::Read { encoding: Encoding::Utf8, mismatch: None })
        }
    };
    targets.files.insert(key, file);
    file
}
