//! Scope of a program: locals and parameters hide data, and data hides built-in names (2.5.2).

mod instructions;
mod libraries;

use rustc_hash::FxHashMap;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::suggest::nearest;
use val3_lang::types::Arm;
use val3_lang::{builtins, enumerations, instructions as catalogue};

use super::value::{DeclaredVariable, Form, InferredValue, VariableOrigin};
use crate::db::{Db, File, FileRange, Project};
use crate::items::declarations;
use crate::items::fathers::hidden_father;
use crate::items::program::{Header, header};
use crate::items::project::{DataItem, Items, items, resolve_type};
use crate::paths::distinct_ends;
use crate::problem::{NameKind, ProblemKind, Related, RelatedRole};
use crate::ty::Base;

/// Resolves the names in a program. It reports nothing: a failed lookup returns its fault.
pub(super) struct NameResolver<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    items: &'db Items,
    header: &'db Header,
    /// Parameters and locals by name.
    variables: FxHashMap<&'db str, InferredValue>,
}

/// Reason of a failed lookup.
pub(super) enum Unresolved {
    /// Declarations are missing or wrong, which is reported elsewhere.
    Incomplete,
    /// The name is wrong.
    Fault(Box<NameFault>),
}

/// Fault of a name, without its location.
pub(super) struct NameFault {
    pub(super) kind: ProblemKind,
    pub(super) related: Option<Related>,
}

impl Unresolved {
    fn fault(kind: ProblemKind) -> Self {
        Self::Fault(Box::new(NameFault { kind, related: None }))
    }

    fn fault_with(kind: ProblemKind, role: RelatedRole, declared: Option<FileRange>) -> Self {
        Self::Fault(Box::new(NameFault { kind, related: declared.map(|place| Related { place, role }) }))
    }
}

impl<'db> NameResolver<'db> {
    pub(super) fn new(db: &'db dyn Db, project: Project, file: File) -> Self {
        let (items, header) = (items(db, project), header(db, file));
        Self { db, project, file, items, header, variables: variables(items, header) }
    }

