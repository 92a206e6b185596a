//! Names in their three spellings.

/// `ElseIf` or `elseIf` -> `else_if`.
pub(super) fn snake(name: &str) -> String {
    let mut snake = String::new();
    for (index, letter) in name.char_indices() {
        if letter.is_ascii_uppercase() && index > 0 {
            snake.push('_');
        }
        snake.push(letter.to_ascii_lowercase());
    }
    snake
}

/// `ElseIf` or `elseIf` -> `ELSE_IF`.
pub(super) fn screaming(name: &str) -> String {
    snake(name).to_ascii_uppercase()
}

/// `entry` -> `entries`, `stmt` -> `stmts`.
pub(super) fn plural(name: &str) -> String {
    match name.strip_suffix('y') {
        Some(stem) => format!("{stem}ies"),
        None if name.ends_with('s') || name.ends_with("ch") => format!("{name}es"),
        None => format!("{name}s"),
    }
}
