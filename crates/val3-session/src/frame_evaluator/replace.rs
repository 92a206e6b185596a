//! Replacement of a line in a program of a run. The file on the disk stays unchanged.

use std::error::Error;
use std::fmt;
use std::mem::{Discriminant, discriminant};
use std::ops::Range;
use std::sync::Arc;

use salsa::Setter as _;
use val3_analysis::db::{File, Sources};
use val3_analysis::items::parse;
use val3_analysis::paths::path_key;
use val3_bytecode::{Image, Op, Program};
use val3_check::{CheckUnit, unit_refusals};
use val3_compile::{CodeForm, FrameLayout, LayoutRequest, ReplacedLine, compile_with_layout};
use val3_debug::Debugger;
use val3_lang::fault::Fault;
use val3_lang::runtime_errors;
use val3_syntax::SyntaxKind;
use val3_syntax::view::View;
use val3_vm::{LineReplacement, ProgramId};

use super::FrameEvaluator;
use crate::code_lines::CodeFile;

/// Reason why a line is not replaced.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReplaceFault {
    /// The line opens, divides or closes other blocks than the present one.
    Blocks,
    /// The controller's compiler rejects the line; the text is the message.
    Code(String),
    /// A task executes the line, or the program with a line whose replacement needs other variables; the text is the
    /// reason.
    Busy(String),
    /// The program cannot be changed; the text is the reason.
    Unavailable(String),
}

impl fmt::Display for ReplaceFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Blocks => {
                f.write_str("the line would change the blocks of the program: load the changed project instead")
            }
            Self::Code(reason) | Self::Busy(reason) | Self::Unavailable(reason) => f.write_str(reason),
        }
    }
}

impl Error for ReplaceFault {}

/// Program whose line was replaced while tasks executed it, with the layout of its stack frames.
pub(super) struct PatchedProgram {
    program: Program,
    layout: FrameLayout,
}

/// Program in memory with its source.
struct ProgramSource {
    /// Index of the application with the database.
    application: usize,
    file: File,
    text: Arc<str>,
}

impl FrameEvaluator {
    /// Replaces the line at a row of a program's file in memory. Tasks continue with the new line.
    ///
    /// # Errors
    /// The line is no valid line at this place, or a task prevents the replacement. Then nothing has changed.
    pub fn replace_line(
        &mut self,
        debugger: &mut Debugger,
        program: ProgramId,
        row: u32,
        code: &str,
    ) -> Result<(), ReplaceFault> {
        let vm = &debugger.controller.vm;
        let image = vm.space.instance(program.instance).map(|instance| Arc::clone(&instance.image));
        let image = image.ok_or_else(|| unavailable("the application is not in memory"))?;
        let running = image.programs.get(usize::from(program.number));
        let running = running.ok_or_else(|| unavailable("the program is not in memory"))?;
        let source = self.source(&image, running)?;
        let code = code.trim_end_matches(['\r', '\n']);
        let text = self.edited(&source, row, code)?;
        let patched = vm.task_in(program).map(|_| self.patched(&image, program.number, &source));
        let before = Arc::clone(&source.text);
        self.set_text(&source, text.into());
        let new = Replacer { evaluator: self, image: &image, source: &source, program, row };
        let replaced = new.replace(debugger, patched.as_ref().map(Option::as_ref), code);
        let path = source.file.path(self.targets.application(source.application).db()).to_string();
        let (patched, result) = match replaced {
            Ok(patched) => (patched, Ok(())),
            Err(fault) => {
                self.set_text(&source, before);
                (patched.flatten(), Err(fault))
            }
        };
        match patched {
            Some(patched) => self.patched.insert(path, patched),
            None => self.patched.remove(&path),
        };
        result
    }

    /// Returns the source of a program in memory.
    fn source(&mut self, image: &Image, program: &Program) -> Result<ProgramSource, ReplaceFault> {
        let (application, _) =
            self.targets.project(&image.path).map_err(|error| ReplaceFault::Unavailable(error.to_string()))?;
        let db = self.targets.application(application).db();
        let path = image.files.get(program.file as usize).map(String::as_str).unwrap_or_default();
        let file = Sources::get(db).files(db).get(&path_key(path)).copied();
        let file = file.ok_or_else(|| unavailable("the source of the program is not known"))?;
        Ok(ProgramSource { application, file, text: file.text(db).to_string().into() })
    }

