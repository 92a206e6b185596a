//! The compiled project: numbers of its data and programs, and imported library items.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::add_on_programs::{self, AddOnProgram};
use val3_analysis::body::Expr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{Items, items, signature};
use val3_bytecode::{Image, Import, ImportKind};

use crate::code_form::CodeForm;
use crate::error::{CompileLimit, Result, there};
use crate::kinds::Kinds;
use crate::layout::{FrameLayout, LayoutRequest};

/// State that all programs of a project share.
pub(crate) struct CompileUnit<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) project: Project,
    pub(crate) items: &'db Items,
    pub(crate) kinds: Kinds<'db>,
    data: FxHashMap<SmolStr, u16>,
    programs: FxHashMap<SmolStr, u16>,
    libraries: FxHashMap<SmolStr, u16>,
    /// Form of the code.
    pub(crate) form: CodeForm,
    /// Program whose layout is recorded.
    pub(crate) layout: Option<LayoutRequest<'db>>,
    /// Layout of this program, after its compilation.
    pub(crate) recorded_layout: Option<FrameLayout>,
    /// Library items in use.
    pub(crate) imports: Vec<Import>,
    imported: FxHashMap<(u16, SmolStr), u16>,
}

impl<'db> CompileUnit<'db> {
    /// Creates the state of a project whose data and programs have these names, in order.
    pub(crate) fn new<'n>(
        kinds: Kinds<'db>,
        project: Project,
        data: impl Iterator<Item = &'n SmolStr>,
        programs: impl Iterator<Item = &'n SmolStr>,
    ) -> Result<Self> {
        let db = kinds.db;
        let items = items(db, project);
        let add_ons = add_on_programs::libraries(db, project);
        let aliases = manifest(db, project.manifest(db)).libraries.iter().map(|entry| &entry.alias);
        let aliases = aliases.chain(add_ons.iter().map(|library| &library.alias));
        Ok(Self {
            db,
            project,
            items,
            kinds,
            data: numbered(data)?,
            programs: numbered(programs)?,
            libraries: numbered(aliases)?,
            form: CodeForm::default(),
            layout: None,
            recorded_layout: None,
            imports: Vec::new(),
            imported: FxHashMap::default(),
        })
    }

    /// Assigns to library items the numbers that they have in an image of the project.
    pub(crate) fn adopt_imports(&mut self, image: &Image) {
        for (number, import) in (0u16..).zip(&image.imports) {
            let name = match import.kind {
                ImportKind::Data(..) => SmolStr::from(&import.name),
                ImportKind::Program(_) => program_key(&import.name),
                ImportKind::Missing => continue,
            };
            self.imported.insert((import.library, name), number);
        }
        self.imports.clone_from(&image.imports);
    }

    /// Returns the number of global data.
    pub(crate) fn data(&self, name: &str) -> Option<u16> {
        self.data.get(name).copied()
    }

    /// Returns the number of a program in the project.
    pub(crate) fn program(&self, name: &str) -> Result<u16> {
        self.programs.get(name).copied().ok_or(CompileLimit::Unclear)
    }

    /// Returns the number of a library identifier.
    pub(crate) fn library(&self, alias: &str) -> Result<u16> {
        self.libraries.get(alias).copied().ok_or(CompileLimit::Unclear)
    }

    /// Returns the project with the interface of a library identifier.
    pub(crate) fn interface(&self, alias: &str) -> Result<Project> {
        self.items.libraries.get(alias).and_then(|item| item.interface).ok_or(CompileLimit::Unclear)
    }

    /// Returns the program that an expression names.
    pub(crate) fn callee(&self, callee: &Expr) -> Option<(Project, File)> {
        match callee {
            Expr::Name(name) => self.items.programs.get(name).map(|file| (self.project, *file)),
            Expr::Path { library, item } => {
                let interface = self.interface(library).ok()?;
                items(self.db, interface).programs.get(item).map(|file| (interface, *file))
            }
            _ => None,
        }
    }

    /// Returns the import number of a library's data.
    pub(crate) fn import_data(&mut self, alias: &str, name: &SmolStr) -> Result<u16> {
        let library = self.library(alias)?;
        if let Some(known) = self.imported.get(&(library, name.clone())) {
            return Ok(*known);
        }
        let interface = self.interface(alias)?;
        let item = items(self.db, interface).data.get(name).ok_or(CompileLimit::Unclear)?;
        let kind = self.kinds.kind(item.base)?;
        self.import(library, name, ImportKind::Data(kind, item.decl.container))
    }

    /// Returns the import number of data that the library's interface does not contain.
    pub(crate) fn import_missing(&mut self, alias: &str, name: &SmolStr) -> Result<u16> {
        let library = self.library(alias)?;
        self.import(library, name, ImportKind::Missing)
    }

    /// Returns the import number of a library's program.
    pub(crate) fn import_program(
        &mut self,
        alias: &str,
        name: &SmolStr,
        interface: Project,
        file: File,
    ) -> Result<u16> {
        let library = self.library(alias)?;
        let key = program_key(name);
        if let Some(known) = self.imported.get(&(library, key.clone())) {
            return Ok(*known);
        }
        let params = signature(self.db, interface, file).params.iter();
        let params = params.map(|param| Ok((self.kinds.kind(param.base)?, param.container, param.by_reference)));
        let kind = ImportKind::Program(params.collect::<Result<_>>()?);
        let number = self.import(library, name, kind)?;
        self.imported.insert((library, key), number);
        Ok(number)
    }

    /// Imports all items in the libraries' interfaces, because a loaded library must contain them (6.6).
    pub(crate) fn import_interfaces(&mut self) -> Result<()> {
        let aliases = manifest(self.db, self.project.manifest(self.db)).libraries.iter().map(|entry| &entry.alias);
        for alias in aliases {
            let Ok(interface) = self.interface(alias) else { continue };
            let promised = items(self.db, interface);
            let data = promised.data.iter().filter(|(_, item)| item.decl.public).map(|(name, _)| name);
            for name in sorted(data) {
                there(self.import_data(alias, name))?;
            }
            for name in sorted(promised.programs.keys()) {
                if let Some(file) = promised.programs.get(name) {
                    self.import_public(alias, name, interface, *file)?;
                }
            }
        }
        self.import_add_on_programs()
    }

    /// Imports the programs that replace instructions, including programs that only a debugger calls.
    fn import_add_on_programs(&mut self) -> Result<()> {
        for AddOnProgram { library, name, file } in add_on_programs::programs(self.db, self.project) {
            if library.project != self.project {
                self.import_public(&library.alias, &name, library.project, file)?;
            }
        }
        Ok(())
    }

    fn import_public(&mut self, alias: &str, name: &SmolStr, interface: Project, file: File) -> Result<()> {
        if !signature(self.db, interface, file).public {
            return Ok(());
        }
        there(self.import_program(alias, name, interface, file)).map(drop)
    }

    fn import(&mut self, library: u16, name: &SmolStr, kind: ImportKind) -> Result<u16> {
        let number = u16::try_from(self.imports.len()).map_err(|_| CompileLimit::Containers)?;
        if matches!(kind, ImportKind::Data(..)) {
            self.imported.insert((library, name.clone()), number);
        }
        self.imports.push(Import { library, name: name.to_string(), kind });
        Ok(number)
    }

    /// Whether the interface of a library identifier exists and contains this item.
    pub(crate) fn has_item(&self, library: &str, item: &str) -> bool {
        self.interface(library).is_ok_and(|interface| {
            let items = items(self.db, interface);
            items.data.contains_key(item) || items.programs.contains_key(item)
        })
    }
}

/// Returns the key of a library's program, which may have the same name as data.
fn program_key(name: &str) -> SmolStr {
    SmolStr::from(format!("{name}()"))
}

/// Sorts names alphabetically, because the order in hash tables varies.
fn sorted<'n>(names: impl Iterator<Item = &'n SmolStr>) -> Vec<&'n SmolStr> {
    let mut names: Vec<_> = names.collect();
    names.sort_unstable();
    names
}

/// Numbers names. If a name occurs twice, the first one counts.
fn numbered<'n>(names: impl Iterator<Item = &'n SmolStr>) -> Result<FxHashMap<SmolStr, u16>> {
    let mut numbers = FxHashMap::default();
    for (number, name) in names.enumerate() {
        let number = u16::try_from(number).map_err(|_| CompileLimit::Items)?;
        numbers.entry(name.clone()).or_insert(number);
    }
    Ok(numbers)
}
