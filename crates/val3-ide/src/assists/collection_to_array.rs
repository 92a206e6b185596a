//! Converts a global collection to an array, if all its keys are literals.

use val3_analysis::items::data;
use val3_analysis::xml::XmlElement;
use val3_lang::types::Container;
use val3_syntax::{TextRange, TextSize};

use super::container_uses::{IndexUse, index_uses};
use super::context::Context;
use super::{AssistKind, Assists};
use crate::RefactoringError;
use crate::edit::{FileEdit, SourceChange};

const ID: &str = "collection-to-array";
const TITLE: &str = "Convert the collection to an array";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let element = data::elements(parse.view()).find(|element| element.tag_range().contains_range(context.range))?;
    let decl = data::declaration(element).filter(|decl| decl.container == Container::Collection && decl.plain)?;
    let values: Vec<XmlElement<'_>> = element.elements().collect();
    let indexes = Indexes::of(&values).filter(|_| !context.is_broken(element.view().range()))?;
    match obstacle(context, &decl.name, &indexes) {
        Ok(uses) => assists.add(ID, AssistKind::Rewrite, TITLE, || {
            let edit = |found: &IndexUse| Some(found.number(indexes.index(&found.text)?));
            let uses: Option<Vec<FileEdit>> = uses.iter().map(edit).collect();
            Some(SourceChange::of(uses?.into_iter().chain(new_element(context, element, &values, &indexes)?)))
        }),
        Err(reason) => assists.refuse(None, ID, AssistKind::Rewrite, TITLE, reason),
    }
    Some(())
}

/// Uses of the collection, or the reason why it cannot be converted.
fn obstacle(context: &Context<'_>, name: &str, indexes: &Indexes) -> Result<Vec<IndexUse>, RefactoringError> {
    let uses = index_uses(context.db, context.project, name)?;
    match uses.iter().find(|found| !found.is_key || indexes.index(&found.text).is_none()) {
        Some(found) => Err(format!("`{name}` has no value with the key `{}` at the start", found.text).into()),
        None => Ok(uses),
    }
}

/// Keys, ordered by array index.
struct Indexes(Vec<String>);

