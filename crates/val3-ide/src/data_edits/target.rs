//! The edited text, with the project's declarations.

use std::cell::RefCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::data;
use val3_analysis::items::project::{Items, items};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_analysis::xml::{self, XmlElement};
use val3_data::SavedField;
use val3_syntax::characters::is_allowed;
use val3_syntax::view::View;

use super::edit::refusal;
use super::initial;
use crate::data_tables::{DataProblem, Dialect};
use crate::rename::{name_fault, other_item};

/// Maximum number of values, which exceeds the memory of any controller.
const MOST_VALUES: u32 = 1_000_000;

/// A data file after some of the edits.
pub(super) struct DataFile<'a> {
    pub(super) db: &'a dyn Db,
    pub(super) project: Project,
    pub(super) items: &'a Items,
    pub(super) dialect: Dialect,
    pub(super) text: &'a str,
    pub(super) root: XmlElement<'a>,
    file: File,
    declared: FxHashMap<String, Vec<XmlElement<'a>>>,
    initial: RefCell<FxHashMap<Project, Rc<[SavedField]>>>,
}

impl<'a> DataFile<'a> {
    pub(super) fn new(
        db: &'a dyn Db,
        project: Project,
        file: File,
        text: &'a str,
        view: View<'a>,
    ) -> Result<Self, DataProblem> {
        let root = xml::root(view).ok_or_else(|| refusal("the file is no data file"))?;
        let dialect = match root.name() {
            "Database" => Dialect::New,
            "dataList" => Dialect::Old,
            name => return Err(refusal(format!("the file is no data file: its root is `{name}`"))),
        };
        let mut declared: FxHashMap<String, Vec<XmlElement<'a>>> = FxHashMap::default();
        for element in data::elements(view) {
            if let Some(name) = element.value("name") {
                declared.entry(name.into_owned()).or_default().push(element);
            }
        }
        Ok(Self {
            db,
            project,
            items: items(db, project),
            dialect,
            text,
            root,
            file,
            declared,
            initial: RefCell::default(),
        })
    }

    /// XML element that declares a variable.
    pub(super) fn element(&self, name: &str) -> Result<XmlElement<'a>, DataProblem> {
        match self.declared.get(name).map_or(&[][..], Vec::as_slice) {
            [element] => Ok(*element),
            [] => Err(refusal(format!("the file declares no data called `{name}`"))),
            [_, second, ..] => Err(DataProblem {
                reason: format!("the file declares `{name}` twice; rename one of them in the text first"),
                range: second.attribute("name").map(|name| name.range),
            }),
        }
    }

    /// Fields of a new value of a type; empty for a built-in type.
    pub(super) fn initial_fields(&self, base: Base) -> Rc<[SavedField]> {
        let Base::User(owner) = base else { return Rc::default() };
        let mut known = self.initial.borrow_mut();
        Rc::clone(known.entry(owner).or_insert_with(|| initial::fields(self.db, owner).into()))
    }

    /// Checks that the name is valid and unused in the project.
    pub(super) fn check_new_name(&self, name: &str) -> Result<(), DataProblem> {
        if let Some(fault) = name_fault(name, Some(self.items.version)) {
            return Err(refusal(fault));
        }
        let is_stale = self.items.data.get(name).is_some_and(|item| item.file == self.file);
        let symbol = Symbol::Data(self.project, name.into());
        let taken = match self.declared.contains_key(name) {
            true => Some("data"),
            false if is_stale => None,
            false => other_item(self.db, self.project, &symbol, name),
        };
        taken.map_or(Ok(()), |what| Err(refusal(format!("there is already {what} called `{name}`"))))
    }

    /// Checks that the version allows an array of these sizes.
    pub(super) fn check_sizes(&self, sizes: &[u32]) -> Result<(), DataProblem> {
        let dimensions = if self.items.version.has_collections() && self.dialect == Dialect::New { 3 } else { 1 };
        if sizes.is_empty() || sizes.len() > dimensions {
            let allowed = if dimensions == 1 { "one dimension" } else { "one to three dimensions" };
            return Err(refusal(format!("an array has {allowed} in this version")));
        }
        if sizes.contains(&0) {
            return Err(refusal("an array has one value at least"));
        }
        let limit = self.items.version.container_limit().unwrap_or(MOST_VALUES);
        let count = sizes.iter().try_fold(1u32, |count, size| count.checked_mul(*size));
        match count.filter(|count| *count <= limit) {
            Some(_) => Ok(()),
            None => Err(refusal(format!("an array has {limit} values at most in this version"))),
        }
    }
}

/// Checks that XML can represent the text.
pub(super) fn check_text(text: &str) -> Result<(), DataProblem> {
    match text.chars().find(|character| !is_allowed(*character)) {
        Some(character) => {
            Err(refusal(format!("the character U+{:04X} cannot be written in the file", u32::from(character))))
        }
        None => Ok(()),
    }
}
