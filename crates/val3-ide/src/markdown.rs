//! Escaping of file texts in Markdown. VAL 3 comments, names and values are no Markdown: an image in a cloned program
//! would be loaded when the pointer is on a name, and `<value>` or `*` would not be displayed.

/// VAL 3 code block.
pub(crate) fn fenced(code: &str) -> String {
    block("val3", code)
}

/// Code block in a language. No line of the code can end the block.
pub(crate) fn block(language: &str, code: &str) -> String {
    let fence = "`".repeat(longest_run(code).max(2) + 1);
    let code = code.replace("\r\n", "\n").replace('\r', "\n");
    format!("{fence}{language}\n{code}\n{fence}\n")
}

/// Inline code.
pub(crate) fn code(text: &str) -> String {
    let text = one_line(text);
    let marks = "`".repeat(longest_run(&text) + 1);
    // Markdown removes one space from both ends if both have one.
    let is_padded = text.starts_with(['`', ' ']) || text.ends_with(['`', ' ']);
    let blank = if is_padded && !text.trim().is_empty() { " " } else { "" };
    if text.is_empty() { String::new() } else { format!("{marks}{blank}{text}{blank}{marks}") }
}

/// Inline text, displayed literally.
pub(crate) fn plain(text: &str) -> String {
    let text = one_line(text);
    let text = text.trim();
    let mut escaped = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        let (before, rest) = text.split_at(at);
        if is_mark(before, rest) || begins_block(before, letter) || begins_link(before, rest) {
            escaped.push('\\');
        }
        escaped.push(letter);
    }
    escaped
}

/// Whether the first character of `rest` is markup anywhere in a line. An underscore within a word is not.
fn is_mark(before: &str, rest: &str) -> bool {
    let ends_word = || before.ends_with(char::is_alphanumeric);
    match rest.strip_prefix('_') {
        Some(after) => !(ends_word() && after.starts_with(char::is_alphanumeric)),
        None => rest.starts_with(|letter| r"\`*[<&~$@^".contains(letter)),
    }
}

/// Whether a character starts a list, a heading or another block at the start of a line, for example `-` or `1.`.
fn begins_block(before: &str, letter: char) -> bool {
    match letter {
        '#' | '+' | '-' | '=' | ':' | '>' | '|' => before.is_empty(),
        '.' | ')' => !before.is_empty() && before.bytes().all(|byte| byte.is_ascii_digit()),
        _ => false,
    }
}

/// Whether a character is required in automatic links: `://`, `www.`
fn begins_link(before: &str, rest: &str) -> bool {
    rest.starts_with("://") || rest.starts_with('.') && ends_with_www(before)
}

/// Whether the text ends with `www` in any letter case.
fn ends_with_www(text: &str) -> bool {
    text.get(text.len().saturating_sub(3)..).is_some_and(|end| end.eq_ignore_ascii_case("www"))
}

fn longest_run(text: &str) -> usize {
    text.split(|letter| letter != '`').map(str::len).max().unwrap_or(0)
}

/// Replaces control characters, including line ends, by spaces.
fn one_line(text: &str) -> String {
    text.replace(|letter: char| letter.is_control(), " ")
}

#[cfg(test)]
mod tests;
