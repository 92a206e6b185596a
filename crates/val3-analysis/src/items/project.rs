//! Items of a project as visible to its own programs: the firewall between files and bodies.

use camino::Utf8Path;
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::{SmolStr, format_smolstr};
use val3_lang::instruction::ArgumentForm;
use val3_lang::types::{Arm, BaseType, Container};
use val3_lang::versions::Version;

use super::data::{DataDecl, data, is_complete};
use super::manifest::{Manifest, manifest};
use super::program::{Header, header};
use crate::db::{Db, File, Project, Sources};
use crate::paths::{self, ResolvedPath, path_key};

use crate::ty::{Base, brackets};

/// Names of a project.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Items {
    /// Global data by name.
    pub data: FxHashMap<SmolStr, DataItem>,
    /// Programs by name.
    pub programs: FxHashMap<SmolStr, File>,
    /// Library identifiers by name.
    pub libraries: FxHashMap<SmolStr, LibraryItem>,
    /// User types by name; `None` if the type's project was not found.
    pub types: FxHashMap<SmolStr, Option<Project>>,
    /// Whether a data file is missing or partly unreadable, so that an unresolved name may be declared in it.
    pub lacks_data: bool,
    /// Names of programs whose files are missing, unreadable, or contain a program with another name; in lower case.
    pub lacking_programs: FxHashSet<SmolStr>,
    /// Whether the project file is partly unreadable, so that any program, library or type may be missing.
    pub incomplete: bool,
    /// VAL 3 version from the configuration, or from the project, or the default.
    pub version: Version,
    /// Kind of arm from the configuration, the data or the cell, if known.
    pub arm: Option<Arm>,
}

/// A global variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataItem {
    /// Declaration in the data file.
    pub decl: DataDecl,
    /// Resolved type.
    pub base: Base,
    /// Data file.
    pub file: File,
}

/// A library identifier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryItem {
    /// Project of the interface; `None` if it was not found.
    pub interface: Option<Project>,
    /// Whether the library is loaded with the application.
    pub autoload: bool,
}

impl Items {
    /// Whether a program with this name may exist in a missing or unreadable file.
    pub fn may_have_program(&self, name: &str) -> bool {
        self.incomplete
            || !self.lacking_programs.is_empty() && self.lacking_programs.contains(name.to_lowercase().as_str())
    }
}

/// Returns the project that `reference` names in `project`.
pub fn find_project(db: &dyn Db, project: Project, reference: &str) -> Option<Project> {
    if leads_outside(db, project, reference) {
        return None;
    }
    match paths::project(folder(db, project), project.roots(db), reference) {
        ResolvedPath::Path(path) => Sources::get(db).projects(db).get(&path_key(path.as_str())).copied(),
        ResolvedPath::Elsewhere => None,
    }
}

/// Whether a reference in the project file is outside of the cell, so that its file is not read.
pub fn leads_outside(db: &dyn Db, project: Project, reference: &str) -> bool {
    project.outside(db).iter().any(|outside| outside == reference)
}

/// Returns the folder of a project.
pub fn folder(db: &dyn Db, project: Project) -> &Utf8Path {
    project.manifest(db).path(db).parent().unwrap_or(Utf8Path::new(""))
}

/// Returns the file that `reference` names in the project's folder, if it was read.
pub fn find_file(db: &dyn Db, project: Project, reference: &str) -> Option<File> {
    if leads_outside(db, project, reference) {
        return None;
    }
    let path = paths::file_in(folder(db, project), reference);
    Sources::get(db).files(db).get(&path_key(path.as_str())).copied()
}

/// Returns the program files of a project that were read, in the order of the project file.
#[salsa::tracked]
pub fn program_files(db: &dyn Db, project: Project) -> Vec<File> {
    let manifest = manifest(db, project.manifest(db));
    manifest.programs.iter().filter_map(|reference| find_file(db, project, reference)).collect()
}

/// Returns the data files of a project that were read.
#[salsa::tracked]
pub fn data_files(db: &dyn Db, project: Project) -> Vec<File> {
    let manifest = manifest(db, project.manifest(db));
    manifest.data.iter().filter_map(|reference| find_file(db, project, reference)).collect()
}

/// Returns the names of a project. If a name is declared twice, the first declaration is used.
#[salsa::tracked]
pub fn items(db: &dyn Db, project: Project) -> Items {
    let manifest = manifest(db, project.manifest(db));
    let configured = project.config(db).and_then(|config| config.version);
    let mut items = Items {
        version: configured.or_else(|| Version::parse(&manifest.version)).unwrap_or(Version::DEFAULT),
        arm: arm(db, project),
        incomplete: !manifest.complete,
        ..Items::default()
    };
    items.add_projects(db, project, manifest);
    items.add_programs(db, project, manifest);
    items.add_data(db, project, manifest);
    items
}

impl Items {
    fn add_projects(&mut self, db: &dyn Db, project: Project, manifest: &Manifest) {
        for entry in &manifest.types {
            self.types.entry(entry.name.clone()).or_insert_with(|| find_project(db, project, &entry.path));
        }
        for entry in &manifest.libraries {
            let interface = find_project(db, project, &entry.path);
            let item = LibraryItem { interface, autoload: entry.autoload };
            self.libraries.entry(entry.alias.clone()).or_insert(item);
        }
    }

