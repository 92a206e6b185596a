//! Conventions of a client: first line and column number, form of paths, optional events.

use crate::protocol::{InitializePathFormat, InitializeRequestArguments, Source};

/// Scheme and empty authority of a file URI.
const FILE_URI: &str = "file://";

/// Conventions of a client. The default is the specification's.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Conventions {
    lines_start_at_1: bool,
    columns_start_at_1: bool,
    has_uris: bool,
    /// Whether the client supports the event `invalidated`.
    pub(crate) knows_invalidated: bool,
    /// Whether the client supports progress events.
    pub(crate) knows_progress: bool,
    /// Whether the client shows colours of ANSI escape sequences.
    pub(crate) shows_colors: bool,
}

impl Default for Conventions {
    fn default() -> Self {
        Self {
            lines_start_at_1: true,
            columns_start_at_1: true,
            has_uris: false,
            knows_invalidated: false,
            knows_progress: false,
            shows_colors: false,
        }
    }
}

impl Conventions {
    pub(crate) fn of(client: &InitializeRequestArguments) -> Self {
        Self {
            lines_start_at_1: client.lines_start_at1.unwrap_or(true),
            columns_start_at_1: client.columns_start_at1.unwrap_or(true),
            has_uris: client.path_format == Some(InitializePathFormat::Uri),
            knows_invalidated: client.supports_invalidated_event.unwrap_or_default(),
            knows_progress: client.supports_progress_reporting.unwrap_or_default(),
            shows_colors: client.supports_ansi_styling.unwrap_or_default(),
        }
    }

    /// Converts a line of a file, from 1, to the client's line number.
    pub(crate) fn line(&self, row: u32) -> u64 {
        if self.lines_start_at_1 { row.into() } else { row.saturating_sub(1).into() }
    }

    /// Converts the client's line number to a line of the file, from 1.
    pub(crate) fn row(&self, line: u64) -> u32 {
        let row = if self.lines_start_at_1 { line } else { line.saturating_add(1) };
        u32::try_from(row).unwrap_or(u32::MAX)
    }

    /// Converts a column, from 1, to the client's column number.
    pub(crate) fn column(&self, column: u32) -> u64 {
        if self.columns_start_at_1 { column.into() } else { column.saturating_sub(1).into() }
    }

    /// Converts the client's column number to an offset in the line, from 0.
    pub(crate) fn offset(&self, column: u64) -> usize {
        let offset = if self.columns_start_at_1 { column.saturating_sub(1) } else { column };
        usize::try_from(offset).unwrap_or(usize::MAX)
    }

    /// Returns a file as a source for the client.
    pub(crate) fn source(&self, file: &str) -> Source {
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        let path = if self.has_uris { uri(file) } else { file.to_owned() };
        Source { name: Some(name.to_owned()), path: Some(path), ..Source::default() }
    }

    /// Returns the path in a source from the client.
    pub(crate) fn path(source: &Source) -> Option<String> {
        source.path.as_deref().map(plain)
    }

    /// Whether a path of the client names a file. Clients differ in separators and in the letter case of drives, and some
    /// send URIs without a request for them.
    pub(crate) fn is_file(source: &Source, file: &str) -> bool {
        source.path.as_deref().is_some_and(|path| key(path) == key(file))
    }
}

fn uri(file: &str) -> String {
    let slash = if file.starts_with('/') { "" } else { "/" };
    let path = file.bytes().map(|byte| match byte {
        b'\\' => "/".to_owned(),
        _ if byte.is_ascii_alphanumeric() || b"-._~/:".contains(&byte) => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    });
    format!("{FILE_URI}{slash}{}", path.collect::<String>())
}

/// Returns the path of a URI; a path is returned unchanged.
fn plain(path: &str) -> String {
    let path = path.strip_prefix(FILE_URI).map_or_else(|| path.to_owned(), decoded);
    match path.strip_prefix('/').filter(|rest| rest.as_bytes().get(1) == Some(&b':')) {
        Some(with_drive) => with_drive.to_owned(),
        None => path,
    }
}

/// Returns the normalised path: equal for all spellings of the same file.
fn key(path: &str) -> String {
    let path = plain(path).replace('\\', "/");
    match path.split_once(':') {
        Some((drive, rest)) if drive.len() == 1 => format!("{}:{rest}", drive.to_ascii_lowercase()),
        _ => path,
    }
}

fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let hex = after.get(..2).and_then(|digits| str::from_utf8(digits).ok());
        let code = hex.and_then(|digits| u8::from_str_radix(digits, 16).ok()).filter(|_| *first == b'%');
        bytes.push(code.unwrap_or(*first));
        rest = if code.is_some() { after.get(2..).unwrap_or_default() } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str) -> Source {
        Source { path: Some(path.to_owned()), ..Source::default() }
    }

    #[test]
    fn a_file_is_found_by_the_spellings_of_clients() {
        assert!(Conventions::is_file(&source("/home/a b/start.pgx"), "/home/a b/start.pgx"));
        assert!(Conventions::is_file(&source("file:///home/a%20b/start.pgx"), "/home/a b/start.pgx"));
        assert!(Conventions::is_file(&source("c:\\cell\\start.pgx"), "C:/cell/start.pgx"));
        assert!(Conventions::is_file(&source("file:///c%3A/cell/start.pgx"), "C:\\cell\\start.pgx"));
        assert!(!Conventions::is_file(&source("/home/start.pgx"), "/home/Start.pgx"));
        assert!(!Conventions::is_file(&source("%"), "/home/start.pgx"));
    }

    #[test]
    fn a_client_may_count_from_0_and_have_uris() {
        let client = InitializeRequestArguments {
            lines_start_at1: Some(false),
            columns_start_at1: Some(false),
            path_format: Some(InitializePathFormat::Uri),
            ..InitializeRequestArguments::default()
        };
        let conventions = Conventions::of(&client);
        assert_eq!((conventions.line(1), conventions.row(0)), (0, 1));
        assert_eq!((conventions.column(1), conventions.offset(3)), (0, 3));
        assert_eq!(conventions.source("/a b/ü.pgx").path.as_deref(), Some("file:///a%20b/%C3%BC.pgx"));
        assert_eq!(Conventions::default().row(0), 0, "no line: nothing is there");
    }
}