    pub(super) fn db(&self) -> &'db dyn Db {
        self.db
    }

    /// Returns the project's kind of arm, if known.
    pub(super) fn arm(&self) -> Option<Arm> {
        self.items.arm
    }

    /// Whether the project's VAL 3 version supports assignments between inputs and outputs.
    pub(super) fn assigns_dio_to_dio(&self) -> bool {
        self.items.version.assigns_dio_to_dio()
    }

    /// Formats a type as in a program.
    pub(super) fn show(&self, base: Base) -> SmolStr {
        base.display(self.db)
    }

    /// Formats two different types. User types with the same name are followed by their files.
    pub(super) fn show_both(&self, [one, other]: [Base; 2]) -> [SmolStr; 2] {
        match (one, other) {
            (Base::User(a), Base::User(b)) if a != b && self.show(one) == self.show(other) => {
                let file = |project: Project| project.manifest(self.db).path(self.db).as_path();
                let names = distinct_ends(file(a), file(b));
                names.map(|path| format_smolstr!("{} of {path}", self.show(one)))
            }
            _ => [self.show(one), self.show(other)],
        }
    }

    /// Resolves a name without a library as a value.
    pub(super) fn value(&self, name: &str) -> Result<InferredValue, Unresolved> {
        if let Some(value) = self.declared_value(name) {
            return Ok(value);
        }
        if self.items.lacks_data || !self.header.complete {
            return Err(Unresolved::Incomplete);
        }
        Err(Unresolved::fault(match self.other_use(name) {
            Some(is) => ProblemKind::NotAValue { name: name.into(), is },
            None => ProblemKind::UnknownName { name: name.into(), near: self.nearest_variable(name) },
        }))
    }

    fn declared_value(&self, name: &str) -> Option<InferredValue> {
        if let Some(value) = self.variables.get(name) {
            return Some(value.clone());
        }
        if let Some(item) = self.items.data.get(name) {
            // The fault is reported at the declaration.
            let is_hidden = hidden_father(self.db, self.project, name).is_some();
            return Some(if is_hidden { InferredValue::UNKNOWN } else { data_value(item) });
        }
        if let Some(builtin) = builtins::find(name) {
            return Some(builtin_value(builtin));
        }
        enumerations::find(name).map(|enumerator| InferredValue::of(enumerator.ty))
    }

    /// Returns the kind of a name that is no value.
    fn other_use(&self, name: &str) -> Option<NameKind> {
        if self.items.programs.contains_key(name) {
            Some(NameKind::Program)
        } else if self.items.libraries.contains_key(name) {
            Some(NameKind::Library)
        } else if self.items.types.contains_key(name) {
            Some(NameKind::Type)
        } else {
            catalogue::find(name).map(|_| NameKind::Instruction)
        }
    }

    /// Returns the kind of the variable called `name`.
    fn variable_kind(&self, name: &str) -> Option<NameKind> {
        match self.variables.get(name).map(|value| &value.form) {
            Some(Form::Whole(DeclaredVariable { origin: VariableOrigin::Parameter, .. })) => Some(NameKind::Parameter),
            Some(_) => Some(NameKind::Local),
            None => self.items.data.contains_key(name).then_some(NameKind::Data),
        }
    }

    fn nearest_variable(&self, name: &str) -> Option<SmolStr> {
        let variables = self.variables.keys().copied();
        let data = self.items.data.keys().map(SmolStr::as_str);
        let builtins = builtins::BUILTINS.iter().map(|builtin| builtin.name);
        nearest(name, variables.chain(data).chain(builtins)).map(SmolStr::from)
    }

    /// Resolves the program of `call name(…)`.
    pub(super) fn program(&self, name: &SmolStr) -> Result<(Project, File), Unresolved> {
        if let Some(file) = self.items.programs.get(name) {
            return Ok((self.project, *file));
        }
        if self.items.may_have_program(name) {
            return Err(Unresolved::Incomplete);
        }
        let is = self.variable_kind(name).or_else(|| catalogue::find(name).map(|_| NameKind::Instruction));
        let near = nearest(name, self.items.programs.keys().map(SmolStr::as_str)).map(SmolStr::from);
        let near = if is.is_some() { None } else { near };
        Err(Unresolved::fault(ProblemKind::UnknownProgram { name: name.clone(), near, is }))
    }

    /// Returns the declaration of the root variable.
    pub(super) fn declaration(&self, value: &InferredValue, name: &str) -> Option<FileRange> {
        let Form::Whole(DeclaredVariable { origin, .. }) = &value.form else { return None };
        match origin {
            VariableOrigin::Data(file, name) => declarations::data(self.db, *file, name.clone()),
            VariableOrigin::Local => declarations::local(self.db, self.file, name.into()),
            VariableOrigin::Parameter => declarations::param(self.db, self.file, name.into()),
            VariableOrigin::Builtin => None,
        }
    }

    /// Returns the sizes of a variable if only this project can change them: sizes of locals and private data.
    pub(super) fn sizes(&self, variable: &DeclaredVariable, name: &str) -> Option<&[u32]> {
        match &variable.origin {
            VariableOrigin::Data(file, name) => {
                let own = self.items.data.get(name).filter(|item| item.file == *file && !item.decl.public)?;
                Some(&own.decl.sizes)
            }
            VariableOrigin::Local => {
                let local = self.header.locals.iter().find(|local| local.name == name)?;
                Some(&local.sizes)
            }
            VariableOrigin::Parameter | VariableOrigin::Builtin => None,
        }
    }
}

/// Returns the parameters and locals of a program.
fn variables<'db>(items: &'db Items, header: &'db Header) -> FxHashMap<&'db str, InferredValue> {
    let base = |name: &str| resolve_type(&items.types, name).unwrap_or(Base::Unknown).on_arm(items.arm);
    let mut variables = FxHashMap::default();
    for local in &header.locals {
        let single = local.sizes == [1];
        let variable =
            DeclaredVariable { container: local.container, single, loose: false, origin: VariableOrigin::Local };
        variables
            .insert(local.name.as_str(), InferredValue { base: base(&local.type_name), form: Form::Whole(variable) });
    }
    for param in &header.params {
        let variable = DeclaredVariable {
            container: param.container,
            single: false,
            loose: param.loose,
            origin: VariableOrigin::Parameter,
        };
        variables
            .insert(param.name.as_str(), InferredValue { base: base(&param.type_name), form: Form::Whole(variable) });
    }
    variables
}

/// Returns the value for a global variable or a user type's field.
fn data_value(item: &DataItem) -> InferredValue {
    if !item.decl.plain {
        return InferredValue::UNKNOWN;
    }
    let origin = VariableOrigin::Data(item.file, item.decl.name.clone());
    let single = item.decl.sizes == [1];
    let variable = DeclaredVariable { container: item.decl.container, single, loose: false, origin };
    InferredValue { base: item.base, form: Form::Whole(variable) }
}

fn builtin_value(builtin: &builtins::Builtin) -> InferredValue {
    let base = Base::of(builtin.ty);
    if !builtin.is_variable {
        return InferredValue::computed(base);
    }
    let container = val3_lang::types::Container::Array { dims: 1 };
    let variable = DeclaredVariable { container, single: true, loose: false, origin: VariableOrigin::Builtin };
    InferredValue { base, form: Form::Whole(variable) }
}
