//! Inlay hints: text that an editor displays within the code, but that is not in the file.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::effects::{AccessKind, Effects, RootVariable};
use val3_analysis::infer::{Inference, infer};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::data_path::DataPath;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::motion::{MotionRole, descriptor, target};
use val3_lang::types::{BaseType, fields};
use val3_lang::{instructions, keywords};
use val3_syntax::{TextRange, TextSize};

use crate::FilePosition;
use crate::navigate::declaration;
use crate::owner::owner;
use crate::placement::{FatherAndBlend, placement};

/// Enabled hints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct InlayHintSettings {
    /// Parameter names before literal arguments, and field names before the values of `{…}`.
    pub parameter_names: bool,
    /// Types before `{…}`.
    pub literal_types: bool,
    /// Frames after the targets of moves.
    pub point_frames: bool,
    /// Blends after the motion descriptors of moves.
    pub blends: bool,
}

impl Default for InlayHintSettings {
    fn default() -> Self {
        Self { parameter_names: true, literal_types: true, point_frames: true, blends: true }
    }
}

/// An inlay hint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InlayHint {
    /// Start of the described word (parameter name, type), or its end (frame, blend).
    pub offset: TextSize,
    /// Displayed text.
    pub label: String,
    /// Kind.
    pub kind: InlayHintKind,
    /// Tooltip; may be empty.
    pub tooltip: String,
    /// Symbol of the application that it names.
    pub symbol: Option<Symbol>,
}

/// Kinds of inlay hints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum InlayHintKind {
    /// A parameter name: `nSeconds:`.
    Parameter,
    /// The type of a `{…}`: `trsf`.
    Type,
    /// The frame of a point: `in fTable[0]`.
    Frame,
    /// The blend of a move: `joint, leave 50, reach 50`.
    Blend,
}

impl InlayHintKind {
    /// Whether the hint precedes the word that it describes.
    pub fn is_before(self) -> bool {
        matches!(self, Self::Parameter | Self::Type)
    }
}

/// Inlay hints within a range, in the order of the text.
pub fn inlay_hints(db: &dyn Db, file: File, within: TextRange, settings: &InlayHintSettings) -> Vec<InlayHint> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    let (body, inference) = (body(db, file), infer(db, project, file));
    let effects = Effects::new(db, project, file);
    let mut hints = Hints { db, project, body, inference, effects, settings, written: None, found: Vec::new() };
    for (id, expr, range) in body.exprs().filter(|(_, _, range)| within.intersect(*range).is_some()) {
        match expr {
            Expr::Call(callee, arguments) => hints.call(id, *callee, arguments),
            Expr::Struct(values) => {
                hints.fields(id, values);
                hints.literal(id, range, values);
            }
            _ => {}
        }
    }
    for stmt in body.stmts().into_iter().filter(|stmt| within.intersect(stmt.range).is_some()) {
        if let StmtKind::TaskCreate { synchronous, arguments } = &stmt.kind {
            hints.task_creation(*synchronous, arguments);
        }
    }
    let mut found = hints.found;
    found.retain(|hint| within.contains_inclusive(hint.offset));
    found.sort_by_key(|hint| (hint.offset, hint.kind));
    found
}

/// Declaration of the item that the hint with this label names.
pub fn inlay_hint_target(
    db: &dyn Db,
    at: FilePosition,
    label: &str,
    settings: &InlayHintSettings,
) -> Option<FileRange> {
    let hints = inlay_hints(db, at.file, TextRange::empty(at.offset), settings);
    let hint = hints.into_iter().find(|hint| hint.offset == at.offset && hint.label == label)?;
    declaration(db, &hint.symbol?)
}

struct Hints<'db> {
    db: &'db dyn Db,
    project: Project,
    body: &'db Body,
    inference: &'db Inference,
    effects: Effects<'db>,
    settings: &'db InlayHintSettings,
    /// Variables that the program changes, so that their initial values may be stale. Computed on demand.
    written: Option<FxHashSet<RootVariable>>,
    found: Vec<InlayHint>,
}

impl<'db> Hints<'db> {
    fn call(&mut self, id: ExprId, callee: ExprId, arguments: &[ExprId]) {
        if let Some(call) = self.inference.call(id) {
            if let Some(form) = call.form {
                self.instruction(call.instruction, form, arguments);
            }
        } else if let (Some(signature), Some((_, file))) =
            (self.effects.program(callee), self.effects.program_file(callee))
        {
            for (param, argument) in signature.params.iter().zip(arguments) {
                self.parameter(&param.name, *argument, Some(Symbol::Param(file, param.name.clone())));
            }
        }
    }

    fn instruction(&mut self, instruction: &'static Instruction, form: &'static Overload, arguments: &[ExprId]) {
        // The instruction name already describes its only argument.
        if form.params.len() > 1 {
            for (param, argument) in form.params.iter().zip(arguments) {
                self.parameter(param.name, *argument, None);
            }
        }
        if matches!(instruction.role, Some(MotionRole::Move(_))) {
            if let Some(target) = target(form).and_then(|at| arguments.get(at)).filter(|_| self.settings.point_frames) {
                self.frame(*target);
            }
            if let Some(mdesc) = descriptor(form).and_then(|at| arguments.get(at)).filter(|_| self.settings.blends) {
                self.blend(*mdesc);
            }
        }
    }