    /// Returns the text of a file with another line. The line must open and close the same blocks.
    fn edited(&self, source: &ProgramSource, row: u32, code: &str) -> Result<String, ReplaceFault> {
        if code.contains(|character: char| character.is_control() && character != '\t') {
            return Err(ReplaceFault::Code("write one line, without control characters".to_owned()));
        }
        let db = self.targets.application(source.application).db();
        let file = CodeFile::of(db, source.file);
        let line = file.inner_line(row).ok_or(ReplaceFault::Blocks)?;
        let encoded = file.encoded(row, code);
        let text = [source.text.get(..line.start), Some(encoded.as_str()), source.text.get(line.end..)];
        let text = text.into_iter().collect::<Option<Vec<_>>>().map(|parts| parts.concat());
        let text = text.ok_or_else(|| unavailable("the source of the program is not known"))?;
        let new = line.start..line.start + encoded.len();
        if block_keywords(parse(db, source.file).view(), &line)
            != block_keywords(val3_syntax::parse(&text).view(), &new)
        {
            return Err(ReplaceFault::Blocks);
        }
        Ok(text)
    }

    fn set_text(&mut self, source: &ProgramSource, text: Arc<str>) {
        let db = self.targets.application_mut(source.application).db_mut();
        source.file.set_text(db).to(text);
    }

    /// Returns the layout of a program that tasks execute; `None` if its code does not come from this source.
    fn patched(&mut self, image: &Image, number: u16, source: &ProgramSource) -> Option<PatchedProgram> {
        let running = image.programs.get(usize::from(number))?;
        let db = self.targets.application(source.application).db();
        if let Some(known) = self.patched.remove(source.file.path(db).as_str())
            && is_same_code(&known.program, running)
        {
            return Some(known);
        }
        let project = Sources::get(db).projects(db).get(&path_key(&image.path)).copied()?;
        let request = LayoutRequest { file: source.file, image, replaced: None };
        let (compiled, layout) = compile_with_layout(db, project, form_of(image), request).ok()?;
        let program = compiled.programs.into_iter().nth(usize::from(number))?;
        is_same_code(&program, running).then_some(PatchedProgram { program, layout })
    }
}

/// Replacement of a line whose text is already in the database.
struct Replacer<'a> {
    evaluator: &'a FrameEvaluator,
    /// Image in memory.
    image: &'a Image,
    source: &'a ProgramSource,
    program: ProgramId,
    row: u32,
}

impl Replacer<'_> {
    /// Checks and compiles the line, and replaces it. `before` is the layout, if known, of a program that tasks execute.
    /// Returns the new layout of such a program.
    fn replace(
        &self,
        debugger: &mut Debugger,
        before: Option<Option<&PatchedProgram>>,
        code: &str,
    ) -> Result<Option<PatchedProgram>, ReplaceFault> {
        let Self { image, program, row, .. } = *self;
        let (compiled, layout) = self.compiled(before.flatten())?;
        let number = usize::from(program.number);
        let new = compiled.programs.get(number).ok_or_else(|| unavailable("the program is not in memory"))?;
        let patched = match before {
            None => None,
            Some(before) => {
                if debugger.controller.vm.task_within(program, row).is_some() {
                    return Err(ReplaceFault::Busy("a task executes the line: wait until it has left it".to_owned()));
                }
                let fits = image
                    .programs
                    .get(number)
                    .is_some_and(|running| running.parts == new.parts && is_same_around(running, new, row));
                if before.is_none() || !layout.is_kept() || !fits {
                    let reason = "a task executes the program, whose loop or variables would change: wait until it has \
                                  left the program";
                    return Err(ReplaceFault::Busy(reason.to_owned()));
                }
                Some(PatchedProgram { program: new.clone(), layout })
            }
        };
        let replacement = LineReplacement { program, row, image: Arc::new(compiled) };
        debugger.replace_line(replacement, code).map_err(|Fault(code)| {
            let text = runtime_errors::find(code).map_or("", |error| error.short);
            ReplaceFault::Unavailable(format!("error {code}: {text}"))
        })?;
        Ok(patched)
    }

    /// Compiles the program with the line. The other programs and the data in memory stay.
    fn compiled(&self, before: Option<&PatchedProgram>) -> Result<(Image, FrameLayout), ReplaceFault> {
        let Self { image, source, program, row, .. } = *self;
        let db = self.evaluator.targets.application(source.application).db();
        let project = Sources::get(db).projects(db).get(&path_key(&image.path)).copied();
        let project = project.ok_or_else(|| unavailable("the source of the program is not known"))?;
        if let Some(refusal) = unit_refusals(db, CheckUnit::Program(project, source.file)).into_iter().next() {
            return Err(ReplaceFault::Code(refusal.message));
        }
        let replaced = before.map(|PatchedProgram { program, layout }| ReplacedLine { row, program, layout });
        let request = LayoutRequest { file: source.file, image, replaced };
        let form = form_of(image);
        if form == CodeForm::Counted {
            return Err(unavailable("the program counts its lines"));
        }
        let (compiled, layout) = compile_with_layout(db, project, form, request)
            .map_err(|error| ReplaceFault::Code(error.limit.to_string()))?;
        let names = |image: &Image| image.programs.iter().map(|program| program.name.clone()).collect::<Vec<_>>();
        let data = |image: &Image| image.data.iter().map(|data| data.name.clone()).collect::<Vec<_>>();
        if names(&compiled) != names(image) || data(&compiled) != data(image) {
            return Err(unavailable("the project in memory has other programs or data than its source"));
        }
        let Image { programs, imports, .. } = compiled;
        let mut image = Image { imports, ..image.clone() };
        let number = usize::from(program.number);
        if let (Some(running), Some(new)) = (image.programs.get_mut(number), programs.into_iter().nth(number)) {
            *running = new;
        }
        Ok((image, layout))
    }
}

