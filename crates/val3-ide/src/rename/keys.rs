//! Literal keys of collections in code, for example `dIn["door"]`.

use std::collections::BTreeSet;

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::items;
use val3_analysis::items::{data, parse};
use val3_analysis::occurrences::{Occurrence, Symbol, occurrences};
use val3_analysis::pages::{escaped, is_bindings, unescaped};
use val3_analysis::xml::{Attribute, XmlElement};
use val3_lang::types::Container;
use val3_syntax::{TextRange, TextSize, TextSlice, decode_entities};

use super::RefactoringError;
use crate::FilePosition;
use crate::edit::{FileEdit, SourceChange};
use crate::hover::keys_of;
use crate::owner::owner;
use crate::references::uses;

/// Escaped quote in a JSON string: `"data": "sText[\"front\"]"`.
const JSON_QUOTE: &str = "\\\"";

/// A key of a collection and its range.
pub(super) struct KeyRange {
    project: Project,
    data: SmolStr,
    pub(super) key: String,
    pub(super) range: TextRange,
}

/// Index after the name of a container.
pub(crate) enum Index {
    /// A number, or a string literal.
    Literal {
        /// Number or key, with entities decoded.
        text: String,
        /// Range without quotes.
        range: TextRange,
        /// Range including quotes.
        whole: TextRange,
        /// Whether it has quotes.
        is_key: bool,
    },
    /// A computed index.
    Computed,
    /// No index.
    None,
}

/// Key of a collection at a position, in code or in a data file.
pub(super) fn key_at(db: &dyn Db, at: FilePosition) -> Option<KeyRange> {
    let project = owner(db, at.file)?;
    key_in_data(db, project, at).or_else(|| key_after_name(db, project, at))
}

fn key_in_data(db: &dyn Db, project: Project, at: FilePosition) -> Option<KeyRange> {
    let parse = parse(db, at.file);
    let holds = |element: &XmlElement<'_>| element.view().range().contains_inclusive(at.offset);
    let element = data::elements(parse.view()).find(holds)?;
    let decl = data::declaration(element).filter(|decl| decl.container == Container::Collection)?;
    let found = key_attributes(element).find(|found| found.range.contains_inclusive(at.offset))?;
    Some(KeyRange { project, data: decl.name, key: found.text().into_owned(), range: found.range })
}

fn key_attributes<'g>(element: XmlElement<'g>) -> impl Iterator<Item = Attribute<'g>> {
    element.elements().filter_map(|value| value.attribute("key"))
}

fn key_after_name(db: &dyn Db, project: Project, at: FilePosition) -> Option<KeyRange> {
    let text: &str = at.file.text(db);
    // The last name before the cursor.
    let before = occurrences(db, project, at.file).iter().rev().find(|found| found.range.end() <= at.offset)?;
    let (owner, name) = collection(db, before)?;
    match index(text, before.range.end()) {
        Index::Literal { text, range, is_key: true, .. } if range.contains_inclusive(at.offset) => {
            Some(KeyRange { project: owner, data: name.clone(), key: text, range })
        }
        _ => None,
    }
}

fn collection<'o>(db: &dyn Db, found: &'o Occurrence) -> Option<(Project, &'o SmolStr)> {
    let Symbol::Data(project, name) = &found.symbol else { return None };
    let item = items(db, *project).data.get(name)?;
    (item.decl.container == Container::Collection).then_some((*project, name))
}

