//! Checks of the programs that are called in place of add-on instructions (`run.add-ons` in `val3.toml`).

use camino::Utf8Path;
use val3_analysis::add_on_programs::{self, AddOnLibrary, AddOnProgram};
use val3_analysis::db::{Configuration, Database, Db, FileRange, Project, Sources};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{folder, items, signature};
use val3_analysis::load::LoadError;
use val3_config::{ConfigFile, StandInProgram};
use val3_lang::add_on::AddOnOverload;
use val3_lang::suggest::{nearest, question};
use val3_lines::LineIndex;

use crate::error::SessionError;

/// Libraries with such programs that an application and its libraries load, by identifier.
///
/// # Errors
/// If a setting names a program that cannot be called, or if two settings files use the same identifier for libraries
/// in different folders.
pub(crate) fn libraries(db: &Database) -> Result<Vec<AddOnLibrary>, SessionError> {
    let mut found: Vec<AddOnLibrary> = Vec::new();
    for (configuration, user) in configurations(db) {
        let file = configuration.file(db);
        for (instruction, setting) in add_on_programs::named(file) {
            let fault = |message, help| fault(file, instruction, message, help);
            check(db, user, file, instruction, setting).map_err(|(message, help)| fault(message, help))?;
            let Some(library) = add_on_programs::library(db, file, setting) else { continue };
            match found.iter().find(|known| known.alias == library.alias) {
                Some(known) if known.project == library.project => {}
                Some(known) => {
                    let (path, other) = (library.path(), folder(db, known.project));
                    let message = format!("`{path}` is `{other}` in another settings file that this run reads");
                    return Err(fault(message, "name the same folder in both, or rename one".to_owned()));
                }
                None => found.push(library),
            }
        }
    }
    Ok(found)
}

/// Settings files of all projects that were read, each with one project that uses it, sorted by the project's path.
fn configurations(db: &dyn Db) -> Vec<(Configuration, Project)> {
    let mut projects: Vec<_> = Sources::get(db).projects(db).iter().collect();
    projects.sort_unstable_by_key(|(key, _)| *key);
    let mut found: Vec<(Configuration, Project)> = Vec::new();
    for (_, project) in projects {
        if let Some(configuration) = project.configuration(db)
            && found.iter().all(|(known, _)| *known != configuration)
        {
            found.push((configuration, *project));
        }
    }
    found
}

fn fault(file: &ConfigFile, instruction: &str, message: String, help: String) -> SessionError {
    LoadError::Configuration(vec![file.fault(&format!("run.add-ons.{instruction}"), message, help)]).into()
}

/// A message with its help.
type AddOnFault = (String, String);

/// Checks that a program can replace an instruction.
fn check(
    db: &Database,
    user: Project,
    file: &ConfigFile,
    instruction: &str,
    setting: &StandInProgram,
) -> Result<(), AddOnFault> {
    let library = add_on_programs::library(db, file, setting).ok_or_else(|| no_library(file, setting))?;
    let Some(program) = add_on_programs::program(db, user, instruction) else {
        return Err(no_program(db, library.project, setting));
    };
    let name = &program.name;
    if !signature(db, library.project, program.file).public {
        let help = "write `access=\"public\"` in its element <Program>".to_owned();
        return Err((format!("the program `{name}` is not public, so that no other project can call it"), help));
    }
    if let Some(refusal) = val3_check::refusals(db, library.project).into_iter().next() {
        let FileRange { file, range } = refusal.place;
        let (path, line) = (file.path(db), line(file.text(db), range.start().into()));
        let message = format!("the library of `{name}` cannot be loaded: {path}:{line}: {}", refusal.message);
        return Err((message, refusal.help));
    }
    check_signature(db, user, instruction, &program)
}

fn line(text: &str, offset: usize) -> usize {
    LineIndex::new(text).line(offset) + 1
}

fn no_library(file: &ConfigFile, setting: &StandInProgram) -> AddOnFault {
    let manifest = add_on_programs::manifest_of(file, setting);
    let around = file.folder();
    let help = "add the library with the program, or correct the path: it names a program in the folder of its library";
    let message = format!("there is no library `{}` in `{around}`", manifest.strip_prefix(around).unwrap_or(&manifest));
    (message, help.to_owned())
}

fn no_program(db: &dyn Db, library: Project, setting: &StandInProgram) -> AddOnFault {
    let name = setting.name();
    let path = library.manifest(db).path(db);
    let project = path.file_name().unwrap_or_default();
    let programs = items(db, library).programs.keys().map(|name| name.as_str());
    let help = match question(nearest(name, programs)) {
        Some(question) => question,
        None if lists_program(db, library, name) => String::new(),
        None => format!("add the file to <Programs> of `{path}`"),
    };
    (format!("`{project}` has no program `{name}`"), help)
}

/// Whether the project file lists a program's file.
fn lists_program(db: &dyn Db, project: Project, name: &str) -> bool {
    let listed = &manifest(db, project.manifest(db)).programs;
    listed.iter().any(|file| Utf8Path::new(file).file_stem() == Some(name))
}

/// Checks that the program has the parameters of the instruction, as declared in the cell's tables. Without a table,
/// the calls are checked instead.
fn check_signature(db: &dyn Db, user: Project, instruction: &str, program: &AddOnProgram) -> Result<(), AddOnFault> {
    let params = program.params(db);
    if let Some(param) = params.iter().find(|param| param.base.builtin().is_none()) {
        let message = format!("the parameter `{}` of `{}` has a type that no add-on has", param.name, program.name);
        return Err((message, "give it a type of the language".to_owned()));
    }
    let tables = user.cell(db).map(|cell| cell.config(db).add_ons.as_slice()).unwrap_or_default();
    let forms: Vec<&AddOnOverload> =
        tables.iter().filter_map(|table| table.find(instruction)).flat_map(|found| &found.overloads).collect();
    if forms.is_empty() || forms.iter().any(|form| program.fits(db, form)) {
        return Ok(());
    }
    let expected: Vec<String> = forms.iter().map(|form| format!("`{}`", form.signature(instruction))).collect();
    let message = format!(
        "`{}` has other parameters than the instruction, which is {} in the cell",
        program.name,
        expected.join(" or ")
    );
    let result = "declare the same parameters in this order; a last parameter by reference receives the result";
    Err((message, result.to_owned()))
}
