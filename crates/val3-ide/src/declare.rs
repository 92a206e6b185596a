//! Declaring something new: edits that add an entry to a list of a data file or project file.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::manifest::spelling;
use val3_analysis::items::parse;
use val3_analysis::items::project::{data_files, items};
use val3_analysis::xml::{self, Element};
use val3_lang::builtins;
use val3_lang::types::BaseType;
use val3_syntax::view::View;
use val3_syntax::{TextRange, TextSize};

use crate::edit::FileEdit;

/// Global data of a single value, in the first data file of a project. `None` where there is none, or where the old
/// dialect writes values of the type in a longer form.
pub(crate) fn global(db: &dyn Db, project: Project, name: &str, ty: BaseType) -> Option<FileEdit> {
    let file = *data_files(db, project).first()?;
    let parse = parse(db, file);
    let root = xml::root(View::root(parse.green()))?;
    if root.name() == "dataList" {
        let section = root.child(&[format!("{}Section", ty.name()).as_str()])?;
        return Some(entry(db, file, section, &old_datum(name, ty)?));
    }
    let arm = items(db, project).arm.unwrap_or(val3_lang::types::Arm::SixAxis);
    Some(entry(db, file, root.child(&["Datas"])?, &datum(name, &ty.file_name(arm), ty)))
}

/// The lines of a `<Data>`; what hangs on something hangs on what is built in.
fn datum(name: &str, type_name: &str, ty: BaseType) -> Vec<String> {
    let head = format!(r#"<Data name="{name}" access="private" xsi:type="array" type="{type_name}" size="1""#);
    let father = ty.father().and_then(|father| builtins::BUILTINS.iter().find(|builtin| builtin.ty == father));
    match father {
        Some(father) => {
            let value = format!(r#"  <Value key="0" fatherId="{}[0]" />"#, father.name);
            vec![head + ">", value, "</Data>".to_owned()]
        }
        None => vec![head + " />"],
    }
}

/// The lines of an entry of a section of s5 and s6.
fn old_datum(name: &str, ty: BaseType) -> Option<Vec<String>> {
    let value = match ty {
        BaseType::Num => r#"<valueNum index="0" value="0" />"#,
        BaseType::Bool => r#"<valueBool index="0" value="false" />"#,
        BaseType::String => r#"<valueString index="0" value="" />"#,
        ty if ty.is_linkable() => {
            return Some(vec![format!(r#"<{} name="{name}" public="false" size="1" />"#, ty.name())]);
        }
        _ => return None,
    };
    let ty = ty.name();
    Some(vec![format!(r#"<{ty} name="{name}" public="false">"#), format!("  {value}"), format!("</{ty}>")])
}

/// A library identifier with the path of its interface.
pub(crate) fn library(db: &dyn Db, project: Project, alias: &str, path: &str) -> Option<FileEdit> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let root = xml::root(View::root(parse.green()))?;
    let spelling = spelling(root);
    let (list, item) = spelling.libraries;
    let line = format!(r#"<{item} {}="{alias}" {}="{path}" />"#, spelling.library_name, spelling.library_path);
    match root.child(&[list]) {
        Some(list) => Some(entry(db, file, list, &[line])),
        None => Some(entry(db, file, root, &[format!("<{list}>"), format!("  {line}"), format!("</{list}>")])),
    }
}

/// Adds an entry behind the last one of a list, indented as that one is.
fn entry(db: &dyn Db, file: File, list: Element<'_>, lines: &[String]) -> FileEdit {
    let text: &str = file.text(db);
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let outer = indent(text, list.view().range().start());
    let last = list.elements().last().map(|last| last.view().range());
    let inner = last.map_or_else(|| format!("{outer}  "), |last| indent(text, last.start()).to_owned());
    let added: String = lines.iter().map(|line| format!("{end}{inner}{line}")).collect();
    let tag = list.tag_range();
    let head = text.get(std::ops::Range::<usize>::from(tag)).unwrap_or("");
    match (last, head.strip_suffix("/>")) {
        (Some(last), _) => FileEdit { file, range: TextRange::empty(last.end()), text: added },
        (None, Some(open)) => {
            let text = format!("{}>{added}{end}{outer}</{}>", open.trim_end(), list.name());
            FileEdit { file, range: tag, text }
        }
        (None, None) => {
            let rest = text.get(usize::from(tag.end())..).unwrap_or("").trim_start_matches([' ', '\t']);
            let behind = if rest.starts_with(['\r', '\n']) { String::new() } else { format!("{end}{outer}") };
            FileEdit { file, range: TextRange::empty(tag.end()), text: added + &behind }
        }
    }
}

/// The blanks at the start of the line of an offset.
fn indent(text: &str, offset: TextSize) -> &str {
    let before = text.get(..usize::from(offset)).unwrap_or("");
    let line = before.rsplit(['\n', '\r']).next().unwrap_or("");
    let blanks = line.len() - line.trim_start_matches([' ', '\t']).len();
    line.get(..blanks).unwrap_or("")
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::Marked;

    fn check(listing: &str, edit: impl FnOnce(&dyn Db, Project) -> Option<FileEdit>, expected: Expect) {
        let marked = Marked::new(listing);
        let db = marked.db();
        let project = crate::owner(db, marked.at().file).unwrap();
        let shown = edit(db, project).map_or_else(String::new, |edit| {
            let mut text = edit.file.text(db).to_string();
            text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
            assert!(val3_syntax::parse(&text).errors().is_empty());
            text.lines().skip(2).map(|line| format!("{line}\n")).collect()
        });
        expected.assert_eq(&shown);
    }

    #[test]
    fn data() {
        let num = |db: &dyn Db, project| global(db, project, "nA", BaseType::Num);
        let point = |db: &dyn Db, project| global(db, project, "pA", BaseType::Point);
        check(
            "cls()$0",
            num,
            expect![[r#"
              <Datas>
                <Data name="nA" access="private" xsi:type="array" type="num" size="1" />
              </Datas>
            </Database>
        "#]],
        );
        check(
            "num nB\ncls()$0",
            point,
            expect![[r#"
              <Datas>
                <Data name="nB" access="private" xsi:type="array" type="num" size="1" />
                <Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" fatherId="world[0]" />
                </Data>
              </Datas>
            </Database>
        "#]],
        );
        check(
            "cls()$0\n=== main/main.dtx\n<?xml version=\"1.0\"?>\n<Database>\n<Datas></Datas>\n</Database>",
            num,
            expect![[r#"
            <Datas>
              <Data name="nA" access="private" xsi:type="array" type="num" size="1" />
            </Datas>
            </Database>
        "#]],
        );
        check(
            "cls()$0\n=== main/main.dtx\n<?xml version=\"1.0\"?>\n<dataList>\n<numSection />\n</dataList>",
            num,
            expect![[r#"
                <numSection>
                  <num name="nA" public="false">
                    <valueNum index="0" value="0" />
                  </num>
                </numSection>
                </dataList>
            "#]],
        );
    }

    #[test]
    fn libraries() {
        let part = |db: &dyn Db, project| library(db, project, "part", "Disk://part/part.pjx");
        check(
            "cls()$0",
            part,
            expect![[r#"
              <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
              <Programs>
                <Program file="start.pgx" />
              </Programs>
              <Database>
                <Data file="main.dtx" />
              </Database>
              <Libraries>
                <Library alias="part" path="Disk://part/part.pjx" />
              </Libraries>
              <Types />
            </Project>
        "#]],
        );
    }
}