fn unavailable(reason: &str) -> ReplaceFault {
    ReplaceFault::Unavailable(reason.to_owned())
}

/// Form of the code in an image. Only the debugged form has operations at the ends of loops.
pub(super) fn form_of(image: &Image) -> CodeForm {
    let has_counter = |program: &Program| program.code.iter().any(|step| step.mark.counter().is_some());
    match () {
        () if image.programs.iter().any(has_loop_end) => CodeForm::Debugged,
        () if image.programs.iter().any(has_counter) => CodeForm::Counted,
        () => CodeForm::Plain,
    }
}

/// Whether a closing keyword of the program is a separate operation.
fn has_loop_end(program: &Program) -> bool {
    let mut closings = program.closings.iter().filter_map(|closing| program.code.get(closing.op as usize));
    closings.any(|step| step.op == Op::Line)
}

/// Whether two programs have the same kinds of operations before and after the line at a row.
fn is_same_around(one: &Program, other: &Program, row: u32) -> bool {
    let Some(start) = one.first_op_at(row).or(other.first_op_at(row)) else {
        return operations(one) == operations(other);
    };
    operations_around(one, row, start) == operations_around(other, row, start)
}

/// Kinds of the operations before and after the line at a row. `start` is the first operation of the line, also for a
/// program without this line.
fn operations_around(program: &Program, row: u32, start: u32) -> [Option<Vec<Discriminant<Op>>>; 2] {
    let least = if program.first_op_at(row).is_some() { start + 1 } else { start };
    let next = program.lines.iter().chain(&program.closings).map(|line| line.op).filter(|op| *op >= least).min();
    let end = next.map_or(program.code.len(), |op| op as usize);
    let operations = operations(program);
    [operations.get(..start as usize), operations.get(end..)].map(|part| part.map(<[_]>::to_vec))
}

fn operations(program: &Program) -> Vec<Discriminant<Op>> {
    program.code.iter().map(|step| discriminant(&step.op)).collect()
}

/// Whether two programs have the same operations and stack frames. Stop marks may differ.
fn is_same_code(one: &Program, other: &Program) -> bool {
    let code = |program: &Program| program.code.iter().map(|step| step.op).collect::<Vec<_>>();
    one.frame == other.frame && one.nums == other.nums && code(one) == code(other)
}

/// Keywords in a range of a file that open, divide or close blocks.
fn block_keywords(file: View<'_>, range: &Range<usize>) -> Vec<SyntaxKind> {
    let mut found = Vec::new();
    collect_block_keywords(file, range, &mut found);
    found.sort_unstable_by_key(|(offset, _)| *offset);
    found.into_iter().map(|(_, kind)| kind).collect()
}

fn collect_block_keywords(node: View<'_>, range: &Range<usize>, found: &mut Vec<(usize, SyntaxKind)>) {
    for token in node.tokens() {
        let offset = usize::from(token.range().start());
        if range.contains(&offset) && is_block_keyword(token.kind()) {
            found.push((offset, token.kind()));
        }
    }
    for inner in node.children() {
        if usize::from(inner.range().start()) < range.end && usize::from(inner.range().end()) > range.start {
            collect_block_keywords(inner, range, found);
        }
    }
}

const fn is_block_keyword(kind: SyntaxKind) -> bool {
    use SyntaxKind as K;
    matches!(
        kind,
        K::BEGIN_KW
            | K::END_KW
            | K::IF_KW
            | K::ELSE_IF_KW
            | K::ELSE_KW
            | K::END_IF_KW
            | K::WHILE_KW
            | K::END_WHILE_KW
            | K::DO_KW
            | K::UNTIL_KW
            | K::FOR_KW
            | K::END_FOR_KW
            | K::SWITCH_KW
            | K::CASE_KW
            | K::BREAK_KW
            | K::DEFAULT_KW
            | K::END_SWITCH_KW
    )
}
