//! All pages that `val3 explain` prints and that the book and editors show.

mod errors;
mod glossary;
mod instructions;
mod log_messages;
mod options;
mod rules;
mod search;
mod statements;
mod tables;
mod topic;

use crate::rule::Rule;

pub use search::{Hit, search};
pub use topic::{Topic, TopicKind};

/// Address of the published book.
const BOOK: &str = env!("CARGO_PKG_HOMEPAGE");

/// Address of a rule's page in the published book.
pub fn address(rule: &Rule) -> String {
    format!("{BOOK}/{}/{}.html", TopicKind::Finding.folder(), rule.code)
}

/// All topics, sorted by kind and group.
pub fn all() -> Vec<Topic> {
    let mut topics = rules::topics();
    topics.extend(statements::topics());
    topics.extend(instructions::topics());
    topics.extend(glossary::topics());
    topics.extend(errors::topics());
    topics.extend(log_messages::topics());
    topics.sort_by_key(|topic| topic.kind);
    topics
}

/// Finds topics by name. A topic with this title hides other topics, and an exact match hides matches in another letter
/// case. Several topics can share a name: `config` is a type, a field and an instruction.
pub fn find<'a>(topics: &'a [Topic], name: &str) -> Vec<&'a Topic> {
    let matches: [fn(&Topic, &str) -> bool; 4] = [
        |topic, name| topic.name() == name,
        |topic, name| topic.names.iter().any(|other| other == name),
        |topic, name| topic.name().eq_ignore_ascii_case(name),
        |topic, name| topic.names.iter().any(|other| other.eq_ignore_ascii_case(name)),
    ];
    let mut found = matches.into_iter().map(|matches| topics.iter().filter(|topic| matches(topic, name)).collect());
    found.find(|found: &Vec<&Topic>| !found.is_empty()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_topic_is_complete() {
        for topic in all() {
            assert!(topic.names.iter().all(|name| !name.is_empty()), "{topic:?}");
            assert!(!topic.summary.is_empty() && topic.page.starts_with("# "), "{topic:?}");
        }
    }

    #[test]
    fn no_two_topics_of_a_kind_share_a_name() {
        let mut names: Vec<_> =
            all().iter().flat_map(|topic| topic.names.clone().into_iter().map(|name| (topic.kind, name))).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
