//! Compilation of a project.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::add_on_programs;
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::items::manifest::{length_unit, manifest, parameter};
use val3_analysis::items::program::header;
use val3_analysis::items::project::{arm_of_positions, folder, items, program_files};
use val3_analysis::test_applications::sees_private_items;
use val3_bytecode::{ContainerKind, ContainerRef, DataDef, Image, LibraryDef, LinkInit};
use val3_lang::builtins;
use val3_lines::LineIndex;

use crate::code_form::CodeForm;
use crate::data::LoadedLink;
use crate::error::{CompileError, CompileLimit, DataError};
use crate::io_library;
use crate::kinds::Kinds;
use crate::layout::{FrameLayout, LayoutRequest};
use crate::program;
use crate::unit::CompileUnit;

/// Default stack size per task, in bytes (2.1.4.2).
const STACK_SIZE: u32 = 5000;

/// Compiles an application or library without analysis errors to an image.
///
/// # Errors
/// A limit that the project exceeds.
pub fn compile(db: &dyn Db, project: Project) -> Result<Image, CompileError> {
    compile_as(db, project, CodeForm::Plain)
}

/// Like [`compile`], with a form of the code.
///
/// # Errors
/// A limit that the project exceeds.
pub fn compile_as(db: &dyn Db, project: Project, form: CodeForm) -> Result<Image, CompileError> {
    image(db, project, form, None).map(|(image, _)| image)
}

/// Like [`compile_as`], and returns the layout of a program. If the program has a replaced line, the other lines keep
/// their layout where possible.
///
/// # Errors
/// A limit that the project exceeds.
pub fn compile_with_layout<'db>(
    db: &'db dyn Db,
    project: Project,
    form: CodeForm,
    request: LayoutRequest<'db>,
) -> Result<(Image, FrameLayout), CompileError> {
    image(db, project, form, Some(request)).map(|(image, layout)| (image, layout.unwrap_or_default()))
}

fn image<'db>(
    db: &'db dyn Db,
    project: Project,
    form: CodeForm,
    layout: Option<LayoutRequest<'db>>,
) -> Result<(Image, Option<FrameLayout>), CompileError> {
    let file = project.manifest(db);
    let place = |limit| CompileError::at(file.path(db).as_str(), 1, limit);
    let mut kinds = Kinds::new(db, items(db, project).arm);
    let (data, links) = data(&mut kinds, project).map_err(|error| placed(db, error).unwrap_or_else(place))?;
    let programs = programs(db, project);
    let names: Vec<SmolStr> = data.iter().map(|data| SmolStr::from(&data.name)).collect();
    let mut unit =
        CompileUnit::new(kinds, project, names.iter(), programs.iter().map(|(name, _)| name)).map_err(place)?;
    (unit.form, unit.layout) = (form, layout);
    if let Some(LayoutRequest { image, .. }) = layout {
        unit.adopt_imports(image);
    }
    let compiled = programs.iter().zip(0u32..).map(|((_, file), number)| program::compile(&mut unit, *file, number));
    let mut compiled = compiled.collect::<Result<Vec<_>, _>>()?;
    val3_bytecode::plan_passes(&mut compiled);
    unit.import_interfaces().map_err(place)?;
    let mut image = Image {
        name: folder(db, project).file_name().unwrap_or_default().to_owned(),
        path: file.path(db).to_string(),
        files: programs.iter().map(|(_, file)| file.path(db).to_string()).collect(),
        version: unit.items.version,
        unit: length_unit(db, file),
        arm: arm_of_positions(db, project),
        stack_size: stack_size(db, file),
        sees_private_items: sees_private_items(db, project),
        data,
        links,
        programs: compiled,
        libraries: libraries(db, project),
        imports: unit.imports,
    };
    if form == CodeForm::Counted {
        image.number_counters();
    }
    Ok((image, unit.recorded_layout))
}

/// Returns the programs with their files, in project order. If two programs have the same name, the first one counts.
fn programs(db: &dyn Db, project: Project) -> Vec<(SmolStr, File)> {
    let mut known = FxHashSet::default();
    let named = program_files(db, project).iter().map(|file| (header(db, *file).name.clone(), *file));
    named.filter(|(name, _)| !name.is_empty() && known.insert(name.clone())).collect()
}

/// Adds the declaration's line to the error. If it is not about a variable, returns only the limit.
fn placed(db: &dyn Db, DataError { limit, datum }: DataError) -> Result<CompileError, CompileLimit> {
    let (name, FileRange { file, range }) = datum.ok_or(limit)?;
    let row = LineIndex::new(file.text(db)).line(range.start().into());
    let row = u32::try_from(row).unwrap_or(u32::MAX).saturating_add(1);
    Ok(CompileError { variable: Some(name.to_string()), ..CompileError::at(file.path(db).as_str(), row, limit) })
}

fn is_built_in_variable(name: &str) -> bool {
    builtins::find(name).is_some_and(|builtin| builtin.is_variable)
}

/// Returns global data with their links. Built-in variables are omitted, although files of s5 and s6 declare them.
fn data(kinds: &mut Kinds<'_>, project: Project) -> Result<(Vec<DataDef>, Vec<LinkInit>), DataError> {
    let (mut data, mut links) = (Vec::new(), Vec::new());
    let is_io_library = io_library::is_io_library(kinds.db, project);
    for (decl, base, loaded) in kinds.data_of(project, |decl| !is_built_in_variable(&decl.name))? {
        let number = u16::try_from(data.len()).map_err(|_| CompileLimit::Containers)?;
        ContainerRef::new(ContainerKind::Data(number)).ok_or(CompileLimit::Containers)?;
        if is_io_library && loaded.links.is_empty() {
            links.extend(io_library::link(kinds.db, project, &decl.name, base).map(|found| link(number.into(), found)));
        }
        links.extend(loaded.links.into_iter().map(|found| link(number.into(), found)));
        data.push(DataDef { name: decl.name.to_string(), public: decl.public, init: loaded.init });
    }
    Ok((data, links))
}

fn link(data: u32, found: LoadedLink) -> LinkInit {
    let LoadedLink { path, value, link, target } = found;
    LinkInit { data, path, value, link, target }
}

/// Returns the libraries in the project file, then the libraries of programs that replace instructions.
fn libraries(db: &dyn Db, project: Project) -> Vec<LibraryDef> {
    let declared = manifest(db, project.manifest(db)).libraries.iter().map(|entry| LibraryDef {
        alias: entry.alias.to_string(),
        path: entry.path.to_string(),
        autoload: entry.autoload,
    });
    let add_ons = add_on_programs::libraries(db, project).into_iter().map(|library| LibraryDef {
        alias: library.alias.to_string(),
        path: library.path().to_owned(),
        autoload: true,
    });
    declared.chain(add_ons).collect()
}

fn stack_size(db: &dyn Db, file: File) -> u32 {
    parameter(db, file, "stackSize").and_then(|text| text.trim().parse().ok()).unwrap_or(STACK_SIZE)
}
