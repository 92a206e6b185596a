//! Checks of user pages: unresolved names in their bindings.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_lang::data_path::DataPath;
use val3_lang::instructions::{self, shows_named_page};
use val3_lang::suggest::nearest;
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use super::{Bindings, BoundData, BoundName, binding_files, bindings, names, page_ids, page_of};
use crate::body::{Body, Expr, ExprId, body};
use crate::data_check::{ReferencePart, steps};
use crate::db::{Db, File, FileRange, FileStatus, Project};
use crate::items::project::{DataItem, Items, fields, items, program_files, signature};
use crate::problem::{PageFault, Problem, ProblemKind};
use crate::resizing::is_resized;
use crate::ty::Base;

/// Returns the problems of the user pages of a project.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project) -> Vec<Problem> {
    let mut problems = Vec::new();
    for file in binding_files(db, project) {
        PageCheck { db, project, items: items(db, project), file, problems: &mut problems }.check();
    }
    let names = names(db, project);
    if !names.is_empty() {
        problems.extend(program_files(db, project).iter().flat_map(|file| unknown_pages(db, *file, &names)));
    }
    problems
}

/// Returns problems for page names in a program that no page has.
fn unknown_pages(db: &dyn Db, file: File, names: &[SmolStr]) -> Vec<Problem> {
    let body = body(db, file);
    let shown = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Call(callee, arguments) if shows_page(body, *callee) => arguments.first().copied(),
        _ => None,
    });
    let unknown = shown.filter_map(|argument| {
        let Expr::String(name) = body.expr(argument) else { return None };
        if names.iter().any(|known| known.eq_ignore_ascii_case(name)) {
            return None;
        }
        let near = nearest(name, names.iter().map(SmolStr::as_str)).map(SmolStr::from);
        let kind = ProblemKind::Page(PageFault::UnknownPage { name: name.clone(), near });
        Some(Problem { kind, place: FileRange { file, range: body.range(argument) }, related: Vec::new() })
    });
    unknown.collect()
}

/// Whether the callee is an instruction whose first argument is the name of a page.
fn shows_page(body: &Body, callee: ExprId) -> bool {
    let Expr::Name(name) = body.expr(callee) else { return false };
    let Some(instruction) = instructions::find(name) else { return false };
    instruction.overloads.iter().any(|form| shows_named_page(instruction, form))
}

struct PageCheck<'a> {
    db: &'a dyn Db,
    project: Project,
    items: &'a Items,
    file: File,
    problems: &'a mut Vec<Problem>,
}

