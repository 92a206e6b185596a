//! Data flow through local variables.

use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::body::ExprId;
use val3_analysis::effects::{Access, AccessKind, Effects, RootVariable};
use val3_analysis::flow::{Facts, FlowGraph, FlowNodeId, PerPoint, backward, forward};
use val3_analysis::items::program::Header;
use val3_lang::instruction::ArgumentForm;

use super::Call;

/// A set of local variables, one bit each. Variables after the 128th are not tracked: they count as written and read.
pub(crate) type Locals = u128;

/// Accesses to local variables at each flow node.
pub(crate) struct LocalUse<'db>(PerPoint<(Locals, &'db Access)>);

impl<'db> LocalUse<'db> {
    pub(super) fn new(header: &Header, flow: &FlowGraph, effects: &Effects<'db>, calls: &[Call<'db>]) -> Self {
        let names = header.locals.iter().map(|local| local.name.as_str());
        let bits: FxHashMap<&str, Locals> = names.zip((0u32..128).map(|bit| 1 << bit)).collect();
        if bits.is_empty() {
            return Self(PerPoint::EMPTY);
        }
        let mut uses = PerPoint::with_capacity(flow.len(), effects.all().len());
        let measured = measured(calls);
        for (id, _) in flow.points() {
            let accesses = effects.at(id).iter().filter(|access| !measured.contains(&access.id));
            uses.push(accesses.filter_map(|access| {
                let RootVariable::Local(name) = &access.root else { return None };
                Some((*bits.get(name.as_str())?, access))
            }));
        }
        Self(uses)
    }

    /// Accesses at a flow node, in evaluation order.
    pub(crate) fn at(&self, point: FlowNodeId) -> &[(Locals, &'db Access)] {
        self.0.at(point)
    }

    /// Variables that may have been written before each flow node.
    pub(crate) fn written(&self, flow: &FlowGraph) -> Facts<Locals> {
        forward(flow, 0, |id, _, before| self.written_at(id, *before), join)
    }

    /// Variables that may have been written after a flow node.
    fn written_at(&self, id: FlowNodeId, before: Locals) -> Locals {
        let written = self.at(id).iter().filter(|(_, access)| access.kind != AccessKind::Read);
        written.fold(before, |all, (bit, _)| all | bit)
    }

    /// Variables whose value may still be used after each flow node.
    pub(crate) fn needed(&self, flow: &FlowGraph) -> Facts<Locals> {
        backward(flow, 0, |id, _, behind| self.needed_at(id, *behind), join)
    }

    /// Variables whose value may still be used before a flow node.
    fn needed_at(&self, id: FlowNodeId, behind: Locals) -> Locals {
        self.at(id).iter().rev().fold(behind, |needed, (bit, access)| match access.kind {
            AccessKind::Write => needed & !bit,
            AccessKind::WritePart => needed,
            AccessKind::Read | AccessKind::Reference => needed | bit,
        })
    }
}

fn join(known: &mut Locals, more: &Locals) -> bool {
    let before = *known;
    *known |= more;
    *known != before
}

/// Variables whose size or existence is read, but not their value.
fn measured(calls: &[Call<'_>]) -> FxHashSet<ExprId> {
    let arguments = calls.iter().flat_map(|call| {
        let params = call.form.into_iter().flat_map(|form| form.params);
        params.zip(call.args).filter(|(param, _)| reads_no_value(param.shape)).map(|(_, arg)| *arg)
    });
    arguments.collect()
}

/// Whether an instruction reads only the size or existence of such an argument.
fn reads_no_value(shape: ArgumentForm) -> bool {
    matches!(shape, ArgumentForm::Whole | ArgumentForm::Slot | ArgumentForm::Item | ArgumentForm::Collection)
}
