//! One program.

use val3_analysis::body::body;
use val3_analysis::db::File;
use val3_analysis::infer::infer;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{Signature, signature};
use val3_bytecode::{Op, Program};
use val3_syntax::TextRange;

use crate::code::Code;
use crate::coder::Coder;
use crate::error::{CompileError, Result};
use crate::frame::{Finished, Frame};
use crate::unit::Unit;

/// Compiles the program in a file, which has this number among the files of the image.
pub(crate) fn compile(unit: &mut Unit<'_>, file: File, number: u32) -> std::result::Result<Program, CompileError> {
    let (db, project) = (unit.db, unit.project);
    let mut coder = Coder {
        unit,
        header: header(db, file),
        body: body(db, file),
        types: infer(db, project, file),
        frame: Frame::default(),
        code: Code::new(file.text(db)),
        range: TextRange::default(),
        is_pure: false,
    };
    let compiled = coder.program(signature(db, project, file));
    let row = coder.code.row(coder.range);
    let place = |limit| CompileError { file: file.path(db).to_string(), row, limit };
    let program = compiled.map_err(place)?;
    Ok(Program { file: number, ..program })
}

impl Coder<'_, '_> {
    fn program(&mut self, signature: &Signature) -> Result<Program> {
        let params = self.params(&signature.params)?;
        self.locals()?;
        let variables = self.variables(&params)?;
        let stack_bytes = self.frame.bytes();
        self.block(&self.body.block)?;
        self.code.begin();
        self.emit(Op::Return);
        let code = self.code.finish()?;
        let Code { lines, texts, copies, instructions, calls, tasks, .. } = std::mem::take(&mut self.code);
        let Finished { size, nums, parts } = std::mem::take(&mut self.frame).finish();
        Ok(Program {
            name: signature.name.to_string(),
            public: signature.public,
            file: 0,
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
}
