//! Places and layout of elements that are inserted in ours.

use val3_syntax::xml::whole_line;
use val3_syntax::{TextEdit, TextRange, TextSize, TextSlice};

use crate::node::MergeNode;

/// Returns the line end and the indentation before an element; empty if another element precedes it on its line.
pub(crate) fn prefix<'t>(node: &MergeNode<'t>) -> &'t str {
    let before = node.source.part(..usize::from(node.range.start()));
    let blanks = before.len() - before.trim_end_matches([' ', '\t', '\r', '\n']).len();
    let blanks = before.part(before.len() - blanks..);
    let Some(start) = blanks.rfind('\n') else { return "" };
    let start = if blanks.get(..start).is_some_and(|before| before.ends_with('\r')) { start - 1 } else { start };
    blanks.part(start..)
}

/// Like [`prefix`], with another line end.
pub(crate) fn prefix_in(node: &MergeNode<'_>, line_end: &str) -> String {
    prefix(node).replace("\r\n", "\n").replace('\n', line_end)
}

/// Returns the text of an element from theirs with the line ends of ours and the indentation of `place` in ours.
pub(crate) fn adapted(theirs: &MergeNode<'_>, line_end: &str, place: Option<&str>) -> String {
    let text = theirs.text().replace("\r\n", "\n");
    let [from, to] =
        [prefix(theirs), place.unwrap_or_else(|| prefix(theirs))].map(|prefix| prefix.trim_start_matches(['\r', '\n']));
    // Code keeps its own indentation.
    let is_list = !text.contains("<![CDATA[") && from != to;
    let text = if is_list { text.replace(&format!("\n{from}"), &format!("\n{to}")) } else { text };
    text.replace('\n', line_end)
}

/// Inserts an element's text after an element of ours.
pub(crate) fn after(anchor: &MergeNode<'_>, text: &str) -> TextEdit {
    insert(anchor.range.end(), format!("{}{text}", prefix(anchor)))
}

/// Inserts a text before an element of ours.
pub(crate) fn before(anchor: &MergeNode<'_>, text: &str) -> TextEdit {
    let before = anchor.source.part(..usize::from(anchor.range.start()));
    let is_first = before.trim_start_matches('\u{feff}').is_empty();
    let separator = if is_first { anchor.line_end } else { prefix(anchor) };
    insert(anchor.range.start(), format!("{text}{separator}"))
}

/// Inserts the text of an element from theirs as the only element in `parent`.
pub(crate) fn inside(
    parent: &MergeNode<'_>,
    theirs_parent: &MergeNode<'_>,
    first: &MergeNode<'_>,
    text: &str,
) -> Vec<TextEdit> {
    let text = prefix_in(first, parent.line_end) + text;
    let is_on_own_line = prefix(first).contains('\n');
    let closing = match prefix(parent) {
        _ if !is_on_own_line => String::new(),
        "" => prefix_in(theirs_parent, parent.line_end),
        own => own.to_owned(),
    };
    match parent.content {
        // The blanks between the tags keep the end tag on a separate line.
        Some(content) if parent.slice(content).contains('\n') => vec![insert(content.start(), text)],
        Some(content) => vec![TextEdit { range: content, text: text + &closing }],
        None => {
            let range = parent.range;
            let tag = parent.text().trim_end_matches('>').trim_end_matches('/').trim_end();
            let slash = TextRange::new(range.start() + TextSize::of(tag), range.end());
            vec![TextEdit { range: slash, text: format!(">{text}{closing}</{}>", parent.name()) }]
        }
    }
}

/// Removes an element with its line.
pub(crate) fn removed(node: &MergeNode<'_>) -> TextEdit {
    TextEdit { range: whole_line(node.source, node.range), text: String::new() }
}

fn insert(at: TextSize, text: String) -> TextEdit {
    TextEdit { range: TextRange::empty(at), text }
}
