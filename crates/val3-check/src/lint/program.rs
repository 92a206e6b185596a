//! View of a program for lints.

use std::cell::OnceCell;

use val3_analysis::application::{Application, application};
use val3_analysis::body::{Body, Expr, ExprId, Stmt, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::effects::Effects;
use val3_analysis::flow::{FlowGraph, PerPoint, flow};
use val3_analysis::guards::{Guards, guards};
use val3_analysis::infer::{Inference, InstructionCall, infer};
use val3_analysis::items::declarations;
use val3_analysis::items::program::{Header, header};
use val3_analysis::items::project::{Items, items, resolve_type};
use val3_analysis::ty::Base;
use val3_config::Options;
use val3_lang::types::BaseType;
use val3_syntax::{TextRange, text_at};

use super::motion::ArmCall;
use super::planned_moves::PlannedMoves;
use super::variable_use::VariableUse;
use super::{Call, LocalUse, MotionFacts};

/// A program without faults, and its analysis results.
pub(crate) struct ProgramView<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) project: Project,
    pub(crate) file: File,
    pub(crate) header: &'db Header,
    pub(crate) items: &'db Items,
    pub(crate) body: &'db Body,
    pub(crate) inference: &'db Inference,
    /// Configured options of rules.
    pub(crate) options: &'db Options,
    /// Effects of program lines on variables.
    pub(crate) effects: Effects<'db>,
    /// State of the arm, computed on demand.
    pub(super) motion: OnceCell<Option<MotionFacts>>,
    pub(super) arm_calls: OnceCell<Vec<ArmCall<'db>>>,
    pub(super) planned_moves: OnceCell<PlannedMoves>,
    calls: OnceCell<Vec<Call<'db>>>,
    pub(super) calls_by_point: OnceCell<PerPoint<Call<'db>>>,
    local_use: OnceCell<LocalUse<'db>>,
    variable_use: OnceCell<VariableUse>,
    stmts: OnceCell<Vec<&'db Stmt>>,
}

impl<'db> ProgramView<'db> {
    pub(crate) fn new(db: &'db dyn Db, project: Project, file: File, options: &'db Options) -> Self {
        Self {
            db,
            project,
            file,
            header: header(db, file),
            items: items(db, project),
            body: body(db, file),
            inference: infer(db, project, file),
            options,
            effects: Effects::new(db, project, file),
            motion: OnceCell::new(),
            arm_calls: OnceCell::new(),
            planned_moves: OnceCell::new(),
            calls: OnceCell::new(),
            calls_by_point: OnceCell::new(),
            local_use: OnceCell::new(),
            variable_use: OnceCell::new(),
            stmts: OnceCell::new(),
        }
    }

    /// Name of the program.
    pub(crate) fn name(&self) -> &'db str {
        &self.header.name
    }

    /// Control-flow graph.
    pub(crate) fn flow(&self) -> &'db FlowGraph {
        flow(self.db, self.file)
    }

    /// Conditions under which expressions are evaluated.
    pub(crate) fn guards(&self) -> &'db Guards {
        guards(self.db, self.file)
    }

    /// Accesses to local variables at each flow node.
    pub(crate) fn local_use(&self) -> &LocalUse<'db> {
        self.local_use.get_or_init(|| LocalUse::new(self.header, self.flow(), &self.effects, self.calls()))
    }

    /// Summary of the accesses to locals and parameters.
    pub(crate) fn variable_use(&self) -> &VariableUse {
        self.variable_use.get_or_init(|| VariableUse::new(&self.effects))
    }

    /// Whether the local or parameter is an input, an output or a line, for which a write is a use.
    pub(crate) fn is_linkable(&self, name: &str) -> bool {
        let locals = self.header.locals.iter().map(|local| (&local.name, &local.type_name));
        let mut variables = locals.chain(self.header.params.iter().map(|param| (&param.name, &param.type_name)));
        let ty = variables.find(|(known, _)| *known == name).map(|(_, ty)| ty);
        let base = ty.and_then(|ty| resolve_type(&self.items.types, ty));
        base.and_then(Base::builtin).is_some_and(BaseType::is_linkable)
    }

    /// All statements, outer statements before inner statements.
    pub(crate) fn stmts(&self) -> &[&'db Stmt] {
        self.stmts.get_or_init(|| self.body.stmts())
    }

    /// Summary of the application.
    pub(crate) fn application(&self) -> &'db Application {
        application(self.db, self.project)
    }

    /// All instruction calls, inner calls before outer calls.
    pub(crate) fn calls(&self) -> &[Call<'db>] {
        self.calls.get_or_init(|| self.inference.calls().iter().filter_map(|call| self.call(call)).collect())
    }

    /// All calls of the instruction `name`.
    pub(crate) fn calls_of(&self, name: &str) -> impl Iterator<Item = &Call<'db>> {
        self.calls().iter().filter(move |call| call.instruction.name == name)
    }

    /// The instruction call at `id`; `None` if `id` is no instruction call.
    pub(crate) fn call_of(&self, id: ExprId) -> Option<&Call<'db>> {
        let at = self.calls().binary_search_by_key(&id, |call| call.id).ok()?;
        self.calls().get(at)
    }

    fn call(&self, call: &InstructionCall) -> Option<Call<'db>> {
        let Expr::Call(callee, args) = self.body.expr(call.id) else { return None };
        let InstructionCall { id, instruction, form } = *call;
        Some(Call { id, instruction, form, callee: *callee, args, role: instruction.role })
    }

    /// Location of the program's name.
    pub(crate) fn head(&self) -> TextRange {
        declarations::program(self.db, self.file).map_or_else(TextRange::default, |place| place.range)
    }

    /// Expression location.
    pub(crate) fn range(&self, id: ExprId) -> TextRange {
        self.body.range(id)
    }

    /// Expression text, encoded like the file.
    pub(crate) fn text(&self, id: ExprId) -> &'db str {
        self.slice(self.range(id))
    }

    /// A part of the file's text.
    pub(crate) fn slice(&self, range: TextRange) -> &'db str {
        text_at(self.file.text(self.db), range)
    }
}