impl Indexes {
    /// Orders the keys. If the keys are exactly the numbers from 0, each key is its index; otherwise the order of the
    /// file counts. `None` if there are no keys or a key occurs twice.
    fn of(values: &[XmlElement<'_>]) -> Option<Self> {
        let keys: Vec<String> =
            values.iter().map(|value| Some(value.value("key")?.into_owned())).collect::<Option<_>>()?;
        let mut sorted = keys.clone();
        sorted.sort();
        sorted.dedup();
        if keys.is_empty() || sorted.len() != keys.len() {
            return None;
        }
        let numbers: Vec<String> = (0..keys.len()).map(|number| number.to_string()).collect();
        let are_numbers = numbers.iter().all(|number| keys.contains(number));
        Some(Self(if are_numbers { numbers } else { keys }))
    }

    fn index(&self, key: &str) -> Option<usize> {
        self.0.iter().position(|known| known == key)
    }
}

/// Edits of the declaration. An array omits default values.
fn new_element(
    context: &Context<'_>,
    element: XmlElement<'_>,
    values: &[XmlElement<'_>],
    indexes: &Indexes,
) -> Option<Vec<FileEdit>> {
    let behind_type = element.attribute("type")?.range.end() + TextSize::of('"');
    let mut edits = vec![
        context.replace(element.attribute("xsi:type")?.range, "array"),
        context.replace(TextRange::empty(behind_type), format!(" size=\"{}\"", indexes.0.len())),
    ];
    if values.iter().all(|value| is_default(*value)) && !leaves_open(context) {
        let end = element.tag_range().end() - TextSize::of('>');
        edits.push(context.replace(TextRange::new(end, element.view().range().end()), " />"));
        return Some(edits);
    }
    for value in values {
        let key = value.attribute("key")?;
        let index = indexes.index(&key.text())?.to_string();
        if is_default(*value) {
            let range = value.view().range();
            let before = context.slice(TextRange::up_to(range.start()));
            let blanks = TextSize::of(before) - TextSize::of(before.trim_end());
            edits.push(context.replace(TextRange::new(range.start() - blanks, range.end()), ""));
        } else if key.text() != index {
            edits.push(context.replace(key.range, index));
        }
    }
    Some(edits)
}

/// Whether data without values have an end tag in this file, as the controller writes them.
fn leaves_open(context: &Context<'_>) -> bool {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let mut empty = data::elements(parse.view()).filter(|element| element.elements().next().is_none()).peekable();
    empty.peek().is_some() && empty.all(|element| element.view().range() != element.tag_range())
}

/// Whether the element contains only the key.
fn is_default(value: XmlElement<'_>) -> bool {
    value.attributes().count() == 1 && value.elements().next().is_none()
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::ID;
    use crate::assists::testing::{check, offered, refused};

    fn listing(code: &str) -> String {
        format!(
            "num nB\n{code}\n=== main/main.dtx\n<Database xmlns:xsi=\"i\">\n  <Datas>\n    <Data na$0me=\"fA\" access=\"private\" xsi:type=\"collection\" type=\"frame\">\n      <Value key=\"pick\" x=\"1\" fatherId=\"world[0]\" />\n      <Value key=\"place\" />\n    </Data>\n    <Data name=\"fB\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n      <Value key=\"0\" fatherId=\"fA[&quot;place&quot;]\" />\n    </Data>\n    <Data name=\"nB\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>\n</Database>\n"
        )
    }

    #[test]
    fn keys_become_indexes_everywhere() {
        check(
            ID,
            &listing("nB=fA[\"place\"].trsf.x\nfA[ \"pick\" ].trsf.x=nB"),
            expect![[r#"
                usrapp/main/main.dtx
                -    <Data name="fA" access="private" xsi:type="collection" type="frame">
                -      <Value key="pick" x="1" fatherId="world[0]" />
                -      <Value key="place" />
                -    </Data>
                -    <Data name="fB" access="private" xsi:type="array" type="frame" size="1">
                -      <Value key="0" fatherId="fA[&quot;place&quot;]" />
                +    <Data name="fA" access="private" xsi:type="array" type="frame" size="2">
                +      <Value key="0" x="1" fatherId="world[0]" />
                +    </Data>
                +    <Data name="fB" access="private" xsi:type="array" type="frame" size="1">
                +      <Value key="0" fatherId="fA[1]" />
                usrapp/main/start.pgx
                -nB=fA["place"].trsf.x
                -fA[ "pick" ].trsf.x=nB
                +nB=fA[1].trsf.x
                +fA[ 0 ].trsf.x=nB
            "#]],
        );
    }

    #[test]
    fn data_without_values_look_like_others() {
        let data = "<Data name=\"nB\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\">\n</Data>\n<Data na$0me=\"nA\" access=\"private\" xsi:type=\"collection\" type=\"num\">\n  <Value key=\"0\" />\n</Data>\n";
        check(
            ID,
            &format!(
                "nA[\"0\"]=1\n=== main/main.dtx\n<Database xmlns:xsi=\"i\">\n<Datas>\n{data}</Datas>\n</Database>\n"
            ),
            expect![[r#"
                usrapp/main/main.dtx
                -<Data name="nA" access="private" xsi:type="collection" type="num">
                -  <Value key="0" />
                +<Data name="nA" access="private" xsi:type="array" type="num" size="1">
                usrapp/main/start.pgx
                -nA["0"]=1
                +nA[0]=1
            "#]],
        );
    }

    #[test]
    fn keys_that_are_indexes_keep_them() {
        let data = "<Data na$0me=\"nA\" access=\"private\" xsi:type=\"collection\" type=\"num\">\n<Value key=\"1\" />\n<Value key=\"0\" />\n</Data>";
        check(
            ID,
            &format!(
                "nA[\"1\"]=1\n=== main/main.dtx\n<Database xmlns:xsi=\"i\">\n<Datas>\n{data}</Datas>\n</Database>\n"
            ),
            expect![[r#"
                usrapp/main/main.dtx
                -<Data name="nA" access="private" xsi:type="collection" type="num">
                -<Value key="1" />
                -<Value key="0" />
                -</Data></Datas>
                +<Data name="nA" access="private" xsi:type="array" type="num" size="2" /></Datas>
                usrapp/main/start.pgx
                -nA["1"]=1
                +nA[1]=1
            "#]],
        );
    }

    #[test]
    fn collections_that_code_needs_stay() {
        for (code, reason) in [
            ("string sA\nsA=first(fA)", "`start.pgx` uses `fA` as a whole, without an index"),
            ("nB=fA[\"p\"+\"ick\"].trsf.x", "`start.pgx` computes an index of `fA`"),
            ("nB=fA[\"other\"].trsf.x", "`fA` has no value with the key `other` at the start"),
            ("delete(fA[\"pick\"])", "`start.pgx` hands over a part of `fA`, not one value"),
            ("if isDefined(fA[\"pick\"])\nendIf", "`start.pgx` hands over a part of `fA`, not one value"),
        ] {
            assert_eq!(refused(&listing(code), ID).as_deref(), Some(reason), "{code}");
        }
    }

    #[test]
    fn empty_collections_and_arrays_are_not_offered() {
        let empty = "put(1)\n=== main/main.dtx\n<Database xmlns:xsi=\"i\"><Datas><Data na$0me=\"nA\" access=\"private\" xsi:type=\"collection\" type=\"num\"/></Datas></Database>";
        assert_eq!((offered(empty, ID), refused(empty, ID)), (None, None));
        assert_eq!(
            offered(&empty.replace("\"collection\" type=\"num\"", "\"array\" type=\"num\" size=\"2\""), ID),
            None
        );
    }
}
