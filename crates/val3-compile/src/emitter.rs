//! What the compiler of a program writes to: its frame, its code and the tables of the project.

use std::sync::Arc;

use val3_analysis::ty::Base;
use val3_bytecode::{Op, Register};
use val3_lang::memory::{Kind, Lanes};
use val3_lang::types::BaseType;

use crate::code::Code;
use crate::error::Result;
use crate::frame::Frame;
use crate::unit::Unit;

/// Writes operations that move values. It knows no expressions.
pub(crate) struct Emitter<'u, 'db> {
    /// The state that all programs of the project share.
    pub(crate) unit: &'u mut Unit<'db>,
    pub(crate) frame: Frame,
    pub(crate) code: Code,
}

impl Emitter<'_, '_> {
    /// A type at run time.
    pub(crate) fn kind(&mut self, base: Base) -> Result<Arc<Kind>> {
        self.unit.kinds.kind(base)
    }

    /// A built-in type at run time, of the project's arm.
    pub(crate) fn builtin_kind(&mut self, base: BaseType) -> Result<Arc<Kind>> {
        self.kind(Base::of(base))
    }

    /// Lanes for a result of a built-in type: those that are wanted, else new ones.
    pub(crate) fn result(&mut self, base: BaseType, want: Option<Lanes>) -> Result<Lanes> {
        match want {
            Some(lanes) => Ok(lanes),
            None => {
                let kind = self.builtin_kind(base)?;
                self.frame.value(kind.size)
            }
        }
    }

    /// A register for a number: the one that is wanted, else a new one.
    pub(crate) fn num_result(&mut self, want: Option<Lanes>) -> Result<Register> {
        match want {
            Some(lanes) => Ok(crate::frame::narrow(lanes.num)),
            None => self.frame.num(),
        }
    }

    /// A register for a text: the one that is wanted, else a new one.
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
