//! The code of a line that a message is about.

use val3_files::FileClass;
use val3_syntax::encoding::decode;

/// The code of a line, from 1. A library that is not in a folder has none.
pub(super) fn code(file: &str, line: u32) -> Option<String> {
    let text = decode(val3_files::read(file.into(), FileClass::Program).ok()?).text;
    let code = text.lines().nth(usize::try_from(line).ok()?.checked_sub(1)?)?.trim();
    (!code.is_empty()).then(|| code.to_owned())
}
