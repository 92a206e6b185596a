//! `val3 check --fix` and `--diff`: applies fixes round after round, until nothing changes.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use salsa::Setter as _;
use val3_analysis::db::{File, FileStatus};
use val3_check::fix::mend;
use val3_syntax::encoding::{Encoding, decode};

use crate::engine::{Outcomes, Session};
use crate::output::replace_file;
use crate::user_error::UserError;

/// Fixes that undo each other would go on for ever.
const ROUNDS: usize = 50;

/// What the fixes did, in memory.
pub(crate) struct Fixed {
    /// What is left.
    pub(crate) left: Outcomes,
    /// The files that changed, by path.
    pub(crate) files: Vec<FixedFile>,
    /// How many fixes were applied.
    pub(crate) mended: usize,
    /// Another round would change nothing.
    pub(crate) settled: bool,
}

/// A file before and after.
pub(crate) struct FixedFile {
    file: File,
    /// The path as people open it.
    pub(crate) path: String,
    /// The text as it was read.
    pub(crate) before: Arc<str>,
    /// The text with the fixes.
    pub(crate) after: Arc<str>,
}

/// Applies the safe fixes of what is found, and the guesses if `guesses` says so.
pub(crate) fn fix(session: &mut Session<'_>, guesses: bool) -> Result<Fixed, UserError> {
    let mut originals: FxHashMap<File, Arc<str>> = FxHashMap::default();
    let mut mended = 0;
    for _ in 0..ROUNDS {
        let left = session.check()?;
        let fixes = left.diagnostics.iter().filter_map(|diagnostic| diagnostic.fix.as_ref());
        let round = mend(session.db(), fixes.filter(|fix| fix.safe || guesses));
        if round.texts.is_empty() {
            return Ok(Fixed { left, files: files(session, originals), mended, settled: true });
        }
        mended += round.fixes;
        let db = session.db_mut();
        for (file, text) in round.texts {
            originals.entry(file).or_insert_with(|| Arc::clone(file.text(db)));
            file.set_text(db).to(text.into());
        }
    }
    Ok(Fixed { left: session.check()?, files: files(session, originals), mended, settled: false })
}

fn files(session: &Session<'_>, originals: FxHashMap<File, Arc<str>>) -> Vec<FixedFile> {
    let fixed = |(file, before): (File, Arc<str>)| {
        let after = Arc::clone(file.text(session.db()));
        FixedFile { file, path: session.shown(file), before, after }
    };
    let mut files: Vec<_> = originals.into_iter().map(fixed).filter(|file| file.before != file.after).collect();
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// Writes the files. Each is replaced as a whole or stays as it is.
pub(crate) fn write(session: &Session<'_>, files: &[FixedFile]) -> Result<(), UserError> {
    let db = session.db();
    for FixedFile { file, path, before, after } in files {
        let FileStatus::Read { encoding, .. } = file.status(db) else { continue };
        let bytes = encoded(*encoding, after).ok_or_else(|| unencodable(path))?;
        replace_file(file.path(db), &encoding.encode(before), &bytes).map_err(|reason| {
            UserError::new(format!("cannot write `{path}`: {reason}"))
                .with_help("files named before it have their fixes, this one and those behind it have not")
        })?;
    }
    Ok(())
}

/// The bytes of the text; `None` where they would not be read as the same text.
pub(crate) fn encoded(encoding: Encoding, text: &str) -> Option<Vec<u8>> {
    let bytes = encoding.encode(text);
    let read = decode(bytes.clone());
    (read.text == text && read.encoding == encoding).then_some(bytes)
}

pub(crate) fn unencodable(path: &str) -> UserError {
    UserError::new(format!("cannot write `{path}`: its encoding lacks a character of the new text"))
        .with_help("save it as UTF-8")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_that_would_be_read_otherwise_are_refused() {
        let declaration = "<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>";
        assert_eq!(encoded(Encoding::Latin1, &format!("{declaration}é")).unwrap().last(), Some(&0xE9));
        assert_eq!(encoded(Encoding::Latin1, &format!("{declaration}€")), None);
        assert_eq!(encoded(Encoding::Utf8, "€"), Some("€".as_bytes().to_vec()));
    }
}
