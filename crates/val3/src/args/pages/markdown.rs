//! Help texts as Markdown.

/// Formats a list item.
pub(super) fn bullet(head: &str, text: &str) -> String {
    format!("- {head}: {text}\n")
}

/// Formats options in the text as code, and escapes characters that Markdown would read as markup.
pub(super) fn prose(text: &str) -> String {
    let mut result = String::new();
    for (place, part) in text.split('`').enumerate() {
        if place > 0 {
            result.push('`');
        }
        if place % 2 == 1 {
            result.push_str(part);
        } else {
            result.push_str(&part.split_inclusive(char::is_whitespace).map(word).collect::<String>());
        }
    }
    result.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Formats a word outside of code spans.
fn word(word: &str) -> String {
    let start = word.find("--").filter(|start| word[..*start].chars().all(|letter| !letter.is_alphanumeric()));
    if let Some((before, rest)) = start.and_then(|start| word.split_at_checked(start)) {
        let end = rest.find(|letter: char| !is_part_of_option(letter)).unwrap_or(rest.len());
        let end = rest.get(..end).map_or(end, |option| option.trim_end_matches(',').len());
        if let Some((option, after)) = rest.split_at_checked(end).filter(|(option, _)| option.len() > 2) {
            return format!("{before}`{option}`{after}");
        }
    }
    word.replace('<', "\\<").replace('*', "\\*").replace('|', "\\|")
}

fn is_part_of_option(letter: char) -> bool {
    letter.is_alphanumeric() || "-=<>,".contains(letter)
}

/// Whether the line is a heading: at most three words and a colon.
fn is_heading(line: &str) -> bool {
    line.ends_with(':') && line.split_whitespace().count() <= 3
}

/// Converts the text after the options: headings end with a colon, and the indented lines below are a list or a
/// paragraph.
pub(super) fn notes(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        let indented = line.starts_with(' ');
        match (line.trim(), lines.last_mut()) {
            ("", _) => lines.push(String::new()),
            (title, _) if !indented && is_heading(title) => lines.push(format!("\n## {}", title.trim_end_matches(':'))),
            (text, last) => match (text.split_once("  ").filter(|_| indented), last) {
                (Some((code, meaning)), _) => lines.push(format!("- `{code}`: {}", prose(meaning.trim()))),
                (None, Some(last)) if !last.is_empty() && !last.starts_with("\n#") => {
                    last.push(' ');
                    last.push_str(&prose(text));
                }
                (None, _) => lines.push(prose(text)),
            },
        }
    }
    let text = lines.join("\n");
    if text.is_empty() { text } else { format!("\n{}\n", text.trim().replace("\n\n\n", "\n\n")) }
}
