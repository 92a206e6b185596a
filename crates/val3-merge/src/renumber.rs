//! Renumbering of appended elements of theirs, and of references to them.

use val3_syntax::TextEdit;
use val3_syntax::xml::{Attribute, escaped};

use crate::node::MergeNode;
use crate::plan::{Append, Plan, Plans, moved, path_of};

/// Returns edits of theirs that set the indexes of the merged file. References in theirs to renumbered elements are
/// changed as well, so that the frame of a point is still the same frame.
pub(crate) fn edits(theirs: &MergeNode<'_>, plans: &Plans) -> Vec<TextEdit> {
    let mut appends: Vec<&Append> = plans.values().filter_map(Plan::append).collect();
    if appends.is_empty() {
        return Vec::new();
    }
    // Longest path first, because its indexes are the indexes of theirs.
    appends.sort_by(|one, other| (other.path.len(), &other.path).cmp(&(one.path.len(), &one.path)));
    let mut edits = Vec::new();
    node(theirs, "", &appends, &mut edits);
    edits.sort_by_key(|edit: &TextEdit| edit.range.start());
    edits
}

fn node(around: &MergeNode<'_>, path: &str, appends: &[&Append], edits: &mut Vec<TextEdit>) {
    for child in &around.children {
        let Some(element) = child.element else { continue };
        let path = path_of(path, child);
        let is_value = child.name().to_ascii_lowercase().starts_with("value");
        if let Some(append) = appends.iter().find(|append| append.path == path && !is_value) {
            container(child, append, edits);
        }
        if let Some(attribute) = element.attribute("fatherId") {
            edits.extend(reference(attribute, appends));
        }
        if let (Some(name), Some(index)) = (element.value("name"), element.attribute("fatherIndex")) {
            edits.extend(old_reference(&name, index, appends));
        }
        node(child, &path, appends, edits);
    }
}

fn container(child: &MergeNode<'_>, append: &Append, edits: &mut Vec<TextEdit>) {
    for (value, index) in moved(child, append) {
        if let Some(found) = value.key_name.and_then(|name| value.attribute(name)) {
            edits.push(TextEdit { range: found.range, text: joined(&index, ",") });
        }
    }
    if let Some(size) = child.attribute("size") {
        let mut sizes: Vec<String> = size.text().split_whitespace().map(str::to_owned).collect();
        if let Some(size) = sizes.get_mut(append.axis) {
            *size = append.size.to_string();
        }
        edits.push(TextEdit { range: size.range, text: sizes.join(" ") });
    }
}

/// Renumbers a reference: `fTray[3]`, `tSlot["a"].fPlace[3]`.
fn reference(attribute: Attribute<'_>, appends: &[&Append]) -> Option<TextEdit> {
    let old = attribute.text().into_owned();
    let mut text = old.clone();
    for append in appends {
        text = renumbered(&text, append).unwrap_or(text);
    }
    (text != old).then(|| TextEdit { range: attribute.range, text: escaped(&text) })
}

/// Returns the reference with its new index; `None` if it does not refer to a moved element.
fn renumbered(text: &str, append: &Append) -> Option<String> {
    let number = append.path.matches('[').count();
    let (open, _) = text.match_indices('[').nth(number)?;
    let (path, rest) = text.split_at_checked(open)?;
    let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
    let mut index: Vec<usize> = index.split(',').map(|number| number.trim().parse().ok()).collect::<Option<_>>()?;
    let at = index.get_mut(append.axis).filter(|at| **at >= append.from)?;
    *at += append.by;
    (path.replace('"', "") == append.path).then(|| format!("{path}[{}]{after}", joined(&index, ",")))
}

/// Renumbers a reference of the old dialect: `name="fTray" fatherIndex="3"`.
fn old_reference(name: &str, index: Attribute<'_>, appends: &[&Append]) -> Option<TextEdit> {
    let append = appends.iter().find(|append| append.path == name)?;
    let at = index.text().trim().parse::<usize>().ok().filter(|at| *at >= append.from)?;
    Some(TextEdit { range: index.range, text: (at + append.by).to_string() })
}

fn joined(numbers: &[usize], separator: &str) -> String {
    numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(separator)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_get_the_new_index() {
        let append = |path: &str, axis| Append { path: path.to_owned(), axis, from: 3, by: 2, count: 1, size: 6 };
        let tray = append("fTray", 0);
        assert_eq!(renumbered("fTray[3]", &tray).as_deref(), Some("fTray[5]"));
        assert_eq!(renumbered("fTray[2]", &tray), None);
        assert_eq!(renumbered("fTrays[3]", &tray), None);
        assert_eq!(renumbered("tA[1].fTray[3]", &tray), None);
        let nested = append("tA[home].fTray", 1);
        assert_eq!(renumbered("tA[\"home\"].fTray[1,4]", &nested).as_deref(), Some("tA[\"home\"].fTray[1,6]"));
    }
}
