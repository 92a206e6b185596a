//! Compilation of a program.

use val3_analysis::body::{Body, body};
use val3_analysis::db::File;
use val3_analysis::infer::infer;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{Signature, signature};
use val3_analysis::items::suppressions::uncovered;
use val3_bytecode::{FrameVariable, Program, ProgramParam};

use crate::closings::Closings;
use crate::code::CodeBuilder;
use crate::code_form::CodeForm;
use crate::counting::Counting;
use crate::emitter::Emitter;
use crate::error::{CompileError, Result};
use crate::expressions::Expressions;
use crate::frame::Finished;
use crate::layout::{LayoutKeeper, LayoutRequest};
use crate::statements::Statements;
use crate::unit::CompileUnit;
use crate::variables::Declarations;

/// Compiles the program in a file, which has this number among the image's files.
pub(crate) fn compile(
    unit: &mut CompileUnit<'_>,
    file: File,
    number: u32,
) -> std::result::Result<Program, CompileError> {
    let (db, project) = (unit.db, unit.project);
    let (header, body, types) = (header(db, file), body(db, file), infer(db, project, file));
    let form = unit.form;
    let counting = match form {
        CodeForm::Counted => Counting::except(uncovered(db, file)),
        CodeForm::Plain | CodeForm::Debugged => Counting::default(),
    };
    let layout = unit.layout.filter(|layout| layout.file == file);
    let mut emitter = Emitter::new(unit, file.text(db), counting);
    if let Some(LayoutRequest { replaced, .. }) = layout {
        let nums = replaced.map(|line| line.program.nums.clone()).unwrap_or_default();
        emitter.frame_mut().keep_layout(LayoutKeeper::new(replaced), nums);
    }
    let closings = Closings::of(db, file, form);
    let mut statements = Statements::new(Expressions::new(emitter, body, types), header, closings);
    let signature = signature(db, project, file);
    let program = Declarations { out: statements.out(), header, body, types }
        .declare(&signature.params)
        .and_then(|(params, variables)| whole(&mut statements, body, params, variables, signature, number));
    program.map_err(|limit| CompileError::at(file.path(db).as_str(), statements.row(), limit))
}

fn whole(
    statements: &mut Statements<'_, '_>,
    body: &Body,
    params: Vec<ProgramParam>,
    variables: Vec<FrameVariable>,
    signature: &Signature,
    file: u32,
) -> Result<Program> {
    let stack_bytes = statements.out().frame().bytes();
    statements.block(&body.block)?;
    statements.end();
    let (code, tables, frame) = statements.out().finish()?;
    let CodeBuilder { lines, closings, texts, copies, instructions, calls, tasks, counters, .. } = tables;
    let Finished { size, nums, parts, layout } = frame;
    if layout.is_some() {
        statements.out().unit_mut().recorded_layout = layout;
    }
    Ok(Program {
        name: signature.name.to_string(),
        public: signature.public,
        file,
        params,
        variables,
        frame: size,
        stack_bytes,
        nums,
        parts,
        code,
        lines,
        closings,
        texts,
        copies,
        instructions,
        calls,
        tasks,
        counters,
    })
}
