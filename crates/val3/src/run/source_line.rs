//! Source code of a line for a message.

use val3_files::FileClass;
use val3_syntax::encoding::decode;

/// Returns the code of a line, from 1. `None` for a library that is not in a folder.
pub(super) fn code(file: &str, line: u32) -> Option<String> {
    let text = decode(val3_files::read(file.into(), FileClass::Program).ok()?).text;
    let code = text.lines().nth(usize::try_from(line).ok()?.checked_sub(1)?)?.trim();
    (!code.is_empty()).then(|| code.to_owned())
}
