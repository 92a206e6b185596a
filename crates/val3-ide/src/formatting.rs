//! Formatting of workspace files, and style lookup.

use std::fmt::{self, Display};

use camino::{Utf8Path, Utf8PathBuf};
use ec4rs::property::{IndentSize, IndentStyle as SuppressedRule, TabWidth};
use ec4rs::{ConfigParser, Properties, PropertiesSource as _};
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_analysis::system::System;
use val3_config::{CodeLayout, IndentStyle};
use val3_files::{FileClass, Unreadable};
use val3_fmt::{CodeStyle, IndentOverride};
use val3_syntax::{TextEdit, TextRange, TextSize};

use crate::FilePosition;
use crate::edit::FileEdit;
use crate::owner::{is_cell_file, is_page};

/// Characters after which [`format_on_type`] may return edits.
pub const FORMATTING_TRIGGERS: [char; 7] = val3_fmt::TRIGGERS;

/// Style of the file at `path`: `[format]` of its `val3.toml`, then for the indentation the `.editorconfig` files above
/// it. Editor settings are ignored, so that the command line and all editors agree.
///
/// # Errors
/// If an `.editorconfig` exists but cannot be read.
pub fn style(system: &dyn System, format: &CodeLayout, path: &Utf8Path) -> Result<CodeStyle, UnreadableStyle> {
    let properties = editorconfig(system, path)?;
    let style = properties.get::<SuppressedRule>().ok().map(|style| match style {
        SuppressedRule::Tabs => IndentStyle::Tab,
        SuppressedRule::Spaces => IndentStyle::Space,
    });
    let size = match properties.get::<IndentSize>() {
        Ok(IndentSize::Value(size)) => Some(size),
        Ok(IndentSize::UseTabWidth) => match properties.get::<TabWidth>() {
            Ok(TabWidth::Value(width)) => Some(width),
            Err(_) => None,
        },
        Err(_) => None,
    };
    Ok(CodeStyle::new(format, IndentOverride { style, size: size.and_then(|size| u8::try_from(size).ok()) }))
}

/// An unreadable `.editorconfig`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadableStyle {
    /// Path of the file.
    pub path: Utf8PathBuf,
    /// Reason.
    pub reason: Unreadable,
}

impl Display for UnreadableStyle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot read `{}`: {}", self.path, self.reason)
    }
}

impl std::error::Error for UnreadableStyle {}

/// Properties from the `.editorconfig` files in the folder of `path` and above. A file is ignored from its first
/// invalid section on.
fn editorconfig(system: &dyn System, path: &Utf8Path) -> Result<Properties, UnreadableStyle> {
    let mut sections = Vec::new();
    for folder in path.ancestors().skip(1) {
        let file = folder.join(".editorconfig");
        let text = match system.read(&file, FileClass::Settings) {
            Ok(text) => text,
            Err(Unreadable::Missing) => continue,
            Err(reason) => return Err(UnreadableStyle { path: file, reason }),
        };
        let Ok(parser) = ConfigParser::new(text.as_slice()) else { continue };
        let is_root = parser.is_root;
        let inside = path.strip_prefix(folder).unwrap_or(path).as_std_path().to_owned();
        sections.push((inside, parser.map_while(Result::ok).collect::<Vec<_>>()));
        if is_root {
            break;
        }
    }
    let mut properties = Properties::new();
    // Nearer files are applied later and override the others.
    for (inside, sections) in sections.iter().rev() {
        for section in sections.iter().filter(|section| section.applies_to(inside)) {
            // Adding a section cannot fail.
            let _ = section.apply_to(&mut properties, inside);
        }
    }
    Ok(properties)
}

/// Edits that format a file.
pub fn format_file(db: &dyn Db, file: File, style: &CodeStyle) -> Vec<FileEdit> {
    of_file(file, val3_fmt::format(file.text(db), &parse(db, file), style))
}

/// Edits that format the lines of a range.
pub fn format_range(db: &dyn Db, file: File, range: TextRange, style: &CodeStyle) -> Vec<FileEdit> {
    of_file(file, val3_fmt::format_range(file.text(db), &parse(db, file), style, range))
}

/// Edits after a character was typed directly before the position.
pub fn format_on_type(db: &dyn Db, at: FilePosition, typed: char, style: &CodeStyle) -> Vec<FileEdit> {
    let text: &str = at.file.text(db);
    if at.offset > TextSize::of(text) || is_page(db, at.file) || is_cell_file(db, at.file) {
        return Vec::new();
    }
    of_file(at.file, val3_fmt::on_type(text, &parse(db, at.file), style, at.offset, typed))
}

fn of_file(file: File, edits: Vec<TextEdit>) -> Vec<FileEdit> {
    edits.into_iter().map(|edit| FileEdit { file, range: edit.range, text: edit.text }).collect()
}

#[cfg(test)]
mod tests {
    use val3_analysis::system::Memory;
    use val3_fmt::Indent;

    use super::*;

    fn indent(format: &CodeLayout, files: &[(&str, &str)]) -> Indent {
        let system = Memory::new(files.iter().map(|(path, text)| (*path, text.as_bytes())));
        style(&system, format, Utf8Path::new("/cell/app/start.pgx")).unwrap().indent
    }

    #[test]
    fn the_nearest_editorconfig_wins_and_val3_toml_over_all() {
        let outer = ("/.editorconfig", "root=true\n[*]\nindent_style=tab\n");
        let inner =
            ("/cell/.editorconfig", "[*.{pgx,dtx}]\nindent_style=space\nindent_size=4\n[*.py]\nindent_size=8\n");
        assert_eq!(indent(&CodeLayout::default(), &[]), Indent::Blanks(2));
        assert_eq!(indent(&CodeLayout::default(), &[outer]), Indent::Tab);
        assert_eq!(indent(&CodeLayout::default(), &[outer, inner]), Indent::Blanks(4));
        let own = CodeLayout { indent_size: Some(3), ..CodeLayout::default() };
        assert_eq!(indent(&own, &[outer, inner]), Indent::Blanks(3));
        let own = CodeLayout { indent_style: Some(IndentStyle::Space), ..CodeLayout::default() };
        assert_eq!(indent(&own, &[outer]), Indent::Blanks(2));
    }

    #[test]
    fn the_search_ends_at_a_root_editorconfig() {
        let root = ("/cell/.editorconfig", "root=true\n[*]\nindent_size=5\n");
        assert_eq!(
            indent(&CodeLayout::default(), &[("/.editorconfig", "[*]\nindent_style=tab\n"), root]),
            Indent::Blanks(5)
        );
    }

    #[test]
    fn an_indent_size_can_refer_to_the_tab_width() {
        let file = ("/.editorconfig", "[*.pgx]\nindent_style=space\nindent_size=tab\ntab_width=3\n");
        assert_eq!(indent(&CodeLayout::default(), &[file]), Indent::Blanks(3));
        let broken = ("/.editorconfig", "[*.pgx]\nindent_size=6\n[*.py]\n[[[\n");
        assert_eq!(indent(&CodeLayout::default(), &[broken]), Indent::Blanks(6));
    }
}