/// Index in the brackets after a name, in code, in a father reference, or in the bindings of a page.
pub(crate) fn index(text: &str, end: TextSize) -> Index {
    let rest = text.part(usize::from(end)..);
    let is_blank = [' ', '\t'];
    let Some(inside) = rest.trim_start_matches(is_blank).strip_prefix('[') else { return Index::None };
    let inside = inside.trim_start_matches(is_blank);
    let quote = ["\"", "&quot;", JSON_QUOTE].into_iter().find(|quote| inside.starts_with(quote));
    let literal = quote.and_then(|quote| {
        let (key, behind) = inside.strip_prefix(quote)?.split_once(quote)?;
        behind.trim_start_matches(is_blank).starts_with(']').then_some((quote, key))
    });
    let start = end + TextSize::of(rest) - TextSize::of(inside);
    let Some((quote, key)) = literal else { return number(inside, start) };
    let shown = match quote {
        "\"" => key.to_owned(),
        JSON_QUOTE => unescaped(key),
        _ => decode_entities(key).into_owned(),
    };
    let range = TextRange::at(start + TextSize::of(quote), TextSize::of(key));
    let whole = TextRange::new(start, range.end() + TextSize::of(quote));
    Index::Literal { text: shown, range, whole, is_key: true }
}

/// Number at the start of the text in brackets.
fn number(inside: &str, start: TextSize) -> Index {
    let digits = inside.trim_start_matches(|letter: char| letter.is_ascii_digit());
    let number = inside.strip_suffix(digits).unwrap_or("");
    if number.is_empty() || !digits.trim_start_matches([' ', '\t']).starts_with(']') {
        return Index::Computed;
    }
    let range = TextRange::at(start, TextSize::of(number));
    Index::Literal { text: number.to_owned(), range, whole: range, is_key: false }
}

/// Literal keys with which programs access the collection, in alphabetical order.
pub(crate) fn spelt_keys(db: &dyn Db, project: Project, name: &str) -> Vec<String> {
    let symbol = Symbol::Data(project, name.into());
    let keys = uses(db, &symbol).filter_map(|(file, _, range)| match index(file.text(db), range.end()) {
        Index::Literal { text, is_key: true, .. } => Some(text),
        _ => None,
    });
    keys.collect::<BTreeSet<String>>().into_iter().collect()
}

/// Renames a key to `new_key` at all literal uses.
pub(super) fn rename(db: &dyn Db, found: &KeyRange, new_key: &str) -> Result<SourceChange, RefactoringError> {
    check(db, found, new_key)?;
    let mut change = SourceChange::default();
    let symbol = Symbol::Data(found.project, found.data.clone());
    for (file, _, range) in uses(db, &symbol) {
        match index(file.text(db), range.end()) {
            Index::Literal { text, range, is_key: true, .. } if text == found.key => {
                change.edits.push(edit(db, file, range, new_key));
            }
            Index::Computed | Index::Literal { is_key: false, .. } => {
                let reason = format!("`{}` is also accessed with computed keys", found.data);
                return Err(RefactoringError(reason));
            }
            Index::Literal { .. } | Index::None => {}
        }
    }
    if let Some(item) = items(db, found.project).data.get(&found.data) {
        let parse = parse(db, item.file);
        let mut elements = data::elements(parse.view());
        let element = elements.find(|element| element.value("name").as_deref() == Some(&*found.data));
        let keys = element.into_iter().flat_map(key_attributes).filter(|key| key.text() == found.key);
        change.edits.extend(keys.map(|key| edit(db, item.file, key.range, new_key)));
    }
    change.edits.sort_by_key(|edit| (edit.file.path(db).clone(), edit.range.start()));
    change.edits.dedup();
    Ok(change)
}

/// Edit that replaces the key at `range`.
fn edit(db: &dyn Db, file: File, range: TextRange, new_key: &str) -> FileEdit {
    let text = if is_bindings(db, file) { escaped(new_key) } else { new_key.to_owned() };
    FileEdit { file, range, text }
}

fn check(db: &dyn Db, found: &KeyRange, new_key: &str) -> Result<(), RefactoringError> {
    if new_key.is_empty() || new_key.contains(['"', '\'', '&', '<', '>', ']', '\r', '\n']) {
        return Err(RefactoringError(format!(
            "`{new_key}` is no key: some text without quotes, brackets, `&`, `<` and `>`"
        )));
    }
    if keys_of(db, found.project, &found.data).iter().any(|key| key == new_key) {
        return Err(RefactoringError(format!("`{}` has the key `{new_key}` already", found.data)));
    }
    Ok(())
}
