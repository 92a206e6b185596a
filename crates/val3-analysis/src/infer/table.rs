//! Inference results: expression types and forms of instruction calls.

use smol_str::SmolStr;
use val3_lang::add_on::AddOnOverload;
use val3_lang::instruction::{Instruction, Overload};

use crate::body::ExprId;
use crate::ty::Ty;

/// A call to an instruction in the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionCall {
    /// Call expression, an [`Expr::Call`](crate::body::Expr::Call).
    pub id: ExprId,
    /// Called instruction.
    pub instruction: &'static Instruction,
    /// Form that matches the arguments; `None` if no form or several forms may match.
    pub form: Option<&'static Overload>,
}

/// A call to an instruction that an add-on's table declares.
#[derive(Debug, Clone, PartialEq)]
pub struct AddOnCall {
    /// Call expression, an [`Expr::Call`](crate::body::Expr::Call).
    pub id: ExprId,
    /// Name with its `$`.
    pub name: SmolStr,
    /// Form that matches the arguments.
    pub form: AddOnOverload,
}

/// Types by expression number; calls sorted by expression number after [`TypeTable::finish`].
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct TypeTable {
    types: Vec<Ty>,
    calls: Vec<InstructionCall>,
    add_on_calls: Vec<AddOnCall>,
}

impl TypeTable {
    /// Creates a table for a body of `len` expressions with unknown types.
    pub(super) fn new(len: usize) -> Self {
        Self { types: vec![Ty::UNKNOWN; len], ..Self::default() }
    }

    pub(super) fn set_type(&mut self, id: ExprId, ty: Ty) {
        if let Some(slot) = self.types.get_mut(id.index()) {
            *slot = ty;
        }
    }

    pub(super) fn add_call(&mut self, call: InstructionCall) {
        self.calls.push(call);
    }

    pub(super) fn add_add_on_call(&mut self, call: AddOnCall) {
        self.add_on_calls.push(call);
    }

    /// Removes the call `id` if it was added last and no form matched. Returns whether it was removed.
    pub(super) fn retract_without_form(&mut self, id: ExprId) -> bool {
        self.calls.pop_if(|call| call.id == id && call.form.is_none()).is_some()
    }

    /// Sorts the calls by number for binary search; inner calls come before outer ones.
    pub(super) fn finish(mut self) -> Self {
        self.calls.sort_unstable_by_key(|call| call.id);
        self.add_on_calls.sort_unstable_by_key(|call| call.id);
        self
    }

    pub(super) fn ty(&self, id: ExprId) -> Ty {
        self.types.get(id.index()).copied().unwrap_or(Ty::UNKNOWN)
    }

    pub(super) fn call(&self, id: ExprId) -> Option<&InstructionCall> {
        let at = self.calls.binary_search_by_key(&id, |call| call.id).ok()?;
        self.calls.get(at)
    }

    pub(super) fn add_on_call(&self, id: ExprId) -> Option<&AddOnCall> {
        let at = self.add_on_calls.binary_search_by_key(&id, |call| call.id).ok()?;
        self.add_on_calls.get(at)
    }

    pub(super) fn calls(&self) -> &[InstructionCall] {
        &self.calls
    }
}
