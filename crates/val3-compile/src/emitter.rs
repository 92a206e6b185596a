//! Output of the program compiler: frame, code and the project's tables.

mod lookups;
mod moves;

use std::borrow::Cow;
use std::sync::Arc;

use val3_analysis::ty::Base;
use val3_bytecode::{Op, Opcode, Register};
use val3_lang::memory::{Lanes, ValueType};
use val3_lang::types::BaseType;
use val3_syntax::{TextRange, TextSlice, decode_entities};

use crate::code::CodeBuilder;
use crate::counting::Counting;
use crate::error::Result;
use crate::frame::{Finished, Frame};
use crate::unit::CompileUnit;

pub(crate) use moves::text_register;

/// Emits operations that move values. It is independent of expressions.
pub(crate) struct Emitter<'u, 'db> {
    /// State that all programs of the project share.
    unit: &'u mut CompileUnit<'db>,
    /// Source of the file.
    text: &'db str,
    frame: Frame,
    code: CodeBuilder,
}

impl<'u, 'db> Emitter<'u, 'db> {
    /// Creates an emitter for a program in a file with this source.
    pub(crate) fn new(unit: &'u mut CompileUnit<'db>, text: &'db str, counting: Counting) -> Self {
        Self { unit, text, frame: Frame::default(), code: CodeBuilder::new(text, counting) }
    }

    /// Returns the source in a range of the file, with decoded entities.
    pub(crate) fn source(&self, range: TextRange) -> Cow<'db, str> {
        decode_entities(self.text.part(range.start().into()..range.end().into()))
    }

    pub(crate) fn unit(&self) -> &CompileUnit<'db> {
        self.unit
    }

    pub(crate) fn unit_mut(&mut self) -> &mut CompileUnit<'db> {
        self.unit
    }

    pub(crate) fn frame(&self) -> &Frame {
        &self.frame
    }

    pub(crate) fn frame_mut(&mut self) -> &mut Frame {
        &mut self.frame
    }

    pub(crate) fn code(&mut self) -> &mut CodeBuilder {
        &mut self.code
    }

    /// Ends the program, and returns the operations, tables and frame.
    pub(crate) fn finish(&mut self) -> Result<(Vec<Opcode>, CodeBuilder, Finished)> {
        self.code.begin();
        self.emit(Op::Return);
        let operations = self.code.finish()?;
        Ok((operations, std::mem::take(&mut self.code), std::mem::take(&mut self.frame).finish()))
    }

    /// Returns a type's run-time form.
    pub(crate) fn kind(&mut self, base: Base) -> Result<Arc<ValueType>> {
        self.unit.kinds.kind(base)
    }

    /// Returns a built-in type's run-time form, for the project's arm.
    pub(crate) fn builtin_kind(&mut self, base: BaseType) -> Result<Arc<ValueType>> {
        self.kind(Base::of(base))
    }

    /// Returns lanes for a result of a built-in type: the wanted lanes, or new ones.
    pub(crate) fn result(&mut self, base: BaseType, want: Option<Lanes>) -> Result<Lanes> {
        match want {
            Some(lanes) => Ok(lanes),
            None => {
                let kind = self.builtin_kind(base)?;
                self.frame.value(kind.size)
            }
        }
    }

    /// Returns a register for a number: the wanted one, or a new one.
    pub(crate) fn num_result(&mut self, want: Option<Lanes>) -> Result<Register> {
        match want {
            Some(lanes) => Ok(crate::frame::narrow(lanes.num)),
            None => self.frame.num(),
        }
    }

    /// Returns a register for a string: the wanted one, or a new one.
    pub(crate) fn text_result(&mut self, want: Option<Lanes>) -> Result<Register> {
        match want {
            Some(lanes) => Ok(crate::frame::narrow(lanes.text)),
            None => self.frame.text(),
        }
    }

    pub(crate) fn emit(&mut self, op: Op) {
        self.code.emit(op);
    }
}
