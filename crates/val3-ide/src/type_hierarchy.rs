//! Type hierarchy of user types: the types of a type's fields, and the types with fields of a type.

use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::items::project::{fields, items, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;

use crate::FilePosition;
use crate::navigate::name_at;

/// A user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TypeItem {
    /// Type name, which is the name of the `.pjx`.
    pub name: String,
    /// The `.pjx`.
    pub file: File,
}

/// User type at a position: the named type, or the type of the named symbol. The fallback is the project itself if it
/// is a user type.
pub fn type_item(db: &dyn Db, at: FilePosition) -> Option<TypeItem> {
    let (project, found) = name_at(db, at)?;
    let of = match &found.symbol {
        Symbol::Type(owner, name) => items(db, *owner).types.get(name).copied().flatten(),
        Symbol::Data(owner, name) => items(db, *owner).data.get(name).and_then(|item| user(item.base)),
        _ => crate::navigate::type_definition(db, at).first().and_then(|target| project_of(db, target.to.file)),
    };
    of.or_else(|| is_type(db, project).then_some(project)).map(|project| item(db, project))
}

/// Types with a field of the given type.
pub fn supertypes(db: &dyn Db, of: File) -> Vec<TypeItem> {
    let Some(own) = project_of(db, of) else { return Vec::new() };
    let types = projects(db).into_iter().filter(|project| is_type(db, *project));
    let supertypes = types.filter(|ty| fields(db, *ty).values().any(|field| user(field.base) == Some(own)));
    supertypes.map(|project| item(db, project)).collect()
}

/// Types of a type's fields.
pub fn subtypes(db: &dyn Db, of: File) -> Vec<TypeItem> {
    let Some(own) = project_of(db, of) else { return Vec::new() };
    let mut found: Vec<Project> = fields(db, own).values().filter_map(|field| user(field.base)).collect();
    found.sort_unstable_by_key(|project| project.manifest(db).path(db));
    found.dedup();
    found.into_iter().map(|project| item(db, project)).collect()
}

fn user(base: Base) -> Option<Project> {
    if let Base::User(project) = base { Some(project) } else { None }
}

/// Whether a project uses it as a type.
fn is_type(db: &dyn Db, project: Project) -> bool {
    projects(db).into_iter().any(|other| {
        let types = &items(db, other).types;
        types.keys().any(|name| resolve_type(types, name) == Some(Base::User(project)))
    })
}

fn project_of(db: &dyn Db, manifest: File) -> Option<Project> {
    projects(db).into_iter().find(|project| project.manifest(db) == manifest)
}

fn projects(db: &dyn Db) -> Vec<Project> {
    let mut projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    projects
}

fn item(db: &dyn Db, project: Project) -> TypeItem {
    let file = project.manifest(db);
    TypeItem { name: file.path(db).file_stem().unwrap_or("").to_owned(), file }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::MarkedListing;

    const LISTING: &str = "type Rack \"Disk://Rack/Rack.pjx\"\nRack rA\nputln(r$0A.sName)\n--- Rack\ntype Slot \"Disk://Slot/Slot.pjx\"\npublic string sName\npublic Slot sSlot[3]\npublic Slot sOther\n--- Slot\npublic num nHeight\n";

    fn names(items: Vec<TypeItem>) -> Vec<String> {
        items.into_iter().map(|item| item.name).collect()
    }

    #[test]
    fn using_and_used_types_are_listed() {
        let marked = MarkedListing::new(LISTING);
        let rack = type_item(marked.db(), marked.at()).unwrap();
        assert_eq!(rack.name, "Rack");
        assert_eq!(names(subtypes(marked.db(), rack.file)), ["Slot"]);
        assert_eq!(names(supertypes(marked.db(), rack.file)), [] as [&str; 0]);
        let slot = subtypes(marked.db(), rack.file).remove(0);
        assert_eq!(names(supertypes(marked.db(), slot.file)), ["Rack"]);
    }

    #[test]
    fn other_names_have_no_type_hierarchy() {
        let marked = MarkedListing::new("num nA\nn$0A=1");
        assert_eq!(type_item(marked.db(), marked.at()), None);
    }
}
