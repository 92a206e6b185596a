//! Kinds of output files. An existing file is only replaced by output of the same kind, so that a wrong argument does
//! not destroy a program.

use camino::Utf8Path;
use val3_files::Unreadable;

use crate::paths::has_extension;
use crate::user_error::UserError;

/// Output file kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OutputFileKind {
    /// Events of a run, one JSON object per line.
    Events,
    /// JSON documents, or one JSON object per line.
    Json,
    /// XML reports.
    XmlReport,
    /// SVG pictures.
    Svg,
    /// HTML pages.
    Html,
    /// Programs, or code without XML.
    Program,
    /// Tables and other texts.
    Text,
}

/// Root elements of XML reports.
const REPORTS: [&str; 3] = ["<testsuites", "<checkstyle", "<coverage"];

/// Extension of programs.
const PROGRAM: &str = "pgx";

/// Extensions of input files for the tools or a controller.
const INPUTS: [&str; 7] = ["pgx", "dtx", "pjx", "cfx", "ltx", "toml", "zip"];

/// Number of bytes that determine the kind of a file.
const HEAD: u64 = 1024;

impl OutputFileKind {
    /// Whether the first bytes of a file have this kind. An empty file has every kind.
    fn begins(self, head: &[u8]) -> bool {
        let head = String::from_utf8_lossy(head).to_lowercase();
        let head = head.trim_start_matches('\u{feff}').trim_start();
        head.is_empty()
            || match self {
                Self::Events => head.starts_with("{\"t\":"),
                Self::Json => head.starts_with(['{', '[']),
                Self::XmlReport => REPORTS.iter().any(|root| head.contains(root)),
                Self::Svg => head.contains("<svg"),
                Self::Html => head.starts_with("<!doctype html"),
                Self::Program => {
                    head.contains("<programs") || head.contains("<programlist") || head.starts_with("begin")
                }
                Self::Text => !head.starts_with('<'),
            }
    }
}

/// Checks that there is no file at `path` that `content` may not replace.
///
/// # Errors
/// The file is input of the tools, has other content, or cannot be read.
pub(super) fn check_replaceable(path: &Utf8Path, content: OutputFileKind, what: &str) -> Result<(), UserError> {
    let is_own = content == OutputFileKind::Program && has_extension(path, PROGRAM);
    let is_input = !is_own && INPUTS.iter().any(|known| has_extension(path, known));
    let is_replaceable = match val3_files::read_head(path, HEAD) {
        Ok(head) => !is_input && content.begins(&head),
        // Devices and pipes accept the output; a folder is reported when the file is created.
        Err(Unreadable::Missing | Unreadable::Device | Unreadable::Pipe | Unreadable::Socket | Unreadable::Folder) => {
            true
        }
        Err(reason) => {
            return Err(UserError::new(format!("cannot replace `{path}` by the {what}: {reason}"))
                .with_help("name another file"));
        }
    };
    if is_replaceable {
        return Ok(());
    }
    Err(UserError::new(format!("`{path}` exists and has other content, so the {what} does not replace it"))
        .with_help("name another file, or remove this one first"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_by_output_of_its_own_kind() {
        use OutputFileKind::{Events, Html, Json, Program, Svg, Text, XmlReport};
        let heads = [
            (Events, "{\"t\":0.0,\"kind\":\"end\"}"),
            (Json, "{\"version\":1}"),
            (XmlReport, "<?xml version=\"1.0\"?>\n<testsuites>"),
            (Svg, "<svg xmlns="),
            (Html, "<!DOCTYPE html>"),
            (Text, "time,x"),
        ];
        for (content, head) in heads {
            assert!(content.begins(head.as_bytes()) && content.begins(b""), "{head}");
            assert!(!content.begins(b"<?xml version=\"1.0\"?>\n<Programs>"), "{content:?}");
        }
        assert!(!Events.begins(b"{\"name\": \"package\"}"));
        assert!(Program.begins(b"\xef\xbb\xbf<?xml version=\"1.0\"?>\n<Programs>") && Program.begins(b"begin\n"));
        assert!(!Program.begins(b"<?xml version=\"1.0\"?>\n<Database>"));
    }

    #[test]
    fn inputs_are_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let folder = Utf8Path::from_path(folder.path()).unwrap();
        for name in ["start.pgx", "val3.toml", "ARM.CFX"] {
            std::fs::write(folder.join(name), "").unwrap();
            let error = check_replaceable(&folder.join(name), OutputFileKind::Text, "trace").unwrap_err();
            assert!(error.to_string().contains("does not replace it"), "{error}");
        }
        assert!(check_replaceable(&folder.join("new.pgx"), OutputFileKind::Text, "trace").is_ok());
        assert!(check_replaceable(&folder.join("start.pgx"), OutputFileKind::Program, "output").is_ok());
        assert!(check_replaceable(&folder.join("val3.toml"), OutputFileKind::Program, "output").is_err());
    }
}
