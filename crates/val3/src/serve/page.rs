//! Page that shows a run, with protective headers.

use axum::body::Bytes;
use axum::http::header::{
    CACHE_CONTROL, CONNECTION, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderName, HeaderValue, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS, X_FRAME_OPTIONS,
};
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Response};
use base64::prelude::{BASE64_STANDARD, Engine};
use sha2::{Digest, Sha256};

/// Page with its script and style. The page loads no other files.
pub(crate) const PAGE: &str = include_str!("../../../../editors/view/dist/view.html");

/// Page response, with the part of the content security policy that does not depend on the request.
pub(super) struct ServedPage {
    policy: String,
}

impl ServedPage {
    /// Computes the policy, which permits only the scripts and styles in the page.
    pub(super) fn new() -> Self {
        let [scripts, styles] = ["script", "style"].map(|element| sources(PAGE, element));
        let policy = format!(
            "default-src 'none'; script-src{scripts}; style-src{styles}; img-src data: blob:; font-src data:; \
             base-uri 'none'; form-action 'none'; frame-ancestors 'none'; connect-src 'self'"
        );
        Self { policy }
    }

    /// Response with the page. `host` is the host of this server to whose socket the page connects.
    pub(super) fn respond(&self, host: &str) -> Response {
        let mut headers = protective_headers();
        headers.insert(CONTENT_TYPE, HeaderValue::from_static("text/html; charset=utf-8"));
        let Ok(policy) = HeaderValue::try_from(format!("{} ws://{host}", self.policy)) else { return not_found() };
        headers.insert(CONTENT_SECURITY_POLICY, policy);
        (headers, Bytes::from_static(PAGE.as_bytes())).into_response()
    }
}

/// Response to all requests that are not permitted.
pub(super) fn not_found() -> Response {
    (StatusCode::NOT_FOUND, protective_headers()).into_response()
}

/// Headers of all responses except responses that open a socket. A connection has one request.
pub(super) fn protective_headers() -> HeaderMap {
    let headers = [
        (CONNECTION, "close"),
        (CACHE_CONTROL, "no-store"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (X_FRAME_OPTIONS, "DENY"),
        (REFERRER_POLICY, "no-referrer"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    ];
    headers.into_iter().map(|(name, value)| (name, HeaderValue::from_static(value))).collect()
}

/// Hashes of the elements with this name, as policy sources.
fn sources(page: &str, element: &str) -> String {
    let (opening, closing) = (format!("<{element}"), format!("</{element}>"));
    let mut sources = String::new();
    let mut rest = page;
    while let Some((_, after)) = rest.split_once(opening.as_str()) {
        let Some((content, after)) = after.split_once('>').and_then(|(_, after)| after.split_once(closing.as_str()))
        else {
            break;
        };
        let hash = BASE64_STANDARD.encode(Sha256::digest(content));
        sources.push_str(&format!(" 'sha256-{hash}'"));
        rest = after;
    }
    if sources.is_empty() { " 'none'".to_owned() } else { sources }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_named_by_their_hashes() {
        let page = "<style>a{}</style><script type=\"module\">alert(\"<style\")</script>";
        assert_eq!(
            sources(page, "script"),
            " 'sha256-X'".replace('X', &BASE64_STANDARD.encode(Sha256::digest("alert(\"<style\")")))
        );
        assert_eq!(sources(page, "style").matches("sha256-").count(), 1);
        assert_eq!(sources("<p>", "script"), " 'none'");
    }

    #[test]
    fn the_page_fetches_nothing() {
        for reference in [" src=\"http", " href=\"http", "@import", " src=\"/"] {
            assert!(!PAGE.contains(reference), "{reference}");
        }
    }
}
