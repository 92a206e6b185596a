//! Tracks libraries that could not be loaded, to explain errors in lines that use them.

use std::collections::BTreeMap;

use val3_files::FileClass;
use val3_lang::library_errors::{self, INTERFACE_DIFFERS};
use val3_machine::event::{Event, EventKind};
use val3_syntax::encoding::decode;
use val3_view::code_of_line;

/// Unloaded libraries by alias: the path, and the result code of `libLoad`.
#[derive(Debug, Default)]
pub(super) struct MissingLibraries(BTreeMap<String, (String, u16)>);

impl MissingLibraries {
    /// Tracks load events, also of libraries that are loaded with the application.
    pub(super) fn follow(&mut self, event: &Event) {
        let EventKind::Lib { op: "load", alias, path, code } = &event.kind else { return };
        if *code < INTERFACE_DIFFERS {
            self.0.remove(alias);
        } else {
            self.0.insert(alias.clone(), (path.clone(), *code));
        }
    }

    /// Returns sentences about the missing libraries that a line of a file uses, or about all of them if the line
    /// cannot be read. A blank follows each sentence.
    pub(super) fn notes_for_line(&self, file: &str, line: u32) -> String {
        let code = code(file, line);
        let is_used = |alias: &str| code.as_ref().is_none_or(|code| code.contains(&format!("{alias}:")));
        let used = self.0.iter().filter(|(alias, _)| is_used(alias));
        used.map(|(alias, (path, code))| {
            let reason = library_errors::find(*code).map_or("unknown code", |error| error.short);
            format!("The library `{alias}` could not be loaded from `{path}`: code {code}, {reason}. ")
        })
        .collect()
    }
}

/// Reads the text of a program's file. `None` for a library that is not in a folder.
pub(super) fn program_text(file: &str) -> Option<String> {
    Some(decode(val3_files::read(file.into(), FileClass::Program).ok()?).text)
}

/// Returns the code of a line, from 1. `None` for a library that is not in a folder.
pub(super) fn code(file: &str, line: u32) -> Option<String> {
    code_of_line(&program_text(file)?, line)
}
