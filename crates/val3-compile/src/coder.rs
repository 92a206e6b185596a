//! The compiler of one program.

use std::sync::Arc;

use val3_analysis::body::{Body, ExprId};
use val3_analysis::infer::Inference;
use val3_analysis::items::program::Header;
use val3_analysis::ty::Base;
use val3_bytecode::{Op, Register};
use val3_lang::memory::{Kind, Lanes};
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::code::Code;
use crate::error::{Limit, Result};
use crate::frame::Frame;
use crate::unit::Unit;

/// The state of the compilation of a program. Its methods are spread over the modules of the crate, one idea each.
pub(crate) struct Coder<'u, 'db> {
    /// The state that all programs of the project share.
    pub(crate) unit: &'u mut Unit<'db>,
    pub(crate) header: &'db Header,
    pub(crate) body: &'db Body,
    pub(crate) types: &'db Inference,
    pub(crate) frame: Frame,
    pub(crate) code: Code,
    /// The current statement.
    pub(crate) range: TextRange,
    /// Whether the current part of a statement neither changes variables before its end nor waits.
    pub(crate) is_pure: bool,
}

impl Coder<'_, '_> {
    /// The type of an expression.
    pub(crate) fn base(&self, id: ExprId) -> Base {
        self.types.ty(id).base
    }

    /// The type of an expression, which is a built-in one.
    pub(crate) fn builtin(&self, id: ExprId) -> Result<BaseType> {
        self.base(id).builtin().ok_or(Limit::Unclear)
    }

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
