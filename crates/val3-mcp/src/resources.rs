//! Resources: the pages of `explain`, for clients that attach documents.

/// Address of the primer.
pub(crate) const GUIDE: &str = "val3://guide";

/// Addresses of pages.
pub(crate) const TEMPLATE: &str = "val3://explain/{topic}";

/// Topic of an address; `None` if there is no such resource.
pub(crate) fn topic(address: &str) -> Option<String> {
    if address == GUIDE {
        return Some(crate::tools::GUIDE.to_owned());
    }
    let topic = address.strip_prefix("val3://explain/").filter(|topic| !topic.is_empty())?;
    Some(topic.replace("%20", " "))
}
