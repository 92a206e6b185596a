//! Converts a global array to a collection whose keys are the indexes.

use val3_analysis::items::data::{self, DataDecl};
use val3_analysis::xml::XmlElement;
use val3_lang::types::Container;
use val3_syntax::xml::{indentation, line_end};
use val3_syntax::{TextRange, TextSize, TextSlice};

use super::container_uses::{IndexUse, index_uses};
use super::context::Context;
use super::{AssistKind, Assists};
use crate::RefactoringError;
use crate::edit::{FileEdit, SourceChange};

const ID: &str = "array-to-collection";
const TITLE: &str = "Convert the array to a collection";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let element = data::elements(parse.view()).find(|element| element.tag_range().contains_range(context.range))?;
    let decl = data::declaration(element).filter(|decl| decl.container == Container::Array { dims: 1 })?;
    let size = decl.sizes.first().copied().filter(|_| decl.plain && element.name() == "Data")?;
    match obstacle(context, element, &decl, size) {
        // A single value is rarely meant as a container, unless code uses it with an index.
        Ok(uses) if size == 1 && uses.is_empty() => {}
        Err(_) if size == 1 => {}
        Ok(uses) => assists.add(ID, AssistKind::Rewrite, TITLE, || {
            let edits = uses.iter().map(IndexUse::key).chain(new_element(context, element, size)?);
            Some(SourceChange::of(edits))
        }),
        Err(reason) => assists.refuse(None, ID, AssistKind::Rewrite, TITLE, reason),
    }
    Some(())
}

/// Uses of the array, or the reason why it cannot be converted.
fn obstacle(
    context: &Context<'_>,
    element: XmlElement<'_>,
    decl: &DataDecl,
    size: u32,
) -> Result<Vec<IndexUse>, RefactoringError> {
    let name = &decl.name;
    if context.is_broken(element.view().range()) || present(element, size).is_none() {
        return Err(format!("the values of `{name}` are not in the order of their indexes").into());
    }
    let uses = index_uses(context.db, context.project, name)?;
    match uses.iter().find(|found| found.is_key || number(&found.text).is_none_or(|index| index >= size)) {
        Some(found) => Err(format!("`{name}` has no value with the index `{}`", found.text).into()),
        None => Ok(uses),
    }
}

/// Parses a number in the spelling that files use for indexes.
fn number(text: &str) -> Option<u32> {
    text.parse().ok().filter(|number: &u32| number.to_string() == text)
}

/// Values in the file, with their indexes in ascending order; `None` if they are in another order or have other keys.
fn present(element: XmlElement<'_>, size: u32) -> Option<Vec<(u32, TextRange)>> {
    let present: Vec<_> = element.elements().map(|value| indexed(value, size)).collect::<Option<_>>()?;
    present.is_sorted_by(|(one, _), (next, _)| one < next).then_some(present)
}

/// Index and range of an array value; `None` for another element, or if the index is not below `size`.
fn indexed(value: XmlElement<'_>, size: u32) -> Option<(u32, TextRange)> {
    let index = number(&value.value("key")?).filter(|index| *index < size && value.name() == "Value")?;
    Some((index, value.view().range()))
}

/// Edits of the declaration. A collection must contain all its values.
fn new_element(context: &Context<'_>, element: XmlElement<'_>, size: u32) -> Option<Vec<FileEdit>> {
    let mut edits = vec![context.replace(element.attribute("xsi:type")?.range, "collection")];
    if let Some(found) = element.attribute("size") {
        edits.push(context.replace(with_blanks(context.text, found.name_range, found.range), ""));
    }
    let present = present(element, size)?;
    let missing = |from: u32, to: u32| (from..to).map(|index| format!("<Value key=\"{index}\" />"));
    let Some((first, before)) = present.first() else {
        edits.push(all(context, element, missing(0, size)));
        return Some(edits);
    };
    let separator = line_break(context.text, *before);
    let added: String = missing(0, *first).map(|value| value + &separator).collect();
    edits.push(context.replace(TextRange::empty(before.start()), added));
    let next = present.iter().skip(1).map(|(index, _)| *index).chain([size]);
    for ((index, range), next) in present.iter().zip(next) {
        let separator = line_break(context.text, *range);
        let added: String = missing(index + 1, next).map(|value| separator.clone() + &value).collect();
        edits.push(context.replace(TextRange::empty(range.end()), added));
    }
    edits.retain(|edit| !(edit.range.is_empty() && edit.text.is_empty()));
    Some(edits)
}

