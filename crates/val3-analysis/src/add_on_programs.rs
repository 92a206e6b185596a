//! Stand-in programs, which are called instead of add-on instructions (`run.add-ons` in `val3.toml`).
//!
//! A stand-in has the parameters of its instruction. If the instruction returns a value, an additional last parameter
//! by reference receives the value.

use camino::Utf8PathBuf;
use smol_str::{SmolStr, format_smolstr};
use val3_config::{AddOnStandIn, ConfigFile, StandInProgram};
use val3_lang::add_on::{AddOnOverload, AddOnParam};
use val3_lang::instruction::CallClass;
use val3_lang::types::{BaseType, Container};

use crate::db::{Db, File, Project, Sources};
use crate::items::project::{SignatureParam, items, signature};
use crate::paths::{normalise, path_key, with_manifest};

/// A program that is called instead of an add-on instruction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddOnProgram {
    /// Library of the program.
    pub library: AddOnLibrary,
    /// Program name.
    pub name: SmolStr,
    /// Program file.
    pub file: File,
}

/// A library of stand-in programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddOnLibrary {
    /// Library identifier: `$` and the folder as written in the settings. Identifiers in programs never begin with `$`.
    pub alias: SmolStr,
    /// Project of the library.
    pub project: Project,
}

impl AddOnLibrary {
    /// Returns the folder as written in the settings.
    pub fn path(&self) -> &str {
        self.alias.strip_prefix('$').unwrap_or(&self.alias)
    }
}

/// Returns the path of the library's project file for a stand-in in `file`.
pub fn manifest_of(file: &ConfigFile, program: &StandInProgram) -> Utf8PathBuf {
    with_manifest(normalise(&file.folder().join(program.folder())))
}

/// Returns the stand-in programs in a settings file with their instruction names.
pub fn named(file: &ConfigFile) -> impl Iterator<Item = (&String, &StandInProgram)> {
    file.config.run.add_ons.iter().filter_map(|(instruction, stand_in)| match stand_in {
        AddOnStandIn::Program(program) => Some((instruction, program)),
        AddOnStandIn::Value(_) => None,
    })
}

/// Returns the library of a stand-in in a settings file; `None` if the library does not exist.
pub fn library(db: &dyn Db, file: &ConfigFile, program: &StandInProgram) -> Option<AddOnLibrary> {
    let project = *Sources::get(db).projects(db).get(&path_key(manifest_of(file, program).as_str()))?;
    let alias = format_smolstr!("${}", normalise(program.folder()).as_str().replace('\\', "/"));
    Some(AddOnLibrary { alias, project })
}

/// Returns the libraries that `project` loads for its stand-ins, sorted by identifier. The project itself is omitted.
pub fn libraries(db: &dyn Db, project: Project) -> Vec<AddOnLibrary> {
    let Some(configuration) = project.configuration(db) else { return Vec::new() };
    let file = configuration.file(db);
    let mut found: Vec<_> = named(file).filter_map(|(_, program)| library(db, file, program)).collect();
    found.retain(|library| library.project != project);
    found.sort_unstable_by(|one, other| one.alias.cmp(&other.alias));
    found.dedup();
    found
}

/// Returns all stand-in programs of `project`.
pub fn programs(db: &dyn Db, project: Project) -> Vec<AddOnProgram> {
    let Some(configuration) = project.configuration(db) else { return Vec::new() };
    named(configuration.file(db)).filter_map(|(instruction, _)| program(db, project, instruction)).collect()
}

/// Returns the program that `project` calls instead of `instruction`.
pub fn program(db: &dyn Db, project: Project, instruction: &str) -> Option<AddOnProgram> {
    let file = project.configuration(db)?.file(db);
    let AddOnStandIn::Program(program) = file.config.run.add_ons.get(instruction)? else { return None };
    let library = library(db, file, program)?;
    let (name, file) = items(db, library.project).programs.get_key_value(program.name())?;
    Some(AddOnProgram { name: name.clone(), file: *file, library })
}

impl AddOnProgram {
    /// Returns the parameters.
    pub fn params<'db>(&self, db: &'db dyn Db) -> &'db [SignatureParam] {
        &signature(db, self.library.project, self.file).params
    }

    /// Whether the program has the parameters of this form of the instruction.
    pub fn fits(&self, db: &dyn Db, form: &AddOnOverload) -> bool {
        let params = match (form.result, self.params(db)) {
            (None, params) => Some(params),
            (Some(result), [params @ .., last]) if result_type(last) == Some(result) => Some(params),
            (Some(_), _) => None,
        };
        params.is_some_and(|params| {
            !form.on_library
                && params.len() == form.params.len()
                && params.iter().zip(&form.params).all(|(param, formal)| is_same(param, formal))
        })
    }
}

/// Returns the forms that a stand-in defines for an instruction without another description: one with all parameters,
/// and one without the last parameter if that can receive the result.
#[salsa::tracked]
pub(crate) fn forms(db: &dyn Db, library: Project, file: File) -> Vec<AddOnOverload> {
    let params = &signature(db, library, file).params;
    let with_result = params.split_last().and_then(|(last, others)| Some(form(others, Some(result_type(last)?))));
    std::iter::once(form(params, None)).chain(with_result).collect()
}

fn form(params: &[SignatureParam], result: Option<BaseType>) -> AddOnOverload {
    AddOnOverload {
        on_library: false,
        params: params.iter().map(add_on_param).collect(),
        result,
        class: CallClass::Modifier,
    }
}

fn add_on_param(param: &SignatureParam) -> AddOnParam {
    AddOnParam { name: param.name.to_string(), ty: param.base.builtin(), shape: param.shape() }
}

/// Returns the result type that a parameter can receive; `None` if it can receive no result.
fn result_type(param: &SignatureParam) -> Option<BaseType> {
    let is_variable = param.by_reference && (param.loose || param.container == Container::Element);
    param.base.builtin().filter(|_| is_variable)
}

fn is_same(param: &SignatureParam, formal: &AddOnParam) -> bool {
    let is_same_shape = param.shape() == formal.shape
        || param.loose && param.shape().is_by_reference() && formal.shape.is_by_reference();
    formal.ty.is_some() && param.base.builtin() == formal.ty && is_same_shape
}
