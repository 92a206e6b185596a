//! Lookup of library items and of fields.

use smol_str::{SmolStr, format_smolstr};
use val3_lang::suggest::nearest;
use val3_lang::types::{self, Arm, BaseType};

use super::{NameResolver, Unresolved, data_value};
use crate::db::{File, FileRange, Project};
use crate::infer::value::InferredValue;
use crate::interfaces::is_left_out;
use crate::items::declarations;
use crate::items::project::{fields, items, signature};
use crate::problem::{NameKind, ProblemKind, RelatedRole};
use crate::test_applications::sees_private_items;
use crate::ty::Base;

impl NameResolver<'_> {
    /// Returns the interface project of a library identifier.
    pub(in crate::infer) fn interface(&self, library: &SmolStr) -> Result<Project, Unresolved> {
        if let Some(found) = self.items.libraries.get(library) {
            return found.interface.ok_or(Unresolved::Incomplete);
        }
        if self.items.incomplete {
            return Err(Unresolved::Incomplete);
        }
        let near = nearest(library, self.items.libraries.keys().map(SmolStr::as_str)).map(SmolStr::from);
        Err(Unresolved::fault(ProblemKind::UnknownLibrary { alias: library.clone(), near }))
    }

    /// Whether the project declares this library identifier.
    pub(in crate::infer) fn has_library(&self, library: &SmolStr) -> bool {
        self.items.libraries.contains_key(library)
    }

    /// Resolves `library:item` as a value.
    pub(in crate::infer) fn library_value(
        &self,
        library: &SmolStr,
        item: &SmolStr,
    ) -> Result<InferredValue, Unresolved> {
        let interface = self.interface(library)?;
        let items = items(self.db, interface);
        match items.data.get(item) {
            Some(found) if found.decl.may_be_public() || self.sees_private_items() => Ok(data_value(found)),
            Some(found) => {
                let declared = declarations::data(self.db, found.file, item.clone());
                Err(private_item(library, item, NameKind::Data, declared))
            }
            None if items.programs.contains_key(item) => {
                let name = format_smolstr!("{library}:{item}");
                Err(Unresolved::fault(ProblemKind::NotAValue { name, is: NameKind::Program }))
            }
            None if items.lacks_data || is_left_out(self.db, interface, item, NameKind::Data) => {
                Err(Unresolved::Incomplete)
            }
            None => {
                let public = items.data.iter().filter(|(_, item)| item.decl.public).map(|(name, _)| name.as_str());
                Err(self.unknown_item(library, item, NameKind::Data, nearest(item, public).map(SmolStr::from)))
            }
        }
    }

    /// Resolves `library:item` as a program.
    pub(in crate::infer) fn library_program(
        &self,
        library: &SmolStr,
        item: &SmolStr,
    ) -> Result<(Project, File), Unresolved> {
        let interface = self.interface(library)?;
        let items = items(self.db, interface);
        match items.programs.get(item) {
            None if items.may_have_program(item) => Err(Unresolved::Incomplete),
            None if is_left_out(self.db, interface, item, NameKind::Program) => Err(Unresolved::Incomplete),
            Some(file) if signature(self.db, interface, *file).public || self.sees_private_items() => {
                Ok((interface, *file))
            }
            Some(file) => {
                let declared = declarations::program(self.db, *file);
                Err(private_item(library, item, NameKind::Program, declared))
            }
            None => {
                let near = nearest(item, items.programs.keys().map(SmolStr::as_str)).map(SmolStr::from);
                Err(self.unknown_item(library, item, NameKind::Program, near))
            }
        }
    }

    fn sees_private_items(&self) -> bool {
        sees_private_items(self.db, self.project)
    }

    fn unknown_item(&self, library: &SmolStr, item: &SmolStr, what: NameKind, near: Option<SmolStr>) -> Unresolved {
        let declared = declarations::library(self.db, self.project, library.clone());
        let kind = ProblemKind::LibraryItemUnknown { alias: library.clone(), item: item.clone(), what, near };
        Unresolved::fault_with(kind, RelatedRole::Interface, declared)
    }

    /// Resolves a field of the user type that `project` declares.
    pub(in crate::infer) fn user_field(&self, project: Project, field: &SmolStr) -> Result<InferredValue, Unresolved> {
        let fields = fields(self.db, project);
        if let Some(item) = fields.get(field) {
            return Ok(data_value(item));
        }
        let items = items(self.db, project);
        if items.lacks_data {
            return Err(Unresolved::Incomplete);
        }
        let near = nearest(field, fields.keys().map(SmolStr::as_str)).map(SmolStr::from);
        let private = items.data.get(field).and_then(|item| declarations::data(self.db, item.file, field.clone()));
        Err(self.unknown_field(Base::User(project), field, near, private))
    }

    /// Returns the type of a built-in type's field.
    pub(in crate::infer) fn builtin_field(
        &self,
        ty: BaseType,
        arm: Option<Arm>,
        field: &SmolStr,
    ) -> Result<Base, Unresolved> {
        let known_arm = arm.or(self.arm());
        match types::field(ty, known_arm, field) {
            Some(found) => Ok(Base::Builtin(found.ty, known_arm.filter(|_| found.ty.depends_on_arm()))),
            None => {
                let near =
                    nearest(field, types::fields(ty, known_arm).iter().map(|field| field.name)).map(SmolStr::from);
                Err(self.unknown_field(Base::Builtin(ty, arm), field, near, None))
            }
        }
    }

    fn unknown_field(
        &self,
        base: Base,
        field: &SmolStr,
        near: Option<SmolStr>,
        private: Option<FileRange>,
    ) -> Unresolved {
        let kind = ProblemKind::UnknownField { ty: self.show(base), field: field.clone(), near };
        Unresolved::fault_with(kind, RelatedRole::Declared, private)
    }
}

fn private_item(library: &SmolStr, item: &SmolStr, what: NameKind, declared: Option<FileRange>) -> Unresolved {
    let kind = ProblemKind::LibraryItemPrivate { alias: library.clone(), item: item.clone(), what };
    Unresolved::fault_with(kind, RelatedRole::Declared, declared)
}
