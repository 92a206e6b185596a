//! Applies a slip to the cell.

use val3_tests::cell::{APPLICATIONS, Cell, place_of, text_of};

use crate::mutations::mutation::{Edit, Mutation};

/// Mark of an expected line in a replacement.
const MARK: &str = "$0";

/// A cell with a slip in it.
pub(crate) struct Mutated {
    pub(crate) cell: Cell,
    /// Expected locations of the finding: file and line, from 1.
    pub(crate) expected: Vec<(String, usize)>,
}

/// Returns `cell` with the slip, or the fault in the slip's description.
pub(crate) fn apply(mutation: &Mutation, cell: &Cell) -> Result<Mutated, String> {
    let path = format!("{APPLICATIONS}{}", mutation.file);
    let index = cell.iter().position(|(known, _)| *known == path).ok_or_else(|| format!("no file {path}"))?;
    let mut cell = cell.clone();
    let mut expected = Vec::new();
    match mutation.edit {
        Edit::Remove => drop(cell.remove(index)),
        Edit::Replace { find, with } => {
            let (text, lines) = replace(&text_of(&cell, &path)?, find, with)?;
            expected = lines.into_iter().map(|line| (path.clone(), line)).collect();
            cell.iter_mut().filter(|(known, _)| *known == path).for_each(|(_, bytes)| *bytes = text.clone().into());
        }
    }
    if !mutation.places.is_empty() {
        let places = mutation.places.iter();
        expected = places.map(|(file, text)| place_of(&cell, file, text)).collect::<Result<_, _>>()?;
    }
    Ok(Mutated { cell, expected })
}

/// Returns the text with `find` replaced, and the lines of the marks in `with`.
fn replace(text: &str, find: &str, with: &str) -> Result<(String, Vec<usize>), String> {
    let (before, after) = text.split_once(find).ok_or_else(|| format!("{find:?} is not in the file"))?;
    if after.contains(find) {
        return Err(format!("{find:?} is in the file twice"));
    }
    let first = before.matches('\n').count() + 1;
    let mut lines: Vec<usize> =
        with.match_indices(MARK).map(|(at, _)| first + with.get(..at).unwrap_or("").matches('\n').count()).collect();
    if lines.is_empty() {
        lines.push(first);
    }
    let changed = format!("{before}{}{after}", with.replace(MARK, ""));
    if changed == text {
        return Err("the edit changes nothing".to_owned());
    }
    Ok((changed, lines))
}
