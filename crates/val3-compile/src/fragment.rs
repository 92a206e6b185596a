//! Fragments: code that a debugger executes in the stack frame of a program in memory.

use smol_str::SmolStr;
use val3_analysis::body::{ExprId, Stmt, StmtKind, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_bytecode::{Fragment, FragmentValue, FrameVariable, Image, Program, Storage};
use val3_syntax::TextRange;

use crate::closings::Closings;
use crate::code::CodeBuilder;
use crate::counting::Counting;
use crate::emitter::Emitter;
use crate::error::{CompileError, CompileLimit, Result};
use crate::expressions::Expressions;
use crate::frame::Finished;
use crate::kinds::Kinds;
use crate::statements::Statements;
use crate::unit::CompileUnit;

/// Names that a fragment can use.
#[derive(Clone, Copy)]
pub struct FragmentScope<'i> {
    /// Image of the project in memory.
    pub image: &'i Image,
    /// The program's variables.
    pub variables: &'i [FrameVariable],
}

/// Compiles the statements in `file`, which can use a program's variables.
///
/// # Errors
/// A limit that the statements exceed.
pub fn compile_statements(
    db: &dyn Db,
    project: Project,
    file: File,
    scope: FragmentScope<'_>,
) -> std::result::Result<Fragment, CompileError> {
    compile(db, project, file, scope, |statements| {
        statements.block(&body(db, file).block)?;
        Ok(None)
    })
}

/// Compiles the expression in `file`, which consists of `? expression`, so that its value can be read.
///
/// # Errors
/// A limit that the expression exceeds, or other code in the file.
pub fn compile_expression(
    db: &dyn Db,
    project: Project,
    file: File,
    scope: FragmentScope<'_>,
) -> std::result::Result<Fragment, CompileError> {
    compile(db, project, file, scope, |statements| match body(db, file).block.as_slice() {
        [Stmt { kind: StmtKind::Print(id), range }] => statements.watched(*range, *id).map(Some),
        _ => Err(CompileLimit::Unclear),
    })
}

fn compile(
    db: &dyn Db,
    project: Project,
    file: File,
    FragmentScope { image, variables }: FragmentScope<'_>,
    write: impl FnOnce(&mut Statements<'_, '_>) -> Result<Option<FragmentValue>>,
) -> std::result::Result<Fragment, CompileError> {
    let error = |limit| CompileError::at(file.path(db).as_str(), 1, limit);
    let kinds = Kinds::new(db, items(db, project).arm);
    let data: Vec<SmolStr> = image.data.iter().map(|data| SmolStr::from(&data.name)).collect();
    let programs: Vec<SmolStr> = image.programs.iter().map(|program| SmolStr::from(&program.name)).collect();
    let mut unit = CompileUnit::new(kinds, project, data.iter(), programs.iter()).map_err(error)?;
    unit.adopt_imports(image);
    let emitter = Emitter::new(&mut unit, file.text(db), Counting::default());
    let values = Expressions::new(emitter, body(db, file), infer(db, project, file));
    let mut statements = Statements::new(values, header(db, file), Closings::default());
    let declared = declare(&mut statements, variables).map_err(error)?;
    let value = write(&mut statements).map_err(error)?;
    let program = finished(&mut statements, declared).map_err(error)?;
    Ok(match value {
        Some(value) => Fragment::expression(program, value),
        None => Fragment::statements(program),
    })
}

/// Declares a reference for each variable: a place for a single value on the frame, otherwise a view.
fn declare(statements: &mut Statements<'_, '_>, variables: &[FrameVariable]) -> Result<Vec<FrameVariable>> {
    let frame = statements.out().frame_mut();
    frame.is_fragment = true;
    let references = variables.iter().map(|variable| {
        let storage = match variable.storage {
            Storage::Value(_) | Storage::Place(_) => Storage::Place(frame.lasting_place()?),
            Storage::Part(_) | Storage::View(_) => Storage::View(frame.lasting_view()?),
        };
        frame.declare(SmolStr::from(&variable.name), storage);
        Ok(FrameVariable { storage, ..variable.clone() })
    });
    references.collect()
}

fn finished(statements: &mut Statements<'_, '_>, variables: Vec<FrameVariable>) -> Result<Program> {
    let (code, tables, frame) = statements.out().finish()?;
    let CodeBuilder { lines, texts, copies, instructions, calls, tasks, .. } = tables;
    let Finished { size, nums, parts, .. } = frame;
    let frame = size;
    Ok(Program {
        variables,
        frame,
        nums,
        parts,
        code,
        lines,
        texts,
        copies,
        instructions,
        calls,
        tasks,
        ..Program::default()
    })
}

impl Statements<'_, '_> {
    /// Compiles an expression whose value can be read; containers are passed entirely.
    fn watched(&mut self, range: TextRange, id: ExprId) -> Result<FragmentValue> {
        self.out().code().line(range);
        let found = self.or_stop(&[id], |statements| statements.values().watched(id))?;
        let (site, base) = found.ok_or(CompileLimit::Unclear)?;
        Ok(FragmentValue { site, kind: self.out().kind(base)? })
    }
}