impl PageCheck<'_> {
    fn check(&mut self) {
        let found = bindings(self.db, self.file);
        if !is_read(self.db, self.file) {
            return;
        }
        if let Some(fault) = &found.fault {
            self.report(self.file, fault.range, PageFault::NoJson { expected: fault.expected });
        }
        found.data.iter().for_each(|bound| self.data(bound));
        found.callbacks.iter().filter_map(|callback| callback.program.as_ref()).for_each(|bound| self.program(bound));
        self.elements(found);
    }

    fn report(&mut self, file: File, range: TextRange, fault: PageFault) {
        let place = FileRange { file, range };
        self.problems.push(Problem { kind: ProblemKind::Page(fault), place, related: Vec::new() });
    }

    /// Checks the data path of a binding. Library items are not checked, because the page may be used with another
    /// library of the interface.
    fn data(&mut self, bound: &BoundData) {
        let Some(path) = bound.path.as_ref().filter(|path| DataPath::new(&path.text).library().is_none()) else {
            return;
        };
        if let Some(fault) = self.path_fault(&path.text, bound.attribute.as_ref()) {
            self.report(self.file, path.range, fault);
        }
    }

    fn path_fault(&self, path: &str, attribute: Option<&SmolStr>) -> Option<PageFault> {
        let steps = steps(path)?;
        let mut steps = steps.iter();
        let mut step = steps.next()?;
        let Some(mut item) = self.items.data.get(step.name.as_str()) else {
            let near = nearest(&step.name, self.items.data.keys().map(SmolStr::as_str)).map(SmolStr::from);
            let name = step.name.as_str().into();
            return (!self.items.lacks_data).then_some(PageFault::UnknownData { name, near });
        };
        let is_resized = is_resized(self.db, self.project, &step.name);
        loop {
            if !is_resized && let Some(fault) = index_fault(item, step) {
                return Some(fault);
            }
            let Some(next) = steps.next() else { return self.type_fault(item.base, path, attribute) };
            let Base::User(of) = item.base else { return None };
            let fields = fields(self.db, of);
            let Some(field) = fields.get(next.name.as_str()) else {
                let near = nearest(&next.name, fields.keys().map(SmolStr::as_str)).map(SmolStr::from);
                let (name, of_type) = (next.name.as_str().into(), item.base.display(self.db));
                return (!items(self.db, of).lacks_data).then_some(PageFault::UnknownField { name, of_type, near });
            };
            (item, step) = (field, next);
        }
    }

    /// Reports a type with several values, such as a position, which cannot be bound to an attribute.
    fn type_fault(&self, base: Base, path: &str, attribute: Option<&SmolStr>) -> Option<PageFault> {
        let is_single = match base {
            Base::Unknown => true,
            Base::User(_) => false,
            Base::Builtin(ty, _) => !matches!(
                ty,
                BaseType::Trsf
                    | BaseType::Frame
                    | BaseType::Tool
                    | BaseType::Point
                    | BaseType::Joint
                    | BaseType::Config
                    | BaseType::Mdesc
                    | BaseType::Screen
            ),
        };
        let attribute = attribute.filter(|_| !is_single)?.clone();
        Some(PageFault::SeveralValues { path: path.into(), found: base.display(self.db), attribute })
    }

    fn program(&mut self, bound: &BoundName) {
        let name = bound.text.as_str();
        match self.items.programs.get(name) {
            None if self.items.may_have_program(name) => {}
            None => {
                let near = nearest(name, self.items.programs.keys().map(SmolStr::as_str)).map(SmolStr::from);
                self.report(self.file, bound.range, PageFault::UnknownProgram { name: name.into(), near });
            }
            Some(file) if !signature(self.db, self.project, *file).params.is_empty() => {
                self.report(self.file, bound.range, PageFault::Parameters { name: name.into() });
            }
            Some(_) => {}
        }
    }

    /// Checks the element ids: each must exist once. Pages whose scripts may add elements are not checked.
    fn elements(&mut self, found: &Bindings) {
        let Some(page) = page_of(self.db, self.project, self.file) else { return };
        let ids = page_ids(self.db, page);
        if ids.is_dynamic || !is_read(self.db, page) {
            return;
        }
        for bound in found.elements().filter(|bound| !ids.declares(&bound.text)) {
            let near = nearest(&bound.text, ids.declared.iter().map(|(id, _)| id.as_str())).map(SmolStr::from);
            self.report(self.file, bound.range, PageFault::UnknownElement { id: bound.text.clone(), near });
        }
        let mut known = FxHashSet::default();
        for (id, range) in ids.declared.iter().filter(|(id, _)| found.elements().any(|bound| bound.text == *id)) {
            if !known.insert(id) {
                self.report(page, *range, PageFault::ElementTwice { id: id.as_str().into() });
            }
        }
    }
}

fn is_read(db: &dyn Db, file: File) -> bool {
    matches!(file.status(db), FileStatus::Read { .. })
}

/// Returns the fault if an index is beyond the declared size.
fn index_fault(item: &DataItem, step: &ReferencePart) -> Option<PageFault> {
    let (Container::Array { .. }, Some(index)) = (item.decl.container, step.index.as_deref()) else { return None };
    let indexes: Option<Vec<u32>> = index.split(',').map(|index| index.trim().parse().ok()).collect();
    let sizes = &item.decl.sizes;
    let is_inside = indexes.is_some_and(|indexes| {
        indexes.len() == sizes.len() && indexes.iter().zip(sizes).all(|(index, size)| index < size)
    });
    let size = || sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(",").into();
    (!is_inside).then(|| PageFault::Index { name: step.name.as_str().into(), index: index.into(), size: size() })
}
