//! Context of a position in the XML of a project, data or program file.

use camino::Utf8Path;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::{items, resolve_type};
use val3_analysis::ty::Base;
use val3_lang::files::FileKind;
use val3_lang::types::{Arm, BaseType};
use val3_syntax::{TextRange, TextSize};

use crate::xml_cursor::{Tag, XmlCursor, XmlPlace};

/// A position in the XML of a file.
pub(crate) struct XmlContext<'t> {
    pub(crate) file: FileKind,
    pub(crate) cursor: XmlCursor<'t>,
}

impl<'t> XmlContext<'t> {
    /// Context at `offset` of a file, and the range of the name or value there.
    pub(crate) fn at(db: &'t dyn Db, file: File, offset: TextSize) -> Option<(Self, TextRange)> {
        let cursor = XmlCursor::at(file.text(db), offset)?;
        let range = match &cursor.place {
            XmlPlace::Content(range) | XmlPlace::ElementName(range) | XmlPlace::EndTag(range) => *range,
            XmlPlace::AttributeName(range) | XmlPlace::Value(_, range) => *range,
        };
        let root = cursor.open.first().or(cursor.tag.as_ref()).map_or("", |root| root.name);
        let file = kind_of_root(root).or_else(|| kind_of_path(file.path(db)))?;
        Some((Self { file, cursor }, range))
    }

    /// Name of the innermost element around the position.
    pub(crate) fn parent(&self) -> &'t str {
        self.cursor.parent().map_or("", |parent| parent.name)
    }

    /// Declarations around the position, innermost first, each with its parent element's name.
    pub(crate) fn declarations(&self) -> impl Iterator<Item = (&Tag<'t>, &'t str)> {
        let around: Vec<&Tag<'t>> = self.cursor.around().collect();
        let parents = around.iter().skip(1).map(|parent| parent.name).chain([""]).collect::<Vec<_>>();
        around.into_iter().zip(parents).filter(|(tag, parent)| type_name(tag, parent).is_some())
    }

    /// Types of the data, fields, parameters or locals around the position, innermost first.
    pub(crate) fn types(&self) -> impl Iterator<Item = &'t str> {
        self.declarations().filter_map(|(tag, parent)| type_name(tag, parent))
    }

    /// Type of the innermost declaration around the position.
    pub(crate) fn base(&self, db: &dyn Db, project: Project) -> Option<Base> {
        resolve_type(&items(db, project).types, self.types().next()?)
    }

    /// Built-in type of the values here, with its arm kind.
    pub(crate) fn builtin(&self, db: &dyn Db, project: Project) -> Option<(BaseType, Option<Arm>)> {
        match self.base(db, project)? {
            Base::Builtin(ty, arm) => Some((ty, arm.or(items(db, project).arm))),
            _ => None,
        }
    }
}

/// Type that a tag names. In the old dialect, an element in a `…Section` has its type's name.
fn type_name<'t>(tag: &Tag<'t>, parent: &str) -> Option<&'t str> {
    tag.value("type").or_else(|| parent.ends_with("Section").then_some(tag.name)).filter(|name| !name.is_empty())
}

fn kind_of_root(root: &str) -> Option<FileKind> {
    match root {
        "Project" | "project" => Some(FileKind::Project),
        "Database" | "dataList" => Some(FileKind::Data),
        "Programs" | "programList" => Some(FileKind::Program),
        _ => None,
    }
}

fn kind_of_path(path: &Utf8Path) -> Option<FileKind> {
    match path.extension()?.to_ascii_lowercase().as_str() {
        "pjx" => Some(FileKind::Project),
        "dtx" => Some(FileKind::Data),
        "pgx" => Some(FileKind::Program),
        _ => None,
    }
}
