//! Splits Markdown pages of the catalogue into parts.
//!
//! A page starts with a sentence that describes its subject. Its examples are fenced blocks marked `val3`, as listings:
//! data, followed by code.

/// Returns the page without the leading blank in each doc comment line. A page from a file is returned unchanged.
#[must_use]
pub fn text(page: &str) -> String {
    let is_comment = page.lines().all(|line| line.is_empty() || line.starts_with(' '));
    let blank = if is_comment { " " } else { "" };
    let mut text = String::with_capacity(page.len());
    for line in page.lines() {
        text.push_str(line.strip_prefix(blank).unwrap_or(line));
        text.push('\n');
    }
    text
}

/// Returns the first paragraph of a page: one sentence.
#[must_use]
pub fn summary(page: &str) -> String {
    let lines = page.lines().map(str::trim).take_while(|line| !line.is_empty());
    lines.collect::<Vec<_>>().join(" ")
}

/// Returns the text below the heading `## heading`, trimmed; empty if there is no such heading.
#[must_use]
pub fn section(page: &str, heading: &str) -> String {
    let text = text(page);
    let lines = text.lines().skip_while(|line| line.strip_prefix("## ") != Some(heading)).skip(1);
    let lines: Vec<_> = lines.take_while(|line| !line.starts_with("## ")).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}

/// Returns the VAL 3 listings of a page, in order.
#[must_use]
pub fn examples(page: &str) -> Vec<String> {
    let mut examples = Vec::new();
    let mut open: Option<String> = None;
    for line in text(page).lines() {
        open = match (open, line.trim_end()) {
            (None, "```val3") => Some(String::new()),
            (None, _) => None,
            (Some(example), "```") => {
                examples.push(example);
                None
            }
            (Some(example), line) => Some(example + line + "\n"),
        };
    }
    examples
}

#[cfg(test)]
mod tests {
    use super::{examples, section, summary, text};

    const PAGE: &str = " Adds one\n to `n`.\n\n More.\n ```val3\n num n\n   n=n+1\n ```\n End.\n";

    #[test]
    fn a_section_ends_at_the_next_heading() {
        let page = " One.\n\n ## Why\n\n Because\n of it.\n\n ## Bad\n x\n";
        assert_eq!(section(page, "Why"), "Because\nof it.");
        assert_eq!(section(page, "Bad"), "x");
        assert_eq!(section(page, "Good"), "");
    }

    #[test]
    fn cuts_a_page() {
        assert_eq!(summary(PAGE), "Adds one to `n`.");
        assert_eq!(examples(PAGE), ["num n\n  n=n+1\n"]);
        assert!(text(PAGE).starts_with("Adds one\nto"));
        assert_eq!(text("One.\n  code\n"), "One.\n  code\n");
    }
}
