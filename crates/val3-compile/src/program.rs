//! One program.

use val3_analysis::body::body;
use val3_analysis::db::File;
use val3_analysis::infer::infer;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{Signature, signature};
use val3_bytecode::{Op, Program};
use val3_syntax::TextRange;

use crate::code::Code;
use crate::emitter::Emitter;
use crate::error::{CompileError, Result};
use crate::expressions::Expressions;
use crate::frame::{Finished, Frame};
use crate::statements::Statements;
use crate::unit::Unit;
use crate::variables::Declarations;

/// Compiles the program in a file, which has this number among the files of the image.
pub(crate) fn compile(unit: &mut Unit<'_>, file: File, number: u32) -> std::result::Result<Program, CompileError> {
    let (db, project) = (unit.db, unit.project);
    let out = Emitter { unit, frame: Frame::default(), code: Code::new(file.text(db)) };
    let values = Expressions { out, body: body(db, file), types: infer(db, project, file), is_pure: false };
    let mut statements = Statements { values, header: header(db, file), range: TextRange::default() };
    let program = whole(&mut statements, signature(db, project, file), number);
    let row = statements.values.out.code.row(statements.range);
    program.map_err(|limit| CompileError { file: file.path(db).to_string(), row, limit })
}

fn whole(statements: &mut Statements<'_, '_>, signature: &Signature, file: u32) -> Result<Program> {
    let Statements { values: Expressions { out, body, types, .. }, header, .. } = statements;
    let (params, variables) = Declarations { out, header, body, types }.declare(&signature.params)?;
    let stack_bytes = statements.values.out.frame.bytes();
    statements.block(&statements.values.body.block)?;
    let out = &mut statements.values.out;
    out.code.begin();
    out.emit(Op::Return);
    let code = out.code.finish()?;
    let Code { lines, texts, copies, instructions, calls, tasks, .. } = std::mem::take(&mut out.code);
    let Finished { size, nums, parts } = std::mem::take(&mut out.frame).finish();
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
        texts,
        copies,
        instructions,
        calls,
        tasks,
    })
}
