//! Names, files and versions for attributes.

use std::collections::BTreeSet;

use camino::Utf8Path;
use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{items, program_files};
use val3_lang::files::FileKind;
use val3_lang::versions::Version;
use val3_lang::{builtins, enumerations, instructions, keywords, versions};

use crate::completion::list::CompletionList;
use crate::line::VisibleNames;
use crate::reachable_projects::{Reachable, reachable};
use crate::xml_context::XmlContext;

/// Value that is more likely than the default in a new element.
pub(super) fn likely(
    found: &CompletionList<'_>,
    context: &XmlContext<'_>,
    element: &str,
    attribute: &str,
) -> Option<String> {
    let (db, project) = (found.db, found.project);
    match (context.file, element, attribute) {
        (FileKind::Program, "Program" | "program", "name") => stem(db, found.file),
        (FileKind::Program, "Programs" | "programList", "name") => stem(db, found.file),
        (FileKind::Project, _, "version") => versions(db, project).into_iter().next(),
        (FileKind::Project, "Program" | "program", "file") => unlisted(found, ".pgx"),
        (FileKind::Project, "Data" | "data", "file") => unlisted(found, ".dtx"),
        (FileKind::Project, "Library" | "alias" | "Type", _) => {
            let other = unnamed(db, project).into_iter().next()?;
            match attribute {
                "path" | "interface" => Some(other.entry(db, project)),
                "alias" | "name" => Some(other.name(db).to_owned()),
                _ => None,
            }
        }
        (FileKind::Program, "Parameter" | "Local" | "param" | "local", "name") => {
            undeclared(found, &[found.file]).first().map(SmolStr::to_string)
        }
        (FileKind::Data, "Data", "name") => {
            undeclared(found, program_files(db, project)).first().map(SmolStr::to_string)
        }
        (_, _, "type") => Some("num".to_owned()),
        _ => None,
    }
}

/// File name without extension.
pub(super) fn stem(db: &dyn Db, file: File) -> Option<String> {
    file.path(db).file_stem().map(str::to_owned)
}

/// Files with this extension in the project folder, each with whether the project lists it.
pub(super) fn files(found: &CompletionList<'_>, extension: &str) -> Vec<(SmolStr, bool)> {
    let (db, project) = (found.db, found.project);
    let manifest = manifest(db, project.manifest(db));
    let files = project.beside(db).iter().filter(|name| name.to_ascii_lowercase().ends_with(extension));
    let files = files.map(|name| {
        let mut entries = manifest.programs.iter().chain(&manifest.data);
        (name.clone(), entries.any(|entry| entry.eq_ignore_ascii_case(name)))
    });
    files.collect()
}

fn unlisted(found: &CompletionList<'_>, extension: &str) -> Option<String> {
    files(found, extension).into_iter().find(|(_, is_listed)| !is_listed).map(|(name, _)| name.to_string())
}

/// Reachable projects that the project file does not reference yet.
fn unnamed(db: &dyn Db, project: Project) -> Vec<Reachable> {
    let named = named(db, project);
    reachable(db, project).into_iter().filter(|other| !named.contains(&other.project)).collect()
}

/// Projects that the project file references.
pub(super) fn named(db: &dyn Db, project: Project) -> FxHashSet<Project> {
    let items = items(db, project);
    let libraries = items.libraries.values().filter_map(|library| library.interface);
    libraries.chain(items.types.values().copied().flatten()).collect()
}

/// Versions; the versions of other reachable projects come first.
pub(super) fn versions(db: &dyn Db, project: Project) -> Vec<String> {
    let others = reachable(db, project).into_iter().map(|other| other.project);
    let written = others.map(|other| manifest(db, other.manifest(db)).version.to_string());
    let mut versions: Vec<String> = written.filter(|version| Version::parse(version).is_some()).collect();
    versions.extend(versions::KNOWN.iter().map(|version| (*version).to_owned()));
    let mut seen = FxHashSet::default();
    versions.retain(|version| seen.insert(version.clone()));
    versions
}

/// Library identifiers for a path: the project name, and undeclared identifiers that the code uses.
pub(super) fn aliases(found: &CompletionList<'_>, path: Option<&str>) -> Vec<String> {
    let (db, project) = (found.db, found.project);
    let of_path = path.map(Utf8Path::new).and_then(Utf8Path::file_stem).filter(|stem| !stem.is_empty());
    let mut names: Vec<String> = of_path.map(str::to_owned).into_iter().collect();
    let libraries = &items(db, project).libraries;
    let used: BTreeSet<SmolStr> = program_files(db, project)
        .iter()
        .flat_map(|file| body(db, *file).exprs())
        .filter_map(|(_, expr, _)| if let Expr::Path { library, .. } = expr { Some(library.clone()) } else { None })
        .filter(|library| !libraries.contains_key(library))
        .collect();
    names.extend(used.iter().map(SmolStr::to_string));
    names.extend(unnamed(db, project).iter().map(|other| other.name(db).to_owned()));
    names.retain(|name| keywords::is_identifier(name));
    names
}

/// Undeclared variable names that these programs use.
pub(super) fn undeclared(found: &CompletionList<'_>, files: &[File]) -> BTreeSet<SmolStr> {
    files.iter().flat_map(|file| undeclared_in(found.db, found.project, *file)).collect()
}

fn undeclared_in(db: &dyn Db, project: Project, file: File) -> Vec<SmolStr> {
    let (body, names) = (body(db, file), VisibleNames::new(db, project, file));
    let callees: FxHashSet<ExprId> = body
        .exprs()
        .filter_map(|(_, expr, _)| if let Expr::Call(callee, _) = expr { Some(*callee) } else { None })
        .collect();
    let unknown = body.exprs().filter(|(id, ..)| !callees.contains(id)).filter_map(|(_, expr, _)| match expr {
        Expr::Name(name) if !names.is_declared(name) && !is_predefined(name) => Some(name.clone()),
        _ => None,
    });
    unknown.collect()
}

/// Whether the language defines the name.
fn is_predefined(name: &str) -> bool {
    builtins::find(name).is_some() || enumerations::find(name).is_some() || instructions::find(name).is_some()
}