    fn add_programs(&mut self, db: &dyn Db, project: Project, manifest: &Manifest) {
        for reference in &manifest.programs {
            let file = find_file(db, project, reference);
            let name = file.map(|file| &header(db, file).name).filter(|name| !name.is_empty());
            let stem = Utf8Path::new(reference).file_stem().unwrap_or("");
            if name.is_none_or(|name| !name.eq_ignore_ascii_case(stem)) {
                self.lacking_programs.insert(stem.to_lowercase().into());
            }
            if let (Some(file), Some(name)) = (file, name) {
                self.programs.entry(name.clone()).or_insert(file);
            }
        }
    }

    fn add_data(&mut self, db: &dyn Db, project: Project, manifest: &Manifest) {
        let mut files = manifest.data.iter().map(|reference| find_file(db, project, reference));
        self.lacks_data = self.incomplete || !files.all(|file| file.is_some_and(|file| is_complete(db, file)));
        for &file in data_files(db, project) {
            for decl in data(db, file) {
                let base = resolve_type(&self.types, &decl.type_name).unwrap_or(Base::Unknown);
                let item = DataItem { decl: decl.clone(), base, file };
                self.data.entry(decl.name.clone()).or_insert(item);
            }
        }
    }
}

/// Returns the type called `name`; `None` if it does not exist.
pub fn resolve_type(types: &FxHashMap<SmolStr, Option<Project>>, name: &str) -> Option<Base> {
    if let Some((base, arm)) = BaseType::from_file_name(name) {
        return Some(Base::Builtin(base, arm));
    }
    types.get(name).map(|project| project.map_or(Base::Unknown, Base::User))
}

/// Returns a project's kind of arm: from the configuration, else from all its positions, else from the cell.
#[salsa::tracked(returns(copy))]
fn arm(db: &dyn Db, project: Project) -> Option<Arm> {
    if let Some(arm) = project.config(db).and_then(|config| config.arm.as_ref()?.kind()) {
        return Some(arm);
    }
    arm_of_positions(db, project).or_else(|| project.cell_arm(db))
}

/// Returns the common kind of arm of all positions in a project, if they agree.
pub fn arm_of_positions(db: &dyn Db, project: Project) -> Option<Arm> {
    let mut arms = data_files(db, project).iter().flat_map(|file| data(db, *file)).filter_map(|decl| {
        let (_, arm) = BaseType::from_file_name(&decl.type_name)?;
        arm.filter(|_| !is_old_section(&decl.type_name))
    });
    arms.next().filter(|first| arms.all(|arm| arm == *first))
}

/// Whether the type comes from a section of the old dialect, which has a section for each kind of arm.
fn is_old_section(type_name: &str) -> bool {
    type_name.ends_with("Vrb")
}

/// Returns a user type's fields: the public data in its project.
#[salsa::tracked]
pub fn fields(db: &dyn Db, project: Project) -> FxHashMap<SmolStr, DataItem> {
    let items = items(db, project);
    items.data.iter().filter(|(_, item)| item.decl.public).map(|(name, item)| (name.clone(), item.clone())).collect()
}

/// Signature of a program for its callers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signature {
    /// Program name.
    pub name: SmolStr,
    /// Whether other projects may call the program.
    pub public: bool,
    /// Parameters in order.
    pub params: Vec<SignatureParam>,
    /// Whether every parameter is readable.
    pub complete: bool,
}

impl Signature {
    /// Formats the syntax line: `pick(num x_nCount, string& x_sName[])`.
    pub(crate) fn syntax_line(&self, db: &dyn Db) -> SmolStr {
        let params: Vec<String> = self.params.iter().map(|param| param.declaration(db)).collect();
        format_smolstr!("{}({})", self.name, params.join(", "))
    }
}

/// A parameter in a signature.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SignatureParam {
    /// Parameter name.
    pub name: SmolStr,
    /// Type of the values.
    pub base: Base,
    /// Element, array or collection.
    pub container: Container,
    /// Whether the parameter is passed by reference.
    pub by_reference: bool,
    /// Whether it may be an element or an array (old dialect).
    pub loose: bool,
}

impl SignatureParam {
    /// Formats the declaration: `string& x_sName[]`.
    fn declaration(&self, db: &dyn Db) -> String {
        let reference = if self.by_reference { "&" } else { "" };
        format!("{}{reference} {}{}", self.base.display(db), self.name, brackets(self.container))
    }

    /// Returns the form of argument. In the old dialect, every parameter by reference is an array, because elements are
    /// not distinguished.
    pub fn shape(&self) -> ArgumentForm {
        match self.container {
            Container::Element if self.by_reference => ArgumentForm::Reference,
            Container::Element => ArgumentForm::Value,
            Container::Array { dims } => ArgumentForm::Array { dims },
            Container::Collection => ArgumentForm::Collection,
        }
    }
}

/// Returns the signature of the program in `file`, with the types of `project`.
#[salsa::tracked]
pub fn signature(db: &dyn Db, project: Project, file: File) -> Signature {
    let Header { name, public, params, complete, .. } = header(db, file);
    let types = &items(db, project).types;
    let params = params.iter().map(|param| SignatureParam {
        name: param.name.clone(),
        base: resolve_type(types, &param.type_name).unwrap_or(Base::Unknown),
        container: param.container,
        by_reference: param.by_reference,
        loose: param.loose,
    });
    Signature { name: name.clone(), public: *public, params: params.collect(), complete: *complete }
}
