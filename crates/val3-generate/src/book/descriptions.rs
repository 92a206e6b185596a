//! Page descriptions, which search engines show.

use anyhow::{Result, bail};
use camino::Utf8Path;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

use crate::book::links::options;
use crate::book::page::BookPage;
use crate::files;

/// Largest length of a description, in characters.
const LONGEST: usize = 160;

/// Beginning of the element with the book's description, which every page contains.
const META: &str = "<meta name=\"description\" content=\"";

/// Sets the first paragraph as description in all pages.
pub(crate) fn write(html: &Utf8Path, pages: &[BookPage]) -> Result<()> {
    for page in pages.iter().filter(|page| page.path != "SUMMARY.md") {
        let file = html.join(page.path.replace(".md", ".html"));
        let text = files::read(&file)?;
        let Some((before, rest)) = text.split_once(META) else { bail!("{file} has no description") };
        let Some((_, after)) = rest.split_once('"') else { bail!("the description of {file} has no end") };
        let new = escaped(&description(&page.text));
        files::write(&file, &format!("{before}{META}{new}\"{after}"))?;
    }
    Ok(())
}

/// Returns the plain text of the first paragraph, cut between two words.
fn description(markdown: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for event in Parser::new_ext(markdown, options()) {
        match event {
            Event::Start(Tag::Paragraph) => inside = true,
            Event::End(TagEnd::Paragraph) => break,
            Event::Text(part) | Event::Code(part) if inside => text.push_str(&part),
            Event::SoftBreak if inside => text.push(' '),
            _ => {}
        }
    }
    cut(&text)
}

fn cut(text: &str) -> String {
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    let start: String = text.chars().take(LONGEST).collect();
    let words = start.rsplit_once(' ').map_or(start.as_str(), |(words, _)| words);
    format!("{words} …")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_paragraph_is_the_description() {
        assert_eq!(description("# Title\n\nOne [`two`](x)\nthree.\n\nFour.\n"), "One two three.");
        let long = format!("# T\n\n{}", "word ".repeat(60));
        assert!(description(&long).ends_with("word …") && description(&long).chars().count() <= LONGEST + 2);
    }
}
