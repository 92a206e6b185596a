//! Names that programs cannot use, because these files configure tools outside of the controller.
//!
//! If applications are directly in a repository, `Disk://` is the repository: a program could write `.git/config`, and
//! the next `git status` would execute any command. No program of a controller needs these names.

/// Configuration files of this project's tools, in lower case.
const SETTINGS: [&str; 2] = ["val3.toml", "cell.toml"];

/// Maximum size of the first part of a short name in Windows: `VAL3~1`.
const SHORT: usize = 8;

/// Whether a name begins with a dot or is the name of a settings file, in any spelling that a file system treats alike:
/// letter case, characters that macOS ignores, and the short names of Windows, such as `GIT~1` for `.git`.
pub(super) fn is_reserved(name: &str) -> bool {
    let name: String = name.chars().filter(|c| !is_ignored(*c)).flat_map(char::to_lowercase).collect();
    name.starts_with('.') || SETTINGS.contains(&name.as_str()) || is_short_name(&name)
}

/// Whether macOS ignores a character in names.
fn is_ignored(c: char) -> bool {
    matches!(c, '\u{200c}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{206a}'..='\u{206f}' | '\u{feff}')
}

fn is_short_name(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name);
    let number = stem.rsplit_once('~').map(|(_, number)| number).filter(|number| !number.is_empty());
    stem.len() <= SHORT && number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_steer_tools_are_reserved() {
        for name in [".git", ".GIT", ".envrc", ".", "val3.toml", "VAL3.Toml", "cell.toml"] {
            assert!(is_reserved(name), "{name}");
        }
        for name in ["git~1", "GIT~12", "VAL3~1.TOM", "\u{200c}.git", ".g\u{200d}it", "val3\u{feff}.toml"] {
            assert!(is_reserved(name), "{name}: another spelling of the same file");
        }
        for name in ["git", "a.git", "val3.tom", "start.pgx", "parts~", "a~b.txt", "longername~1", "~1x"] {
            assert!(!is_reserved(name), "{name}");
        }
    }
}
