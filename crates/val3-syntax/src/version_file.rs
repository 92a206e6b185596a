//! Software versions of a controller (`val3version.xml`).

use crate::xml;

/// Returns the VAL 3 version in the file, for example `s8.10.2Cs9_BS1991`.
///
/// ```
/// let text = r#"<Versions><Version name="val3" compatibility="7">s7.8.3</Version></Versions>"#;
/// assert_eq!(val3_syntax::version_file::language(text).as_deref(), Some("s7.8.3"));
/// ```
#[must_use]
pub fn language(text: &str) -> Option<String> {
    let parse = crate::parse(text);
    let root = xml::root(parse.view())?;
    let version = root.elements().find(|element| element.value("name").as_deref() == Some("val3"))?;
    let element = text.get(std::ops::Range::<usize>::from(version.view().range()))?;
    let (_, content) = element.split_once('>')?;
    Some(content.split('<').next()?.trim().to_owned())
}
