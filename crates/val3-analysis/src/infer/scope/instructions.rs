//! Lookup of add-on instructions, and faults of unknown instructions.

use smol_str::{SmolStr, format_smolstr};
use val3_config::{AddOnStandIn, StandInValue};
use val3_lang::add_on::AddOnOverload;
use val3_lang::instruction::Availability;
use val3_lang::instructions;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use super::NameResolver;
use crate::add_on_programs;
use crate::items::project::items;
use crate::problem::{NameKind, ProblemKind};

impl<'db> NameResolver<'db> {
    /// Returns the forms that the cell's tables declare for an add-on instruction.
    pub(in crate::infer) fn add_on_forms(&self, name: &str, on_library: bool) -> Vec<&'db AddOnOverload> {
        let db = self.db;
        let tables = self.project.cell(db).map(|cell| cell.config(db).add_ons.as_slice()).unwrap_or_default();
        let functions = tables.iter().filter_map(|table| table.find(name));
        functions.flat_map(|function| &function.overloads).filter(|form| form.on_library == on_library).collect()
    }

    /// Returns the fault of a name that is called as an instruction but is none.
    pub(in crate::infer) fn unknown_instruction(&self, name: &SmolStr, library: Option<&SmolStr>) -> ProblemKind {
        let is = match library {
            None if self.items.programs.contains_key(name) => Some(NameKind::Program),
            None => self.variable_kind(name),
            Some(library) => {
                let interface = self.items.libraries.get(library).and_then(|item| item.interface);
                let interface = interface.map(|project| items(self.db, project));
                interface.is_some_and(|items| items.programs.contains_key(name)).then_some(NameKind::Program)
            }
        };
        let near = nearest(name, instructions::all().iter().map(|instruction| instruction.name)).map(SmolStr::from);
        let near = if is.is_some() { None } else { near };
        let name = library.map_or_else(|| name.clone(), |library| format_smolstr!("{library}:{name}"));
        ProblemKind::UnknownInstruction { name, near, is }
    }

    /// Returns the type of the constant that `run.add-ons` in `val3.toml` sets for an add-on instruction.
    pub(in crate::infer) fn stand_in_type(&self, name: &str) -> Option<BaseType> {
        let AddOnStandIn::Value(value) = self.project.config(self.db)?.run.add_ons.get(name)? else { return None };
        Some(match value {
            StandInValue::Bool(_) => BaseType::Bool,
            StandInValue::Number(_) => BaseType::Num,
            StandInValue::Text(_) => BaseType::String,
        })
    }

    /// Returns the forms that a stand-in program defines for an add-on instruction without another description.
    pub(in crate::infer) fn stand_in_forms(&self, name: &str, on_library: bool) -> Vec<&'db AddOnOverload> {
        let program = add_on_programs::program(self.db, self.project, name).filter(|_| !on_library);
        program.map_or_else(Vec::new, |program| {
            add_on_programs::forms(self.db, program.library.project, program.file).iter().collect()
        })
    }

    /// Returns the fault for an add-on instruction without a table in the cell. `other_forms` are the syntax lines of
    /// its known forms, if the arguments match none of them.
    pub(in crate::infer) fn missing_add_on(&self, name: &SmolStr, other_forms: Vec<SmolStr>) -> ProblemKind {
        let add_on = instructions::find(name).and_then(|instruction| match instruction.availability {
            Availability::AddOn(add_on) => Some(SmolStr::new_static(add_on)),
            _ => None,
        });
        let lists_others = self.project.cell(self.db).is_some_and(|cell| !cell.config(self.db).add_ons.is_empty());
        ProblemKind::MissingAddOn { name: name.clone(), add_on, lists_others, other_forms }
    }
}
