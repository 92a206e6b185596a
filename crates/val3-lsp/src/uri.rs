//! URIs and paths. Documents that are no files (`untitled:`) have a path that does not exist on any disk.

use camino::{Utf8Path, Utf8PathBuf};
use percent_encoding::percent_decode_str;
use tower_lsp::lsp_types::Url;

/// Document path; `None` if it is not valid UTF-8. `language` determines the extension for untitled documents.
pub(crate) fn path(uri: &Url, language: Option<&str>) -> Option<Utf8PathBuf> {
    if uri.scheme() == "file" {
        return Utf8PathBuf::from_path_buf(uri.to_file_path().ok()?).ok();
    }
    let name = percent_decode_str(uri.path()).decode_utf8().ok()?;
    let name = name.trim_start_matches('/');
    let ending = match language {
        Some("val3-data") => ".dtx",
        Some("val3-project") => ".pjx",
        _ => ".pgx",
    };
    let ending = if Utf8Path::new(name).extension().is_some() { "" } else { ending };
    Some(Utf8PathBuf::from(format!("/{}:/{name}{ending}", uri.scheme())))
}

/// URI of a path.
pub(crate) fn of(path: &Utf8Path) -> Url {
    if let Some((scheme, name)) = path.as_str().trim_start_matches('/').split_once(":/")
        && scheme.len() > 1
        && let Ok(uri) = Url::parse(&format!("{scheme}:{name}"))
    {
        return uri;
    }
    Url::from_file_path(path).unwrap_or_else(|()| relative(path))
}

/// URI of a relative path; loaders only return absolute paths.
fn relative(path: &Utf8Path) -> Url {
    Url::from_file_path(Utf8Path::new("/").join(path)).unwrap_or_else(|()| nowhere())
}

#[allow(clippy::expect_used, reason = "the text is a URI")]
fn nowhere() -> Url {
    Url::parse("file:///").expect("a URI")
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[allow(clippy::unwrap_used, reason = "a test may fail loudly")]
    fn path_of(uri: &str, language: &str) -> String {
        path(&Url::parse(uri).unwrap(), Some(language)).unwrap().into_string()
    }

    #[test]
    fn file_uris_become_paths_and_back() {
        assert_eq!(path_of("file:///a%20b/%C3%A9.pgx", "val3"), "/a b/é.pgx");
        assert_eq!(of("/a b/é.pgx".into()).as_str(), "file:///a%20b/%C3%A9.pgx");
    }

    #[test]
    fn untitled_documents_have_a_path() {
        assert_eq!(path_of("untitled:Untitled-1", "val3"), "/untitled:/Untitled-1.pgx");
        assert_eq!(path_of("untitled:Untitled-1", "val3-data"), "/untitled:/Untitled-1.dtx");
        assert_eq!(path_of("untitled:/a/b.pjx", "val3-project"), "/untitled:/a/b.pjx");
    }
}