/// Line end and indentation before a value at the start of a line; empty for a value after others in a line.
fn line_break(text: &str, value: TextRange) -> String {
    match indentation(text, value.start()) {
        Some(blanks) => format!("{}{blanks}", line_end(text)),
        None => String::new(),
    }
}

/// Edit that adds all values to an element without values.
fn all(context: &Context<'_>, element: XmlElement<'_>, values: impl Iterator<Item = String>) -> FileEdit {
    let tag = element.tag_range();
    let outer = indentation(context.text, tag.start());
    let separator = outer.map_or_else(String::new, |outer| format!("{}{outer}", line_end(context.text)));
    let level = if outer.is_some() { "  " } else { "" };
    let lines: String = values.map(|value| format!("{separator}{level}{value}")).collect();
    let end = if element.view().range() == tag { tag.end() } else { element.view().range().end() };
    let text = context.slice(tag);
    let head = text.trim_end_matches(['/', '>']).trim_end_matches([' ', '\t', '\r', '\n']);
    let start = tag.start() + TextSize::of(head);
    context.replace(TextRange::new(start, end), format!(">{lines}{separator}</{}>", element.name()))
}

/// Attribute range, with the whitespace before it.
fn with_blanks(text: &str, name: TextRange, value: TextRange) -> TextRange {
    let before = text.part(..usize::from(name.start()));
    let blanks = TextSize::of(before) - TextSize::of(before.trim_end());
    TextRange::new(name.start() - blanks, value.end() + TextSize::of('"'))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::ID;
    use crate::assists::testing::{check, offered, refused};

    /// An array with three values, and its uses.
    fn listing(code: &str) -> String {
        format!(
            "num nB\n{code}\n=== main/main.dtx\n<Database xmlns:xsi=\"i\">\n  <Datas>\n    <Data na$0me=\"fA\" access=\"public\" xsi:type=\"array\" type=\"frame\" size=\"3\">\n      <Value key=\"1\" x=\"1\" fatherId=\"world[0]\" />\n    </Data>\n    <Data name=\"fB\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n      <Value key=\"0\" fatherId=\"fA[2]\" />\n    </Data>\n    <Data name=\"nB\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>\n</Database>\n"
        )
    }

    #[test]
    fn indexes_become_keys_everywhere() {
        check(
            ID,
            &listing("nB=fA[0].trsf.x\nfA[ 1 ].trsf.x=nB"),
            expect![[r#"
                usrapp/main/main.dtx
                -    <Data name="fA" access="public" xsi:type="array" type="frame" size="3">
                -      <Value key="1" x="1" fatherId="world[0]" />
                -    </Data>
                -    <Data name="fB" access="private" xsi:type="array" type="frame" size="1">
                -      <Value key="0" fatherId="fA[2]" />
                +    <Data name="fA" access="public" xsi:type="collection" type="frame">
                +      <Value key="0" />
                +      <Value key="1" x="1" fatherId="world[0]" />
                +      <Value key="2" />
                +    </Data>
                +    <Data name="fB" access="private" xsi:type="array" type="frame" size="1">
                +      <Value key="0" fatherId="fA[&quot;2&quot;]" />
                usrapp/main/start.pgx
                -nB=fA[0].trsf.x
                -fA[ 1 ].trsf.x=nB
                +nB=fA["0"].trsf.x
                +fA[ "1" ].trsf.x=nB
            "#]],
        );
    }

    #[test]
    fn libraries_and_escaped_code_are_edited() {
        let part = "--- part\nprogram other()\nbegin\n  nA[0]=1\nend\n=== part/part.dtx\n<Database xmlns:xsi=\"i\"><Datas><Data name=\"nA\" acc$0ess=\"public\" xsi:type=\"array\" type=\"num\" size=\"2\"/></Datas></Database>\n=== part/other.pgx\n<Programs><Program name=\"other\"><Code>begin\nnA[0]=1\nend</Code></Program></Programs>";
        check(
            ID,
            &format!("library part \"Disk://part/part.pjx\"\nnum nB\nnB=part:nA[1]\n{part}"),
            expect![[r#"
                usrapp/main/start.pgx
                -nB=part:nA[1]
                +nB=part:nA["1"]
                usrapp/part/other.pgx
                -nA[0]=1
                +nA[&quot;0&quot;]=1
                usrapp/part/part.dtx
                -<Database xmlns:xsi="i"><Datas><Data name="nA" access="public" xsi:type="array" type="num" size="2"/></Datas></Database>
                +<Database xmlns:xsi="i"><Datas><Data name="nA" access="public" xsi:type="collection" type="num"><Value key="0" /><Value key="1" /></Data></Datas></Database>
            "#]],
        );
    }

    #[test]
    fn arrays_that_code_needs_stay() {
        for (code, reason) in [
            ("nB=size(fA)", "`start.pgx` uses `fA` as a whole, without an index"),
            ("nB=fA[nB].trsf.x", "`start.pgx` computes an index of `fA`"),
            ("nB=fA[3].trsf.x", "`fA` has no value with the index `3`"),
            ("nB=fA[01].trsf.x", "`fA` has no value with the index `01`"),
            ("insert(fA[1],1)", "`start.pgx` hands over a part of `fA`, not one value"),
            (
                "call other(fA[1])\nprogram other(frame& x_f[])\nbegin\nend",
                "`start.pgx` hands over a part of `fA`, not one value",
            ),
            (
                "getData(\"fA[1]\",nB)",
                "a program may read `fA` by its name, as a text, or is not listed in the project",
            ),
            ("nB=fA[1].trsf.x\n)(", "`start.pgx` has a syntax error"),
        ] {
            assert_eq!(refused(&listing(code), ID).as_deref(), Some(reason), "{code}");
        }
    }

    #[test]
    fn interfaces_and_user_types_stay() {
        let part = "--- part\n=== part/part.dtx\n<Database xmlns:xsi=\"i\"><Datas><Data name=\"nA\" acc$0ess=\"public\" xsi:type=\"array\" type=\"num\" size=\"2\"/></Datas></Database>";
        let loaded = format!(
            "library part \"Disk://part/part.pjx\" autoload=false\nnum nB\nnB=part:libLoad(\"Disk://box\")\n{part}\n--- box\npublic num nA[2]"
        );
        assert_eq!(refused(&loaded, ID).as_deref(), Some("`nA` is part of an interface"));
        let field = format!("type part \"Disk://part/part.pjx\"\npart tA\ntA.nA[0]=1\n{part}");
        assert_eq!(refused(&field, ID).as_deref(), Some("the fields of user types are arrays"));
    }

    #[test]
    fn single_values_and_the_old_dialect_are_not_offered() {
        let single = listing("nB=1").replace("na$0me=\"fA\"", "name=\"fA\"").replace("name=\"nB\"", "na$0me=\"nB\"");
        assert_eq!((offered(&single, ID), refused(&single, ID)), (None, None));
        let unused = single.replace("nB=1", "put(1)");
        assert_eq!((offered(&unused, ID), refused(&unused, ID)), (None, None));
        assert!(offered(&single.replace("nB=1", "nB[0]=1"), ID).is_some());
        let old = "put(nA[1])\n=== main/main.dtx\n<dataList><numSection><num na$0me=\"nA\" public=\"false\"><valueNum index=\"0\" value=\"1\"/><valueNum index=\"1\" value=\"1\"/></num></numSection></dataList>";
        assert_eq!(offered(old, ID), None);
    }
}
