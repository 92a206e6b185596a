//! Indexes, fields and items of libraries.

use rowan::TextRange;
use smol_str::SmolStr;
use val3_lang::types::{self, BaseType, Container};

use super::names::data_value;
use super::value::{Form, Origin, Value, Variable};
use super::{Infer, Overflow};
use crate::body::ExprId;
use crate::db::{FileRange, Project};
use crate::interfaces::is_left_out;
use crate::items::declarations;
use crate::items::project::{fields, items};
use crate::near::nearest;
use crate::problem::{NameKind, Problem, ProblemKind, Related, Role};
use crate::ty::Base;

impl Infer<'_> {
    /// `base[indexes]`
    pub(super) fn index(&mut self, base: ExprId, indexes: &[ExprId]) -> Value {
        let value = self.expr(base);
        let found: Vec<Base> = indexes.iter().map(|index| self.element(*index)).collect();
        if value.is_unknown() {
            return Value::UNKNOWN;
        }
        let Form::Whole(variable) = &value.form else {
            return self.index_not_allowed(base, &value);
        };
        match variable.container {
            Container::Element => return self.index_not_allowed(base, &value),
            Container::Array { dims } if indexes.len() != usize::from(dims) => {
                return self.index_count(base, &value, usize::from(dims), indexes.len());
            }
            Container::Array { .. } => self.array_index(base, variable, indexes, &found),
            Container::Collection => self.key(base, &value, indexes, &found),
        }
        Value { base: value.base, form: Form::Indexed { of: variable.container } }
    }

    fn index_not_allowed(&mut self, base: ExprId, value: &Value) -> Value {
        let (name, ty) = (self.text(base), value.ty().display(self.db));
        let declared = self.declared(value, &name);
        self.report_with(base, ProblemKind::IndexNotAllowed { name, ty, callee: None }, Role::Declared, declared);
        Value::UNKNOWN
    }

    fn index_count(&mut self, base: ExprId, value: &Value, expected: usize, found: usize) -> Value {
        let name = self.text(base);
        let declared = self.declared(value, &name);
        let kind = ProblemKind::IndexCount { name, expected, found };
        self.report_with(base, kind, Role::Declared, declared);
        Value::UNKNOWN
    }

    fn array_index(&mut self, base: ExprId, variable: &Variable, indexes: &[ExprId], found: &[Base]) {
        let name = self.text(base);
        for (position, (&index, &found)) in indexes.iter().zip(found).enumerate() {
            if !found.same_as(Base::of(BaseType::Num)) {
                self.wrong_index(index, &name, "num", found);
            } else if let Some(number) = self.body.number(index) {
                self.bounds(index, &name, (variable, position), number);
            }
        }
    }

    /// A constant index: below zero is wrong, above the size only where the size cannot change; neither is where the
    /// value need not be there, as for `isDefined`.
    fn bounds(&mut self, id: ExprId, name: &SmolStr, (variable, position): (&Variable, usize), number: f64) {
        // Indexes are rounded to the nearest whole number (2.5.3).
        let index = (number + 0.5).floor() as i64;
        let size = self.sizes(variable, name).and_then(|sizes| sizes.get(position)).copied();
        let is_outside = index < 0 || size.is_some_and(|size| index >= i64::from(size));
        if self.may_be_absent || !is_outside {
            return;
        }
        let size = size.map_or(0, |size| size as usize);
        let kind = ProblemKind::IndexOutOfBounds { name: name.clone(), index, size };
        let problem = Problem { kind, place: self.place(self.body.range(id)), related: Vec::new() };
        match &variable.origin {
            Origin::Data(_, name) if index >= 0 => self.overflows.push(Overflow { data: name.clone(), problem }),
            _ => self.problems.push(problem),
        }
    }

    /// Sizes that only this project can change: those of locals and of its private data.
    fn sizes(&self, variable: &Variable, name: &str) -> Option<&[u32]> {
        match &variable.origin {
            Origin::Data(file, name) => {
                let own = self.items.data.get(name).filter(|item| item.file == *file && !item.decl.public)?;
                Some(&own.decl.sizes)
            }
            Origin::Local => {
                let local = self.header.locals.iter().find(|local| local.name == name)?;
                Some(&local.sizes)
            }
            Origin::Parameter | Origin::Builtin => None,
        }
    }

    fn key(&mut self, base: ExprId, value: &Value, indexes: &[ExprId], found: &[Base]) {
        let name = self.text(base);
        match (indexes, found) {
            ([key], [base]) => {
                if !base.same_as(Base::of(BaseType::String)) {
                    self.wrong_index(*key, &name, "string", *base);
                }
            }
            _ => {
                self.index_count(base, value, 1, indexes.len());
            }
        }
    }

    fn wrong_index(&mut self, id: ExprId, name: &SmolStr, expected: &'static str, found: Base) {
        let found = self.show(found);
        let kind = ProblemKind::IndexType { name: name.clone(), expected: SmolStr::new_static(expected), found };
        self.report(id, kind);
    }

    /// `base.field`
    pub(super) fn field(&mut self, base: ExprId, field: &SmolStr, range: TextRange) -> Value {
        let value = self.expr(base);
        if value.lacks_index() {
            self.index_missing(base, &value);
            return Value::UNKNOWN;
        }
        match value.base {
            Base::Unknown => Value::UNKNOWN,
            Base::User(project) => self.user_field(project, value.base, field, range),
            Base::Builtin(ty, arm) => {
                let arm = arm.or(self.arm());
                match types::field(ty, arm, field) {
                    Some(found) => {
                        self.part(&value, Base::Builtin(found.ty, arm.filter(|_| found.ty.depends_on_arm())))
                    }
                    None => {
                        let names = types::fields(ty, arm).iter().map(|field| field.name);
                        let near = nearest(field, names);
                        self.unknown_field(value.base, field, near, range, None)
                    }
                }
            }
        }
    }

    /// A field of a built-in type: a part of a variable, or of a computed value.
    fn part(&self, whole: &Value, base: Base) -> Value {
        match whole.form {
            Form::Computed => Value::computed(base),
            _ => Value { base, form: Form::Indexed { of: Container::Element } },
        }
    }

    fn user_field(&mut self, project: Project, base: Base, field: &SmolStr, range: TextRange) -> Value {
        let fields = fields(self.db, project);
        if let Some(item) = fields.get(field) {
            return data_value(item);
        }
        if items(self.db, project).lacks_data {
            return Value::UNKNOWN;
        }
        let near = nearest(field, fields.keys().map(SmolStr::as_str));
        let private = items(self.db, project)
            .data
            .get(field)
            .and_then(|item| declarations::data(self.db, item.file, field.clone()));
        self.unknown_field(base, field, near, range, private)
    }

    fn unknown_field(
        &mut self,
        base: Base,
        field: &SmolStr,
        near: Option<SmolStr>,
        range: TextRange,
        private: Option<FileRange>,
    ) -> Value {
        let kind = ProblemKind::UnknownField { ty: self.show(base), field: field.clone(), near };
        self.report_at(range, kind, private.map(|place| Related { place, role: Role::Declared }));
        Value::UNKNOWN
    }

    /// `library:item` as a value.
    pub(super) fn path(&mut self, id: ExprId, library: &SmolStr, item: &SmolStr) -> Value {
        let Some(interface) = self.interface(id, library) else { return Value::UNKNOWN };
        let items = items(self.db, interface);
        match items.data.get(item) {
            Some(found) if found.decl.may_be_public() => data_value(found),
            Some(found) => {
                let place = declarations::data(self.db, found.file, item.clone());
                let kind = self.private_item(library, item, NameKind::Data);
                self.report_with(id, kind, Role::Declared, place);
                Value::UNKNOWN
            }
            None if items.programs.contains_key(item) => {
                let name = self.text(id);
                self.report(id, ProblemKind::NotAValue { name, is: NameKind::Program });
                Value::UNKNOWN
            }
            None if items.lacks_data || is_left_out(self.db, interface, item, NameKind::Data) => Value::UNKNOWN,
            None => {
                let public = items.data.iter().filter(|(_, item)| item.decl.public).map(|(name, _)| name.as_str());
                let near = nearest(item, public);
                let (alias, item) = (library.clone(), item.clone());
                let place = declarations::library(self.db, self.project, library.clone());
                let kind = ProblemKind::LibraryItemUnknown { alias, item, what: NameKind::Data, near };
                self.report_with(id, kind, Role::Interface, place);
                Value::UNKNOWN
            }
        }
    }

    pub(super) fn private_item(&self, library: &SmolStr, item: &SmolStr, what: NameKind) -> ProblemKind {
        ProblemKind::LibraryItemPrivate { alias: library.clone(), item: item.clone(), what }
    }

    /// The interface behind a library identifier; `None` where it is not known, which is reported once.
    pub(super) fn interface(&mut self, id: ExprId, library: &SmolStr) -> Option<Project> {
        if let Some(found) = self.items.libraries.get(library) {
            return found.interface;
        }
        if self.items.incomplete {
            return None;
        }
        let near = nearest(library, self.items.libraries.keys().map(SmolStr::as_str));
        self.report(id, ProblemKind::UnknownLibrary { alias: library.clone(), near });
        None
    }
}
