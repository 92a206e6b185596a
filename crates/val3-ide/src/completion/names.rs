//! Completions of names: variables, constants, libraries.

use val3_analysis::items::project::{DataItem, items, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::{Base, brackets};
use val3_lang::builtins::{self, Builtin};
use val3_lang::enumerations;
use val3_lang::types::{self, BaseType};

use super::list::{CompletionKind as Kind, CompletionList};
use crate::line::Expected;
use crate::variables::declares_variable;

/// Score bonus for the expected type.
pub(super) const FITS: i32 = 60;
/// Score bonus for a value that has a field with the expected type.
const LEADS_ON: i32 = 10;
/// Score bonus of the program's names over names of the language.
pub(super) const OWN: i32 = 20;
/// Score bonus of locals and parameters over data.
const NEAR: i32 = 4;

/// Score bonus for a value of type `base` where the types `expected` are accepted.
pub(super) fn fit(expected: &[Base], base: Base) -> i32 {
    expected.iter().map(|expected| fit_one(*expected, base)).max().unwrap_or(0)
}

fn fit_one(expected: Base, base: Base) -> i32 {
    match (expected, base) {
        (_, Base::Unknown) => 0,
        (expected, base) if base.same_as(expected) => FITS,
        // Inputs and outputs are read as values (3.5, 3.6).
        (Base::Builtin(BaseType::Bool, _), Base::Builtin(BaseType::Dio, _)) => FITS,
        (Base::Builtin(BaseType::Num, _), Base::Builtin(BaseType::Aio, _)) => FITS,
        (expected, Base::Builtin(ty, arm)) => {
            let has_field = types::fields(ty, arm).iter().any(|field| Base::of(field.ty).same_as(expected));
            if has_field { LEADS_ON } else { 0 }
        }
        _ => 0,
    }
}

/// Type of data for display, for example `num[]` or `pointRx`.
pub(super) fn data_detail(item: &DataItem) -> String {
    let shape = if item.decl.sizes == [1] { "" } else { brackets(item.decl.container) };
    format!("{}{shape}", item.decl.type_name)
}

/// Locals, parameters and global data.
pub(super) fn variables(found: &mut CompletionList<'_>, expected: &Expected) {
    let (project, file, names) = (found.project, found.file, found.names());
    let base = |name: &str| resolve_type(&names.items.types, name).unwrap_or(Base::Unknown);
    for local in &names.header.locals {
        let shape = if local.sizes == [1] { "" } else { brackets(local.container) };
        let added = found.add(&local.name, Kind::Local).detail(|| format!("{}{shape}", local.type_name));
        let base = base(&local.type_name);
        let added = added.scored(fit(&expected.bases, base) + OWN + NEAR).variable(base, local.container, &local.sizes);
        added.of(|| Symbol::Local(file, local.name.clone()));
    }
    for param in &names.header.params {
        let base = base(&param.type_name);
        let added = found.add(&param.name, Kind::Parameter).variable(base, param.container, &[]);
        let added = added.detail(|| format!("{}{}", param.type_name, brackets(param.container)));
        let added = added.scored(fit(&expected.bases, base) + OWN + NEAR);
        added.of(|| Symbol::Param(file, param.name.clone()));
    }
    for (name, item) in names.items.data.iter().filter(|(name, _)| !declares_variable(names.header, name)) {
        let added = found.add(name, Kind::Data).detail(|| data_detail(item)).data(item);
        added.scored(fit(&expected.bases, item.base) + OWN).of(|| Symbol::Data(project, name.clone()));
    }
    for builtin in builtins::BUILTINS.iter().filter(|builtin| builtin.is_variable) {
        add_builtin(found, builtin, &expected.bases);
    }
}

/// Adds a built-in name if its type fits or its letters were typed.
fn add_builtin(found: &mut CompletionList<'_>, builtin: &Builtin, expected: &[Base]) {
    let score = fit(expected, Base::of(builtin.ty));
    if score > 0 || expected.is_empty() || !found.query.is_empty() {
        let added = found.add(builtin.name, Kind::Constant).detail(|| builtin.ty.name().to_owned());
        added.scored(score).of(|| Symbol::Builtin(builtin.name.into()));
    }
}

/// Named constants.
pub(super) fn constants(found: &mut CompletionList<'_>, expected: &[Base]) {
    for builtin in builtins::BUILTINS.iter().filter(|builtin| !builtin.is_variable) {
        add_builtin(found, builtin, expected);
    }
    // Enumerators are only useful where their type is expected.
    let wanted = expected.iter().filter_map(|base| base.builtin()).filter(|ty| ty.is_enumeration());
    for enumerator in wanted.flat_map(enumerations::values) {
        let added = found.add(enumerator.name, Kind::Constant).detail(|| enumerator.ty.name().to_owned());
        added.scored(FITS + OWN + NEAR).of(|| Symbol::Enumerator(enumerator.name.into()));
    }
}

/// Library identifiers, with the colon after them.
pub(super) fn libraries(found: &mut CompletionList<'_>) {
    let project = found.project;
    for name in items(found.db, project).libraries.keys() {
        let added = found.add(name, Kind::Library).detail(|| "library".to_owned()).scored(OWN);
        added.of(|| Symbol::Library(project, name.clone())).with(|item| {
            item.insert = format!("{name}:");
            item.plain = format!("{name}:");
        });
    }
}