    fn task_creation(&mut self, synchronous: bool, arguments: &[ExprId]) {
        let mut names = keywords::KEYWORDS.into_iter().filter(|keyword| keywords::is_task_creation(keyword));
        let form = names.nth(usize::from(synchronous)).and_then(instructions::find);
        let Some(form) = form.and_then(|instruction| instruction.overloads.first()) else { return };
        for (param, argument) in form.params.iter().zip(arguments) {
            self.parameter(param.name, *argument, None);
        }
    }

    fn parameter(&mut self, name: &str, argument: ExprId, symbol: Option<Symbol>) {
        if self.settings.parameter_names && is_literal(self.body, argument) {
            let offset = self.body.range(argument).start();
            let (label, kind) = (format!("{name}:"), InlayHintKind::Parameter);
            self.found.push(InlayHint { offset, label, kind, tooltip: String::new(), symbol });
        }
    }

    /// Field names of the values in a literal.
    fn fields(&mut self, id: ExprId, values: &[Option<ExprId>]) {
        let Base::Builtin(ty, arm) = self.inference.ty(id).base else { return };
        let arm = arm.or(items(self.db, self.project).arm);
        for (field, value) in fields(ty, arm).iter().zip(values) {
            if let Some(value) = value {
                self.parameter(field.name, *value, None);
            }
        }
    }

    /// Of nested literals, only the outer one has hints, because they also describe the inner ones.
    fn literal(&mut self, id: ExprId, range: TextRange, values: &[Option<ExprId>]) {
        if !self.settings.literal_types {
            return;
        }
        let base = self.inference.ty(id).base;
        let name = base.builtin().map_or_else(|| base.display(self.db), |ty| ty.name().into());
        if base != Base::Unknown {
            self.found.retain(|hint| {
                let mut starts = values.iter().flatten().map(|value| self.body.range(*value).start());
                hint.kind != InlayHintKind::Type || !starts.any(|start| start == hint.offset)
            });
            let (offset, label, kind) = (range.start(), name.to_string(), InlayHintKind::Type);
            self.found.push(InlayHint { offset, label, kind, tooltip: String::new(), symbol: None });
        }
    }

    fn frame(&mut self, target: ExprId) {
        if self.inference.ty(target).base.builtin() != Some(BaseType::Point) {
            return;
        }
        if let Some((project, _, FatherAndBlend { father: Some(father), .. })) = self.placement(target) {
            let tooltip = "the father frame according to the data file".to_owned();
            let first = DataPath::new(father).steps().next();
            let symbol = first.map(|step| Symbol::Data(project, step.name.into()));
            let (offset, label) = (self.body.range(target).end(), format!("in {father}"));
            self.found.push(InlayHint { offset, label, kind: InlayHintKind::Frame, tooltip, symbol });
        }
    }

    fn blend(&mut self, mdesc: ExprId) {
        if let Some((project, name, FatherAndBlend { blend: Some(blend), .. })) = self.placement(mdesc) {
            let tooltip = "the blend of the motion descriptor according to the data file".to_owned();
            let symbol = Some(Symbol::Data(project, name));
            let (offset, label) = (self.body.range(mdesc).end(), blend.to_string());
            self.found.push(InlayHint { offset, label, kind: InlayHintKind::Blend, tooltip, symbol });
        }
    }

    /// Placement from the initial value of a variable or element, with the project and name of the data. `None` if this
    /// program changes the value.
    fn placement(&mut self, id: ExprId) -> Option<(Project, SmolStr, &'db FatherAndBlend)> {
        let key = key(self.body, id)?;
        let root = self.effects.root(id)?;
        if self.is_written(&root) {
            return None;
        }
        let (project, name) = match root {
            RootVariable::Data(name) => (self.project, name),
            RootVariable::Item(library, name) => {
                (items(self.db, self.project).libraries.get(&library)?.interface?, name)
            }
            RootVariable::Local(_) | RootVariable::Param(_) => return None,
        };
        let found = placement(self.db, project, &name, &key)?;
        Some((project, name, found))
    }

    fn is_written(&mut self, root: &RootVariable) -> bool {
        let effects = &self.effects;
        let written = self.written.get_or_insert_with(|| {
            let changes = effects.all().iter().filter(|access| access.kind != AccessKind::Read);
            changes.map(|access| access.root.clone()).collect()
        });
        written.contains(root)
    }
}

/// Whether the expression is a number, a string, a Boolean value or `{…}`, with or without a sign or parentheses.
fn is_literal(body: &Body, id: ExprId) -> bool {
    match body.expr(id) {
        Expr::Number(_) | Expr::String(_) | Expr::Bool(_) | Expr::Struct(_) => true,
        Expr::Unary(_, inner) | Expr::Paren(inner) => is_literal(body, *inner),
        _ => false,
    }
}

/// Key; `None` unless the variable has a single value or the index is constant.
fn key(body: &Body, id: ExprId) -> Option<SmolStr> {
    match body.expr(body.without_parentheses(id)) {
        Expr::Name(_) | Expr::Path { .. } => Some("0".into()),
        Expr::Index(_, indexes) => {
            let indexes: Option<Vec<String>> = indexes.iter().map(|index| index_text(body, *index)).collect();
            indexes.map(|indexes| indexes.join(",").into())
        }
        _ => None,
    }
}

fn index_text(body: &Body, index: ExprId) -> Option<String> {
    body.number(index).map(|number| number.to_string()).or_else(|| body.string(index).map(|text| text.to_string()))
}

#[cfg(test)]
mod tests;
