//! Source line at which a test has failed.

use camino::Utf8Path;
use val3_files::FileClass;
use val3_suite::FailureLocation;
use val3_syntax::{decode_entities, encoding};

use crate::paths::has_extension;

/// Maximum number of displayed characters.
const LONGEST: usize = 160;

/// Start of code that is not escaped, in the first line of a program.
const CDATA: &str = "<![CDATA[";

/// Returns the text of the line, trimmed. `None` if the file can no longer be read, if the location is an entire file,
/// and for the head of a table in a scenario.
pub(super) fn source_line(place: &FailureLocation) -> Option<String> {
    let path = Utf8Path::new(&place.file);
    let is_program = has_extension(path, "pgx");
    let is_settings = has_extension(path, "toml");
    let class = if is_settings { FileClass::Settings } else { FileClass::Program };
    let bytes = val3_files::read(path, class).ok().filter(|_| is_program || is_settings)?;
    let text = encoding::decode(bytes).text;
    let line = text.lines().nth(place.line.checked_sub(1)? as usize)?;
    let is_escaped = is_program && !text.contains(CDATA);
    let line = if is_escaped { decode_entities(line) } else { line.into() };
    let line = line.trim();
    // The head of a table does not contain the expectation.
    let is_head = is_settings && line.starts_with('[');
    let end = line.char_indices().nth(LONGEST).map(|(end, _)| end);
    let shown = end.and_then(|end| line.get(..end)).map_or_else(|| line.to_owned(), |shown| format!("{shown}…"));
    (!is_head && !line.is_empty()).then_some(shown)
}
