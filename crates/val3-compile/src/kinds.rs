//! Run-time types, created once and shared.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::db::{Db, FileRange, Project};
use val3_analysis::items::data::{self, DataDecl};
use val3_analysis::items::parse;
use val3_analysis::items::project::{data_files, items, resolve_type};
use val3_analysis::ty::Base;
use val3_bytecode::LinkTarget;
use val3_lang::memory::{FieldKind, ValueType};
use val3_lang::types::Arm;

use crate::data::{Loaded, LoadedLink, detach_fathers, fits};
use crate::error::{CompileLimit, DataError, Result, there};

/// Types of a project.
pub(crate) struct Kinds<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) arm: Option<Arm>,
    builtin: FxHashMap<Base, Arc<ValueType>>,
    user: FxHashMap<Project, UserKind>,
    /// User types in creation. A type that contains itself is an error of the project.
    open: Vec<Project>,
}

/// A user type.
#[derive(Clone)]
struct UserKind {
    kind: Arc<ValueType>,
    bases: Vec<Base>,
    /// Initial links in each new value: number of the field, and link within it.
    links: Arc<[(u32, LoadedLink)]>,
}

impl<'db> Kinds<'db> {
    pub(crate) fn new(db: &'db dyn Db, arm: Option<Arm>) -> Self {
        Self { db, arm, builtin: FxHashMap::default(), user: FxHashMap::default(), open: Vec::new() }
    }

    /// Returns a run-time type. Positions without an arm get the project's arm.
    pub(crate) fn kind(&mut self, base: Base) -> Result<Arc<ValueType>> {
        match base.on_arm(self.arm) {
            Base::Builtin(builtin, arm) => {
                let make = || Arc::new(ValueType::builtin(builtin, arm));
                Ok(self.builtin.entry(Base::Builtin(builtin, arm)).or_insert_with(make).clone())
            }
            Base::User(project) => Ok(self.user(project)?.kind),
            Base::Unknown => Err(CompileLimit::Unclear),
        }
    }

    /// Returns the field types of a user type, in order.
    pub(crate) fn field_bases(&mut self, base: Base) -> Result<Vec<Base>> {
        match base {
            Base::User(project) => Ok(self.user(project)?.bases),
            _ => Err(CompileLimit::Unclear),
        }
    }

    /// Returns the initial links in each new value of a type.
    pub(crate) fn links(&mut self, base: Base) -> Result<Arc<[(u32, LoadedLink)]>> {
        match base {
            Base::User(project) => Ok(self.user(project)?.links),
            _ => Ok(Arc::default()),
        }
    }

    fn user(&mut self, project: Project) -> Result<UserKind> {
        if let Some(known) = self.user.get(&project) {
            return Ok(known.clone());
        }
        if self.open.contains(&project) {
            return Err(CompileLimit::Unclear);
        }
        self.open.push(project);
        let made = self.make(project);
        self.open.pop();
        let made = made?;
        self.user.insert(project, made.clone());
        Ok(made)
    }

    /// Creates a user type: its fields are the public data of its project, with their initial values (7.1). Initial
    /// fathers are ignored, because fields have no reference until a program or a variable's file sets one (7.3).
    fn make(&mut self, project: Project) -> Result<UserKind> {
        let (mut fields, mut bases, mut links) = (Vec::new(), Vec::new(), Vec::new());
        for (decl, base, Loaded { mut init, links: found }) in
            self.data_of(project, |decl| decl.public).map_err(|error| error.limit)?
        {
            let number = u32::try_from(fields.len()).map_err(|_| CompileLimit::Items)?;
            detach_fathers(&mut init);
            let kept = found.into_iter().filter(|found| !matches!(found.target, LinkTarget::Father(_)));
            links.extend(kept.map(|found| (number, found)));
            fields.push(FieldKind { name: decl.name.to_string(), init });
            bases.push(base);
        }
        let name = Base::User(project).display(self.db).to_string();
        Ok(UserKind { kind: Arc::new(ValueType::user(name, fields)), bases, links: links.into() })
    }

    /// Loads the selected data of a project, in file order. If a name is declared twice, the first declaration counts.
    /// Data with a missing type are omitted.
    ///
    /// # Errors
    /// A limit that one of the data or their total size exceeds.
    pub(crate) fn data_of(
        &mut self,
        project: Project,
        wanted: impl Fn(&DataDecl) -> bool,
    ) -> std::result::Result<Vec<(DataDecl, Base, Loaded)>, DataError> {
        let (db, types) = (self.db, &items(self.db, project).types);
        let (mut all, mut known, mut total) = (Vec::new(), FxHashSet::default(), 0u64);
        for &file in data_files(db, project) {
            for element in data::elements(parse(db, file).view()) {
                let Some(decl) = data::declaration(element).filter(|decl| wanted(decl)) else { continue };
                if known.insert(decl.name.clone()) {
                    let base = resolve_type(types, &decl.type_name).unwrap_or(Base::Unknown);
                    let loaded = there(self.load(element, decl.container, &decl.sizes, base));
                    let bytes = loaded.as_ref().ok().and_then(Option::as_ref).map_or(0, |loaded| loaded.init.bytes());
                    total = total.saturating_add(bytes);
                    let loaded = fits(total).and(loaded).map_err(|limit| {
                        let range = element.name_range();
                        DataError { limit, datum: Some((decl.name.clone(), FileRange { file, range })) }
                    })?;
                    all.extend(loaded.map(|loaded| (decl, base, loaded)));
                }
            }
        }
        Ok(all)
    }
}
