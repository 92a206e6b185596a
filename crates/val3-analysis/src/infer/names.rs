//! Names: locals and parameters hide data, data hides what is built in (2.5.2).

use crate::db::FileRange;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::{builtins, enumerations, instructions};

use super::Infer;
use super::value::{Form, Origin, Value, Variable};
use crate::body::ExprId;
use crate::items::declarations;
use crate::items::fathers::hidden_father;
use crate::items::program::Header;
use crate::items::project::{DataItem, Items, resolve_type};
use crate::near::nearest;
use crate::problem::{NameKind, ProblemKind};
use crate::ty::Base;

/// Parameters and locals of a program.
pub(super) fn scope<'db>(items: &'db Items, header: &'db Header) -> FxHashMap<&'db str, Value> {
    let base = |name: &str| resolve_type(&items.types, name).unwrap_or(Base::Unknown).on_arm(items.arm);
    let mut scope = FxHashMap::default();
    for local in &header.locals {
        let single = local.sizes == [1];
        let variable = Variable { container: local.container, single, loose: false, origin: Origin::Local };
        scope.insert(local.name.as_str(), Value { base: base(&local.type_name), form: Form::Whole(variable) });
    }
    for param in &header.params {
        let variable =
            Variable { container: param.container, single: false, loose: param.loose, origin: Origin::Parameter };
        scope.insert(param.name.as_str(), Value { base: base(&param.type_name), form: Form::Whole(variable) });
    }
    scope
}

/// A global variable, or a field of a user type.
pub(super) fn data_value(item: &DataItem) -> Value {
    if !item.decl.plain {
        return Value::UNKNOWN;
    }
    let origin = Origin::Data(item.file, item.decl.name.clone());
    let single = item.decl.sizes == [1];
    let variable = Variable { container: item.decl.container, single, loose: false, origin };
    Value { base: item.base, form: Form::Whole(variable) }
}

impl Infer<'_> {
    /// The value that `name` stands for.
    pub(super) fn name(&mut self, id: ExprId, name: &str) -> Value {
        if let Some(value) = self.known_name(name) {
            return value;
        }
        if self.items.lacks_data || !self.header.complete {
            return Value::UNKNOWN;
        }
        let kind = match self.other_use(name) {
            Some(is) => ProblemKind::NotAValue { name: name.into(), is },
            None => ProblemKind::UnknownName { name: name.into(), near: self.near_name(name) },
        };
        self.report(id, kind);
        Value::UNKNOWN
    }

    fn known_name(&self, name: &str) -> Option<Value> {
        if let Some(value) = self.scope.get(name) {
            return Some(value.clone());
        }
        if let Some(item) = self.items.data.get(name) {
            // Its declaration has the message.
            let is_hidden = hidden_father(self.db, self.project, name).is_some();
            return Some(if is_hidden { Value::UNKNOWN } else { data_value(item) });
        }
        if let Some(builtin) = builtins::find(name) {
            return Some(builtin_value(builtin));
        }
        enumerations::find(name).map(|enumerator| Value::of(enumerator.ty))
    }

    /// What else is called so.
    pub(super) fn other_use(&self, name: &str) -> Option<NameKind> {
        if self.items.programs.contains_key(name) {
            Some(NameKind::Program)
        } else if self.items.libraries.contains_key(name) {
            Some(NameKind::Library)
        } else if self.items.types.contains_key(name) {
            Some(NameKind::Type)
        } else {
            instructions::find(name).map(|_| NameKind::Instruction)
        }
    }

    /// The variable called `name`, as what it was declared.
    pub(super) fn variable_kind(&self, name: &str) -> Option<NameKind> {
        match self.scope.get(name).map(|value| &value.form) {
            Some(Form::Whole(Variable { origin: Origin::Parameter, .. })) => Some(NameKind::Parameter),
            Some(_) => Some(NameKind::Local),
            None => self.items.data.contains_key(name).then_some(NameKind::Data),
        }
    }

    fn near_name(&self, name: &str) -> Option<SmolStr> {
        let scope = self.scope.keys().copied();
        let data = self.items.data.keys().map(SmolStr::as_str);
        let builtins = builtins::BUILTINS.iter().map(|builtin| builtin.name);
        nearest(name, scope.chain(data).chain(builtins))
    }

    /// Where the variable at the root of an expression is declared.
    pub(super) fn declared(&self, value: &Value, name: &str) -> Option<FileRange> {
        let Form::Whole(Variable { origin, .. }) = &value.form else { return None };
        match origin {
            Origin::Data(file, name) => declarations::data(self.db, *file, name.clone()),
            Origin::Local => declarations::local(self.db, self.file, name.into()),
            Origin::Parameter => declarations::param(self.db, self.file, name.into()),
            Origin::Builtin => None,
        }
    }
}

fn builtin_value(builtin: &builtins::Builtin) -> Value {
    let base = Base::of(builtin.ty);
    if !builtin.is_variable {
        return Value::computed(base);
    }
    let container = val3_lang::types::Container::Array { dims: 1 };
    let variable = Variable { container, single: true, loose: false, origin: Origin::Builtin };
    Value { base, form: Form::Whole(variable) }
}
