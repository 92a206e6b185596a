//! Elements that declare the parameters and locals of a program.

use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_analysis::items::program::{self, Header, header};
use val3_lang::types::Container;
use val3_syntax::xml::{XmlElement, indentation, line_end};
use val3_syntax::{TextRange, TextSize, text_at};

use super::attributes;
use super::slots::{ListSlot, Removal, SlotEdit, Slots};
use super::variables::{NewLocal, NewParameter, NewVariables};
use crate::RefactoringError;
use crate::declare::{self, NewVariable};
use crate::edit::FileEdit;
use crate::xml_list::whole_line;

/// Edits of the program header in `file`.
///
/// # Errors
/// If the file has no suitable element for the declarations.
pub(super) fn edits(db: &dyn Db, file: File, wanted: &NewVariables) -> Result<Vec<FileEdit>, RefactoringError> {
    let parse = parse(db, file);
    let Some(program) = program::element(parse.view()) else { return Ok(Vec::new()) };
    let header = header(db, file);
    let is_old = declare::is_old_program(db, file);
    let declarations = Declarations { db, file, text: file.text(db), is_old };
    let params: Vec<XmlElement<'_>> = program::params(program).collect();
    let locals: Vec<XmlElement<'_>> = program::locals(program).collect();
    let mut edits = declarations.list(program, &params, &parameters(&declarations, &params, header, wanted), true)?;
    edits.extend(declarations.list(program, &locals, &locals_of(&declarations, &locals, header, wanted), false)?);
    Ok(edits.into_iter().map(|(range, text)| FileEdit { file, range, text }).collect())
}

/// A list after the change.
struct NewList {
    /// Elements in their new order.
    order: Vec<ListSlot>,
    /// Edits inside the remaining elements.
    inner: Vec<SlotEdit>,
}

fn parameters(of: &Declarations<'_>, old: &[XmlElement<'_>], header: &Header, wanted: &NewVariables) -> NewList {
    let slots = wanted.parameters.iter().map(|new| match new.from {
        Some(index) => ListSlot::Kept(index),
        None => ListSlot::Added(declare::parameter_entry(of.is_old, &variable(new), new.by_reference)),
    });
    let inner = wanted.parameters.iter().filter_map(|new| {
        let index = new.from?;
        Some(attributes::of_parameter(of.text, *old.get(index)?, header.params.get(index)?, new))
    });
    NewList { order: slots.collect(), inner: sorted(inner.flatten()) }
}

fn locals_of(of: &Declarations<'_>, old: &[XmlElement<'_>], header: &Header, wanted: &NewVariables) -> NewList {
    let slots = wanted.locals.iter().map(|new| match new.from {
        Some(index) => ListSlot::Kept(index),
        None => ListSlot::Added(declare::local_entry(of.is_old, &local_variable(new))),
    });
    let inner = wanted.locals.iter().filter_map(|new| {
        let index = new.from?;
        Some(attributes::of_local(of.text, *old.get(index)?, header.locals.get(index)?, new))
    });
    NewList { order: slots.collect(), inner: sorted(inner.flatten()) }
}

fn sorted(edits: impl Iterator<Item = SlotEdit>) -> Vec<SlotEdit> {
    let mut edits: Vec<SlotEdit> = edits.collect();
    edits.sort_by_key(|(range, _)| range.start());
    edits
}

fn variable(new: &NewParameter) -> NewVariable {
    // The number of sizes is the number of dimensions; files do not contain the sizes of parameters.
    let sizes = match new.container {
        Container::Element => vec![1],
        Container::Array { dims } => vec![2; usize::from(dims)],
        Container::Collection => Vec::new(),
    };
    NewVariable { name: new.name.clone(), type_name: new.type_name.clone(), container: new.container, sizes }
}

fn local_variable(new: &NewLocal) -> NewVariable {
    let container = Container::Array { dims: u8::try_from(new.sizes.len()).unwrap_or(1) };
    NewVariable { name: new.name.clone(), type_name: new.type_name.clone(), container, sizes: new.sizes.clone() }
}

/// The file whose declarations change.
struct Declarations<'a> {
    db: &'a dyn Db,
    file: File,
    text: &'a str,
    is_old: bool,
}

impl Declarations<'_> {
    fn list(
        &self,
        program: XmlElement<'_>,
        old: &[XmlElement<'_>],
        new: &NewList,
        of_parameters: bool,
    ) -> Result<Vec<SlotEdit>, RefactoringError> {
        let NewList { order, inner } = new;
        let Some(first) = old.first() else { return self.first_entries(order, of_parameters) };
        let entries: Vec<TextRange> = old.iter().map(|element| element.view().range()).collect();
        if order.is_empty()
            && let Some(edit) = self.emptied(program, &entries)
        {
            return Ok(vec![edit]);
        }
        let indentation = indentation(self.text, first.view().range().start());
        let separator = indentation.map_or_else(String::new, |blanks| format!("{}{blanks}", line_end(self.text)));
        let slots = Slots { text: self.text, entries: &entries, inner, separator: &separator, removal: Removal::Line };
        Ok(slots.edits(order))
    }

    /// Edits that fill an empty or missing list.
    fn first_entries(&self, order: &[ListSlot], of_parameters: bool) -> Result<Vec<SlotEdit>, RefactoringError> {
        let entries: Vec<String> = order.iter().filter_map(ListSlot::added).map(str::to_owned).collect();
        if entries.is_empty() {
            return Ok(Vec::new());
        }
        let edit = match of_parameters {
            true => declare::into_parameters(self.db, self.file, &entries),
            false => declare::into_locals(self.db, self.file, &entries),
        };
        let FileEdit { range, mut text, .. } = edit.ok_or("the file has no place for declarations")?;
        // The trailing whitespace in an empty tag is kept, because it shows later that the tag was empty.
        if let Some(tag) = self.slice(range).strip_suffix("/>") {
            text = text.replacen(tag.trim_end(), tag, 1);
        }
        Ok(vec![(range, text)])
    }

    /// Edit for a list that loses all elements. Empty lists are omitted, except in s5 and s6 and if the list was an
    /// empty tag. `None` if the list has other content.
    fn emptied(&self, program: XmlElement<'_>, entries: &[TextRange]) -> Option<SlotEdit> {
        let first = *entries.first()?;
        let list = program.elements().find(|list| list.view().range().contains_range(first))?;
        let (tag, whole) = (list.tag_range(), list.view().range());
        let content = self.slice(TextRange::new(tag.end(), whole.end())).rsplit_once("</")?.0;
        let end = tag.end() + TextSize::of(content);
        let starts = entries.iter().map(|entry| entry.start()).chain([end]);
        let mut gaps = std::iter::once(tag.end()).chain(entries.iter().map(|entry| entry.end())).zip(starts);
        if !gaps.all(|(from, to)| from <= to && self.slice(TextRange::new(from, to)).trim().is_empty()) {
            return None;
        }
        let start = self.slice(tag).strip_suffix('>')?;
        if self.is_old || start.ends_with([' ', '\t']) {
            let from = tag.start() + TextSize::of(start);
            return Some((TextRange::new(from, whole.end()), "/>".to_owned()));
        }
        Some((whole_line(self.text, whole), String::new()))
    }

    fn slice(&self, range: TextRange) -> &str {
        text_at(self.text, range)
    }
}
