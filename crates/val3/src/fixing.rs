//! `val3 check --fix` and `--diff`: applies fixes to the loaded files of a session.

use std::sync::Arc;

use camino::Utf8Path;
use val3_analysis::db::Db;
use val3_check::diagnostic::Diagnostic;
use val3_check::fix::{FixTarget, FixedFile, TrialWorkspace};
use val3_files::{FileClass, replace_unchanged};
use val3_syntax::encoding::{Encoding, decode};

use crate::engine::Session;
use crate::user_error::UserError;

impl FixTarget for Session<'_> {
    type Error = UserError;

    fn findings(&mut self) -> Result<Vec<Diagnostic>, UserError> {
        Ok(self.check()?.diagnostics)
    }

    fn occurrences(&mut self) -> Result<Vec<Diagnostic>, UserError> {
        Ok(Session::occurrences(self)?.diagnostics)
    }
}

impl TrialWorkspace for Session<'_> {
    fn db(&self) -> &dyn Db {
        Session::db(self)
    }

    fn all_findings(&mut self) -> Vec<Diagnostic> {
        self.check_everything()
    }

    fn set_texts<'t>(&mut self, texts: impl Iterator<Item = (&'t Utf8Path, &'t Arc<str>)>) {
        Session::set_texts(self, texts);
    }
}

/// Writes the files. Each file is replaced completely or stays unchanged. Files outside of the paths that the command
/// names are never changed.
pub(crate) fn write(session: &Session<'_>, files: &[FixedFile]) -> Result<(), UserError> {
    let scope = session.write_scope();
    files.iter().try_for_each(|file| scope.check(&file.path, &session.paths().shown(&file.path)))?;
    for FixedFile { path, encoding, before, after } in files {
        let shown = session.paths().shown(path);
        let bytes = encoded(*encoding, after).ok_or_else(|| unencodable(&shown))?;
        replace_unchanged(path, FileClass::Program, &encoding.encode(before), &bytes).map_err(|reason| {
            UserError::new(format!("cannot write `{shown}`: {reason}"))
                .with_help("earlier files are fixed; this file and the following ones are not")
        })?;
    }
    Ok(())
}

/// Encodes the text; `None` if decoding would not return the same text.
pub(crate) fn encoded(encoding: Encoding, text: &str) -> Option<Vec<u8>> {
    let bytes = encoding.encode(text);
    let read = decode(bytes.clone());
    (read.text == text && read.encoding == encoding).then_some(bytes)
}

pub(crate) fn unencodable(path: &str) -> UserError {
    UserError::new(format!(
        "cannot write `{path}`: the new text contains a character that the encoding of the file does not support"
    ))
    .with_help("save it as UTF-8")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_that_would_be_decoded_differently_are_refused() {
        let declaration = "<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>";
        assert_eq!(encoded(Encoding::Latin1, &format!("{declaration}é")).unwrap().last(), Some(&0xE9));
        assert_eq!(encoded(Encoding::Latin1, &format!("{declaration}€")), None);
        assert_eq!(encoded(Encoding::Utf8, "€"), Some("€".as_bytes().to_vec()));
    }
}
