//! Resources: the pages of `explain`, for clients that attach documents.

/// URI of the primer.
pub(crate) const GUIDE: &str = "val3://guide";

/// URI template of the pages.
pub(crate) const TEMPLATE: &str = "val3://explain/{topic}";

/// Topic of a URI; `None` if the resource does not exist.
pub(crate) fn topic(address: &str) -> Option<String> {
    if address == GUIDE {
        return Some(crate::tools::GUIDE.to_owned());
    }
    let topic = address.strip_prefix("val3://explain/").filter(|topic| !topic.is_empty())?;
    Some(topic.replace("%20", " "))
}
