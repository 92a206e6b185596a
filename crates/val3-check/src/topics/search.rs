//! Full-text search of all pages.

use super::topic::Topic;
use val3_lang::page;
use val3_syntax::TextSlice;

/// A page that a search has found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hit<'a> {
    /// Page.
    pub topic: &'a Topic,
    /// Sentence with the most searched words.
    pub excerpt: String,
    /// Rank of the page; the best page has the highest rank.
    rank: Rank,
}

/// Rank of a page: the number of found words, then their weight.
type Rank = (usize, usize);

/// Weights of a word in a name of the page, in its summary, and in its text.
const NAME: usize = 12;
const SUMMARY: usize = 5;
const TEXT: usize = 1;

/// Maximum number of sentences that count for a page, so that a long page is not always the best.
const MOST: usize = 3;

/// Returns the pages with the words, best first. A word matches words that begin with it, in upper or lower case. If no
/// page has all words, the pages with most words are returned.
#[must_use]
pub fn search<'a>(topics: &'a [Topic], words: &[&str]) -> Vec<Hit<'a>> {
    let words: Vec<String> = words.iter().map(|word| stem(&word.to_lowercase()).to_owned()).collect();
    let mut hits: Vec<Hit<'_>> = topics.iter().filter_map(|topic| hit(topic, &words)).collect();
    let most = hits.iter().map(|hit| hit.rank.0).max().unwrap_or(0);
    hits.retain(|hit| hit.rank.0 == most);
    hits.sort_by_key(|hit| std::cmp::Reverse(hit.rank));
    hits
}

/// Optional endings of a word. `ss` is no ending.
const ENDINGS: [&str; 5] = ["ing", "ies", "ss", "s", "y"];

/// Minimum number of letters before an ending.
const SHORTEST: usize = 4;

/// Removes the ending of a word: `singularit` for `singularity` and `singularities`.
fn stem(word: &str) -> &str {
    let ending = ENDINGS.into_iter().find(|ending| word.ends_with(ending)).filter(|ending| *ending != "ss");
    let stem = ending.and_then(|ending| word.strip_suffix(ending));
    stem.filter(|stem| stem.chars().count() >= SHORTEST).unwrap_or(word)
}

fn hit<'a>(topic: &'a Topic, words: &[String]) -> Option<Hit<'a>> {
    let sentences = sentences(&topic.page);
    let texts: Vec<String> = sentences.iter().map(|sentence| sentence.to_lowercase()).collect();
    let weights: Vec<usize> = words.iter().map(|word| weight(word, topic, &texts)).collect();
    let found = weights.iter().filter(|weight| **weight > 0).count();
    let count = |text: &String| words.iter().filter(|word| contains(text, word)).count();
    let best = texts.iter().enumerate().rev().max_by_key(|(_, text)| count(text)).map(|(place, _)| place);
    let excerpt = best.and_then(|place| sentences.get(place)).cloned().unwrap_or_default();
    (found > 0).then(|| Hit { topic, excerpt, rank: (found, weights.iter().sum()) })
}

/// Weight of a word in a topic, from its places in names, title, summary and sentences (`texts`, in lower case).
fn weight(word: &str, topic: &Topic, texts: &[String]) -> usize {
    let title = format!("{} {}", topic.names.join(" "), topic.title).to_lowercase();
    let is_name = topic.names.iter().any(|name| stem(&name.to_lowercase()) == word);
    let in_title = usize::from(contains(&title, word)) + usize::from(is_name);
    let in_summary = usize::from(contains(&topic.summary.to_lowercase(), word));
    let in_text = texts.iter().filter(|text| contains(text, word)).count().min(MOST);
    in_title * NAME + in_summary * SUMMARY + in_text * TEXT
}

/// Whether a word of the text begins with `word`.
fn contains(text: &str, word: &str) -> bool {
    let starts = |(at, _): (usize, &str)| !text.part(..at).ends_with(char::is_alphanumeric);
    !word.is_empty() && text.match_indices(word).any(starts)
}

/// Sentences of a page, without headings and code blocks.
fn sentences(page: &str) -> Vec<String> {
    let mut sentences = Vec::new();
    let mut paragraph = String::new();
    let mut in_code = false;
    for line in page::text(page).lines().map(str::trim).chain([""]) {
        let is_fence = line.starts_with("```");
        in_code ^= is_fence;
        if is_fence || line.is_empty() || line.starts_with(['#', '-', '|']) {
            sentences.extend(split(&std::mem::take(&mut paragraph)));
        }
        if !is_fence && !in_code && !line.starts_with('#') {
            paragraph.push_str(line.trim_start_matches("- "));
            paragraph.push(' ');
        }
    }
    sentences
}

fn split(paragraph: &str) -> Vec<String> {
    let parts = paragraph.trim().split_inclusive(". ").map(|part| part.trim().to_owned());
    parts.filter(|part| !part.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::{contains, search, sentences};
    use crate::topics;

    fn best(words: &[&str]) -> Vec<String> {
        search(&topics::all(), words).iter().take(3).map(|hit| hit.topic.title.clone()).collect()
    }

    #[test]
    fn the_best_page_is_first() {
        for (words, title) in [
            (["waits", "until", "moves"].as_slice(), "waitEndMove"),
            (&["wait", "condition"], "wait"),
            (&["tool", "centre", "point", "speed"], "tvel"),
            (&["straight", "line"], "movel"),
            (&["rounding", "corners"], "blend"),
            (&["singularities"], "singularity"),
        ] {
            assert!(best(words).iter().any(|found| found.contains(title)), "{words:?}: {:?}", best(words));
        }
    }

    #[test]
    fn words_match_their_beginnings() {
        assert!(contains("moves to the points", "point") && !contains("appoint it", "point"));
        assert!(contains("with `leave` at", "leave"));
    }

    #[test]
    fn code_and_headings_are_no_sentences() {
        let page = "# Title\n\nOne thing. Another\nthing.\n```val3\ncode. more\n```\n- item\n- next";
        assert_eq!(sentences(page), ["One thing.", "Another thing.", "item", "next"]);
    }
}
